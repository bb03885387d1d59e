#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the missing packages of a list; changes nothing when none is missing. If it cannot install, it lists what is
# missing and exits without an error; the build then fails if a package is needed.
#   scripts/install-packages.sh [LIST]    packages.txt, beside this script, when not given
# A line of the list is a package, or "PACKAGE unless COMMAND": that one is installed where the command is not there.
set -euo pipefail
list=${1:-$(dirname "${BASH_SOURCE[0]}")/packages.txt}

installed() { [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

if ! command -v dpkg-query >/dev/null; then
  echo "This is not a Debian system: install what $list lists by your own means."
  exit 0
fi
missing=()
while read -r package unless command; do
  [ "$unless" != unless ] || ! command -v "$command" >/dev/null || continue
  installed "$package" || missing+=("$package")
done < <(grep -v '^#' "$list")
if [ ${#missing[@]} -eq 0 ]; then
  echo "All packages of $list are installed."
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
  if ! command -v sudo >/dev/null; then
    echo "Missing, and neither root nor sudo to install them: ${missing[*]}"
    exit 0
  fi
fi
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@"; }
install() { apt install --yes --no-install-recommends "${missing[@]}"; }

echo "Installing: ${missing[*]}"
# The first try fails when apt's package lists are outdated or missing; only then are they updated.
install 2>/dev/null || { apt update && install; } || echo "Could not install: ${missing[*]}"

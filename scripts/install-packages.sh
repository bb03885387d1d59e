#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the packages of a list that are missing; touches nothing when none is. Without the means to install, it says
# what is missing and leaves it to the build to tell whether that matters.
#   scripts/install-packages.sh [LIST]    packages.txt, beside this script, when not given
set -euo pipefail
list=${1:-$(dirname "${BASH_SOURCE[0]}")/packages.txt}

installed() { [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

if ! command -v dpkg-query >/dev/null; then
  echo "This is not a Debian system: install what $list lists by your own means."
  exit 0
fi
missing=()
while read -r package; do
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
# Stale package lists fail the first try, missing ones too; only then are they fetched.
install 2>/dev/null || { apt update && install; } || echo "Could not install: ${missing[*]}"

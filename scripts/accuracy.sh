#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures how close every method comes to the floor on the shipped twins and prints one Markdown table a noise level.
# Needs nothing but this checkout on Debian 12; ten seeds take some minutes. With --write the tables take the place of
# those in docs/accuracy.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() { printf 'usage: scripts/accuracy.sh [--write] [SEEDS]\n'; }
write=false
seeds=10
for argument; do
  case $argument in
    --write) write=true ;;
    -h | --help) usage && exit 0 ;;
    *[!0-9]* | '' | 0) usage >&2 && exit 2 ;;
    *) seeds=$argument ;;
  esac
done

{
  say "Packages"
  scripts/install-packages.sh
  say "Building"
  configure release -DPROOFMASS_BUILD_BENCHMARKS=ON
  build release --target accuracy
} >&2

# The last column, seconds, says more of the machine than of the method.
tables=build/accuracy.md
for twin in twin twin-10ug twin-300ug; do
  build/release/bin/accuracy "data/$twin.toml" "$seeds"
done | sed -E '/^\|/s/[^|]*\|$//' | tee "$tables"

if "$write"; then renew_tables docs/accuracy.md "$tables"; fi

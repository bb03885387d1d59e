#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the speed of the hot paths with other libraries (the peers), in the same run, on the same data and starts,
# one thread each, and prints the tables of BENCHMARKS.md. It fails when the results of a contestant are not what it
# reports. It needs only this checkout on Debian 12; after the build it takes a quarter of an hour, with --quick two
# minutes.
#   --write      writes the figures to benchmarks/results and, without --target, the tables to BENCHMARKS.md
#   --target T   forces our kernels to sse4, avx2 or avx3; the peers keep their fastest build
#   --sections   measures some of forward, epoch, quality, growth, hidden, least_squares, reading, end_to_end
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() { printf 'usage: scripts/bench.sh [--quick] [--write] [--target sse4|avx2|avx3] [--sections NAME,...]\n'; }
write=false target='' sections=''
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --quick) options+=("$1") ;;
    --write) write=true ;;
    --target | --sections)
      [ $# -gt 1 ] || { usage >&2 && exit 2; }
      if [ "$1" = --target ]; then target=$2; else sections=$2; fi
      options+=("$1" "$2") && shift
      ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
  shift
done
case $target in '' | sse4 | avx2 | avx3) ;; *) usage >&2 && exit 2 ;; esac
# --write needs all sections: a part of the figures must not replace the whole set.
if "$write" && [ -n "$sections" ]; then usage >&2 && exit 2; fi

{
  say "Packages"
  scripts/install-packages.sh
  scripts/install-packages.sh scripts/bench-packages.txt
  say "Building"
  configure release -DPROOFMASS_BUILD_BENCHMARKS=ON -DPROOFMASS_BUILD_PEERS=ON
  build release
} >&2

mkdir -p build/bench
tables=build/bench/tables.md figures=build/bench/figures.json status=0
# Use Debian's Python and its packages for the peers, even when another python3 comes first on the PATH.
PYTHONPATH=benchmarks PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m bench --build build/release --json "$figures" \
  --tables "$tables" "${options[@]}" || status=$?
[ "$status" -le 1 ] || exit "$status"
cat "$tables"

if "$write"; then
  [ -n "$target" ] || renew_tables BENCHMARKS.md "$tables"
  machine=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | head -n 1 | tr -cs '[:alnum:]\n' - |
    tr '[:upper:]' '[:lower:]')
  cp "$figures" "benchmarks/results/$(date +%F)-${machine:-machine}${target:+-$target}.json"
fi
exit "$status"

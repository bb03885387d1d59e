#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the hot paths against the libraries an engineer could pick instead, in the same run, on the same data and
# starts, one thread each, and prints the tables of BENCHMARKS.md; fails when a contestant did not reach what it says.
# Needs nothing but this checkout on Debian 12; a quarter of an hour, with --quick two minutes, after the build.
#   --write      figures go to benchmarks/results, the tables of a whole run with nothing forced to BENCHMARKS.md
#   --target T   forces the kernels of ours to sse4, avx2 or avx3; peers stay at their best
#   --sections   some of forward, epoch, quality, growth, hidden, least_squares, reading, end_to_end
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
# Part of the figures must not take the place of all of them.
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
# The peers in Python are Debian's, whatever python3 comes first on the PATH.
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

# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Functions that the other scripts share; they source this file.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
reference_data=${PROOFMASS_REFERENCE_DATA:-$root/../shared/data}
[[ $reference_data == /* ]] || reference_data=$PWD/$reference_data
cd "$root"

say() { printf '\n== %s\n' "$*"; }
run() { printf '+ %s\n' "$*" && "$@"; }

# configure PRESET [CMAKE OPTION…]: configures build/PRESET. A folder that was configured for another checkout is
# configured afresh. The generator is chosen only when the folder has none yet.
configure() {
  local preset=$1 cache=build/$1/CMakeCache.txt generator=()
  shift
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    generator=(--fresh)
    ! command -v ninja >/dev/null || generator+=(-G Ninja)
  fi
  run cmake --preset "$preset" "${generator[@]}" -DPROOFMASS_REFERENCE_DATA="$reference_data" "$@"
}

build() { run cmake --build "build/$1" --parallel "$(nproc)" "${@:2}"; }

# prepare_tables PROGRAM [--write] [SEEDS]: reads the arguments of a measuring script into `write` and `seeds` (`seeds`
# keeps its value when it is not given) and builds benchmarks/PROGRAM.
# shellcheck disable=SC2034  # write and seeds are the caller's
prepare_tables() {
  local program=$1 argument
  local usage="usage: scripts/$program.sh [--write] [SEEDS]"
  write=false
  for argument in "${@:2}"; do
    case $argument in
      --write) write=true ;;
      -h | --help) printf '%s\n' "$usage" && exit 0 ;;
      *[!0-9]* | '' | 0) printf '%s\n' "$usage" >&2 && exit 2 ;;
      *) seeds=$argument ;;
    esac
  done
  {
    say "Packages"
    scripts/install-packages.sh
    say "Building"
    configure release -DPROOFMASS_BUILD_BENCHMARKS=ON
    build release --target "${program//-/_}"
  } >&2
}

# renew_tables FILE TABLES: replaces the text between the markers of FILE by the text of TABLES.
renew_tables() {
  sed -i -e "/^<!-- tables -->$/,/^<!-- end of tables -->$/{/^<!-- tables -->$/r $2
    /^<!-- /!d}" "$1"
  # Put a blank line between the last table and the marker.
  sed -i 's/^<!-- end of tables -->$/\n&/' "$1"
  printf 'The tables of %s are renewed.\n' "$1" >&2
}

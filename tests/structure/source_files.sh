#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks that every source file names its licence and has a snake_case name, that headers have #pragma once, that every
# source has a header beside it, and that a folder holds at most 16 units (header, source and test count as one).
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}"

bad=0
complain() { printf '%s\n' "$*" && bad=1; }

while read -r file; do
  head -n 2 "$file" | grep -qF 'SPDX-License-Identifier: Apache-2.0' || complain "$file: names no licence"
  [[ $file != *.hpp ]] || grep -qx '#pragma once' "$file" || grep -q 'HWY_TARGET_TOGGLE' "$file" ||
    complain "$file: no #pragma once"
  name=$(basename "$file")
  [[ $name == CMakeLists.txt || $name =~ ^(Proofmass[A-Za-z]*\.cmake|[a-z0-9_]+(-[a-z0-9]+)*\.[a-z]+|run)$ ]] ||
    complain "$file: name it in lower case, words joined by _"
done < <(find proofmass apps benchmarks examples tests scripts cmake .ci -type f \
  \( -name '*.[ch]pp' -o -name '*.sh' -o -name '*.cmake' -o -name CMakeLists.txt -o -path '.ci/*' \))

# Names that the language keeps for the compiler; those that it defines are ours to use.
while read -r place; do
  complain "$place: this name is reserved for the compiler"
done < <(grep -rnoE '\b(_[A-Z][A-Za-z0-9_]*|[A-Za-z0-9_]*__[A-Za-z0-9_]*)' --include='*.[ch]pp' proofmass apps benchmarks \
  examples tests | grep -vE ':(__(FILE|LINE|cplusplus|GNUC|clang|AVX512F|SANITIZE|builtin|extension__|int128|$)[A-Za-z0-9_]*|_SC_[A-Z_]*)$' || true)

# has_header FILE: true when there is a header of its name, of a shorter name that its name extends (term.hpp for
# term_names.cpp), or of the folder's name (verbs).
has_header() {
  local folder=${1%/*} stem
  stem=$(basename "$1" .cpp)
  while [ -n "$stem" ]; do
    [ ! -e "$folder/$stem.hpp" ] && [ ! -e "$folder/${stem}_internal.hpp" ] || return 0
    [[ $stem == *_* ]] || break
    stem=${stem%_*}
  done
  [ -e "$folder/${folder##*/}.hpp" ]
}
while read -r file; do
  has_header "$file" || complain "$file: no header of that name, nor one that it is named after"
done < <(find proofmass apps -name '*.cpp' ! -name '*_test.cpp' ! -name main.cpp)

most=16
while read -r units folder; do
  [ "$units" -le $most ] || complain "$folder: $units units, more than $most"
done < <(find proofmass apps -name '*.[ch]pp' | sed -E 's/(_test|_internal|-inl)?\.[ch]pp$//' | sort -u |
  sed 's|/[^/]*$||' | sort | uniq -c)
exit $bad

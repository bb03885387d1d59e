#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks which module may include which (docs/design-of-the-code.md), that no folders include one another in a circle,
# and that public headers name no other library. Tests are not checked: a test may include whatever it needs.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}"

# "pipeline" stands for the files at the root: pipeline, split and the overview header.
declare -A allowed=(
  [core]="core"
  [files]="core files"
  [numeric]="numeric"
  [record]="core files record"
  [stand]="core files numeric record stand"
  [identify]="core numeric stand identify"
  [assess]="core numeric stand identify assess"
  [pipeline]="core files numeric record stand identify assess pipeline"
  [study]="core files numeric record stand identify assess pipeline study"
  [report]="core files assess study report"
)
bad=0
complain() { printf '%s\n' "$*" && bad=1; }

# own_includes FILE: prints the path of each include in quotes, and of the project's headers in angle brackets.
own_includes() {
  sed -nE -e 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*"([^"]*)".*/\1/p' \
    -e 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*<((proofmass|support)\/[^>]*)>.*/\1/p' "$1"
}

edges=$(mktemp)
trap 'rm -f "$edges"' EXIT

check_file() {
  local module=$1 file=$2 include target
  while read -r include; do
    case $include in
      *..*) complain "$file: includes \"$include\"; write the path without .." && continue ;;
      proofmass/*/*) target=${include#proofmass/} target=${target%%/*} ;;
      proofmass/*) target=pipeline ;;
      support/*) target=tests ;;
      *) complain "$file: includes \"$include\"; write the whole path, \"proofmass/...\"" && continue ;;
    esac
    [[ " ${allowed[$module]} " == *" $target "* ]] || complain "$file: $module must not include $include"
    [ "${include%/*}" = "${file%/*}" ] || printf '%s %s\n' "${file%/*}" "${include%/*}" >>"$edges"
  done < <(own_includes "$file")
}

sources() { find "$@" -type f -regex '.*\.\(c\|cc\|cpp\|cpp\.in\|h\|hpp\|inc\)' ! -name '*_test.cpp'; }

for folder in proofmass/*/; do
  module=$(basename "$folder")
  [ -n "${allowed[$module]-}" ] || { complain "$folder: a module that the include graph does not know" && continue; }
  while read -r file; do check_file "$module" "$file"; done < <(sources "$folder")
done
# proofmass.hpp is for users; no file of the library may include it.
while read -r file; do
  [ "$file" = proofmass/proofmass.hpp ] || check_file pipeline "$file"
done < <(sources proofmass -maxdepth 1)
if found=$(grep -rlE '#[[:space:]]*include[[:space:]]*["<]proofmass/proofmass\.hpp' proofmass --include='*.[ch]pp'); then
  complain "includes the overview header, which is for programs: $found"
fi

# Sort the folders so that each includes only folders before it. tsort fails when there is a circle.
if ! circle=$(sort -u "$edges" | tsort 2>&1 >/dev/null); then
  complain "these folders include one another in a circle: $(sed -n 's/^tsort: \(proofmass.*\)/\1/p' <<<"$circle" |
    paste -sd ' ')"
fi

mapfile -t public_headers < <(find proofmass -name '*.hpp' ! -name '*-inl.hpp' ! -name '*_internal.hpp')
while read -r line; do
  complain "a public header names another library: $line"
done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<[^>]*[/.]' "${public_headers[@]}" |
  grep -vE '<(stdint|stddef)\.h>' || true)
while read -r line; do
  complain "a public header includes an internal one: $line"
done < <(grep -nE '#[[:space:]]*include.*(-inl|_internal)\.hpp' "${public_headers[@]}" || true)
while read -r line; do
  complain "programs use public headers only: $line"
done < <(grep -rnE '#[[:space:]]*include.*(-inl|_internal)\.hpp' apps examples --include='*.[ch]pp' || true)
exit $bad

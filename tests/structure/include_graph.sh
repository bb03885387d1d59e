#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which module may include which (docs/design-of-the-code.md), and that public headers name no other library. The graph
# is that of the product: a test may include what it needs to test with.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}"

declare -A allowed=(
  [core]="core"
  [numeric]="numeric"
  [record]="core record"
  [stand]="core numeric stand"
  [identify]="core numeric stand identify"
  [assess]="core numeric identify assess"
  [report]="core assess report"
)
bad=0
complain() { printf '%s\n' "$*" && bad=1; }

# own_includes FILE: the path of each include in quotes, and of those in angle brackets that are ours.
own_includes() {
  sed -nE -e 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*"([^"]*)".*/\1/p' \
    -e 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*<((proofmass|support)\/[^>]*)>.*/\1/p' "$1"
}

check_module() {
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
  done < <(own_includes "$file")
}

for folder in proofmass/*/; do
  module=$(basename "$folder")
  [ -n "${allowed[$module]-}" ] || { complain "$folder: a module that the include graph does not know" && continue; }
  while read -r file; do
    check_module "$module" "$file"
  done < <(find "$folder" -type f -regex '.*\.\(c\|cc\|cpp\|cpp\.in\|h\|hpp\|inc\)' ! -name '*_test.cpp')
done

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

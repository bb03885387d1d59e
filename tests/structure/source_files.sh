#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every source file names its licence, has a snake_case name and, when it is a header, says #pragma once.
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
exit $bad

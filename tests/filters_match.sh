#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# filters_match.sh PROGRAM FILTER…: that every filter by which CMake labels tests still matches one. A test that was
# renamed would otherwise lose its label, and with it the sanitizer that runs it, without a word.
set -euo pipefail
program=$1
bad=0
for filter in "${@:2}"; do
  "$program" --gtest_list_tests --gtest_filter="$filter" | grep -q '^  ' ||
    { printf "%s: no test matches '%s'\n" "$(basename "$program")" "$filter" && bad=1; }
done
exit $bad

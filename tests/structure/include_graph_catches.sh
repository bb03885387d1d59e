#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests include_graph.sh: it must find every kind of violation, and pass what is allowed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
bad=0

# try WANTED FILE LINE…: checks a tree with this one file, which holds these lines; WANTED is passes or fails.
try() {
  local wanted=$1 file=$tree/$2 found=passes
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{apps,examples,proofmass/core} "$(dirname "$file")"
  echo '#pragma once' >"$tree/proofmass/core/unit.hpp"
  printf '%s\n' "${@:3}" >"$file"
  for ((k = 0; k < ${#more[@]}; k += 2)); do
    mkdir -p "$(dirname "$tree/${more[k]}")"
    printf '%s\n' "${more[k + 1]}" >"$tree/${more[k]}"
  done
  more=()
  bash "$here/include_graph.sh" "$tree" >/dev/null || found=fails
  [ "$found" = "$wanted" ] || { printf '%s with %s %s\n' "$2" "${*:3}" "$found" && bad=1; }
}

# also FILE LINE…: adds a file to the tree of the next try.
declare -a more=()
also() { more+=("$1" "$2"); }

try passes proofmass/core/term.cpp '#include <vector>' '#include "proofmass/core/term.hpp"'
try passes proofmass/report/json.cpp '#include "proofmass/core/term.hpp"' '#include <nlohmann/json.hpp>'
try passes proofmass/core/term_test.cpp '#include "proofmass/report/json/json.hpp"'
try fails proofmass/core/term.cpp '#include "proofmass/report/json/json.hpp"'
try fails proofmass/core/term.cpp '#include <proofmass/report/json/json.hpp>'
try fails proofmass/core/term.cpp '  #  include <support/twin.hpp>'
try fails proofmass/core/term.cpp '#include "proofmass/core/../report/json.hpp"'
try fails proofmass/core/term.cpp '#include "term.hpp"'
try fails proofmass/core/term.cpp '#include "proofmass/pipeline.hpp"'
try fails proofmass/core/sub/x.cpp '#include "proofmass/report/json/json.hpp"'
try fails proofmass/core/sub/deep/x.hpp '#include <proofmass/report/json/json.hpp>'
also proofmass/numeric/a/x.hpp '#include "proofmass/numeric/b/y.hpp"'
try passes proofmass/numeric/b/y.hpp '#include "proofmass/numeric/b/z.hpp"'
also proofmass/numeric/a/x.hpp '#include "proofmass/numeric/b/y.hpp"'
try fails proofmass/numeric/b/y.hpp '#include "proofmass/numeric/a/z.hpp"'
also proofmass/numeric/a/x.hpp '#include "proofmass/numeric/top.hpp"'
try fails proofmass/numeric/top.cpp '#include "proofmass/numeric/a/x.hpp"'
try fails proofmass/record/x.cpp '#include "proofmass/proofmass.hpp"'
try fails proofmass/assess/x.cpp '#include "proofmass/split.hpp"'
try passes proofmass/study/x.cpp '#include "proofmass/split.hpp"'
try passes proofmass/split.cpp '#include "proofmass/numeric/random.hpp"'
try fails proofmass/split.cpp '#include "proofmass/study/compare.hpp"'
try fails proofmass/other/x.cpp '#include <vector>'
try fails proofmass/core/term.hpp '#include <fmt/format.h>'
try fails apps/x.cpp '#include "proofmass/report/json/node_internal.hpp"'
exit $bad

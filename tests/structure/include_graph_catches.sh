#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The include graph's own test: what breaks the rules is found, wherever and however it is written.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
bad=0

# try WANTED FILE LINE…: the check of a tree of this one file with these lines; WANTED is passes or fails.
try() {
  local wanted=$1 file=$tree/$2 found=passes
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{apps,examples,proofmass/core} "$(dirname "$file")"
  echo '#pragma once' >"$tree/proofmass/core/unit.hpp"
  printf '%s\n' "${@:3}" >"$file"
  bash "$here/include_graph.sh" "$tree" >/dev/null || found=fails
  [ "$found" = "$wanted" ] || { printf '%s with %s %s\n' "$2" "${*:3}" "$found" && bad=1; }
}

try passes proofmass/core/term.cpp '#include <vector>' '#include "proofmass/core/term.hpp"'
try passes proofmass/report/json.cpp '#include "proofmass/core/term.hpp"' '#include <nlohmann/json.hpp>'
try passes proofmass/core/term_test.cpp '#include "proofmass/report/json.hpp"'
try fails proofmass/core/term.cpp '#include "proofmass/report/json.hpp"'
try fails proofmass/core/term.cpp '#include <proofmass/report/json.hpp>'
try fails proofmass/core/term.cpp '  #  include <support/twin.hpp>'
try fails proofmass/core/term.cpp '#include "proofmass/core/../report/json.hpp"'
try fails proofmass/core/term.cpp '#include "term.hpp"'
try fails proofmass/core/term.cpp '#include "proofmass/pipeline.hpp"'
try fails proofmass/core/sub/x.cpp '#include "proofmass/report/json.hpp"'
try fails proofmass/core/sub/deep/x.hpp '#include <proofmass/report/json.hpp>'
try fails proofmass/other/x.cpp '#include <vector>'
try fails proofmass/core/term.hpp '#include <fmt/format.h>'
try fails apps/x.cpp '#include "proofmass/report/json_node_internal.hpp"'
exit $bad

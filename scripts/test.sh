#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the optimised product and runs its tests, within ten minutes on two cores. With --all also under the
# sanitizers, with the examples against an installed copy, reports in a browser, formatting and static analysis. Needs
# nothing but this checkout on Debian 12.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() { printf 'usage: scripts/test.sh [--all]\n'; }
all=false
case "${1-}" in
  '' | --quick) ;;  # --quick: an older word for the same
  --all) all=true ;;
  -h | --help) usage && exit 0 ;;
  *) usage >&2 && exit 2 ;;
esac

failed=()
# step TITLE COMMAND…: runs the command and continues after a failure, so that one run shows all failures.
step() {
  local title=$1 start=$SECONDS
  say "$title"
  if "${@:2}"; then
    printf '%s: done in %d s\n' "$title" $((SECONDS - start))
  else
    failed+=("$title")
    printf '%s: FAILED\n' "$title"
  fi
}

# test_build PRESET [TARGET…]: configures, builds and tests it.
test_build() {
  configure "$1" && build "$1" ${2+--target "${@:2}"} && run "${launcher[@]}" ctest --preset "$1" --parallel "$(nproc)" \
    --output-junit "$root/build/$1/ctest.xml"
}
launcher=()

# Labels of the tests say what each sanitizer runs (cmake/ProofmassOptions.cmake, proofmass/tests.cmake).
# ThreadSanitizer of GCC 12 cannot run where the kernel randomises more address bits than it knows.
test_threads() {
  local launcher=()
  ! setarch --addr-no-randomize true 2>/dev/null || launcher=(setarch --addr-no-randomize)
  test_build tsan thread_tests
}

test_examples() {
  local prefix=build/install
  local twin=$prefix/share/proofmass/twin.toml
  rm -rf "$prefix" && run cmake --install build/check --prefix "$prefix" >/dev/null &&
    run cmake --fresh -S examples -B build/examples -DCMAKE_PREFIX_PATH="$root/$prefix" &&
    build examples &&
    run "$prefix/bin/proofmass" simulate "$twin" --out build/examples/run.csv &&
    run build/examples/identify_record build/examples/run.csv &&
    run build/examples/simulate_and_compare "$twin"
}

# Reports of every kind, opened by Chromium from disk and printed (tests/browser).
test_reports() {
  local folder=build/browser
  rm -rf "$folder" && mkdir -p "$folder" && cp tests/browser/{package.json,package-lock.json,.npmrc,reports.mjs} "$folder" &&
    (cd "$folder" && run npm ci --ignore-scripts --no-audit --no-fund) &&
    run tests/browser/make_reports.sh build/check/bin/proofmass "$folder" &&
    run node "$folder/reports.mjs" "$folder"
}

sources() { find proofmass apps benchmarks examples tests -name '*.[ch]pp' -print0; }
check_format() { sources | xargs -0 clang-format --dry-run -Werror; }
# join_sources: in place of each file read from standard input that includes sources (CMAKE_UNITY_BUILD), those sources
# themselves, for clang-analyzer and some checks look at nothing that is included; prints each file after its size.
join_sources() {
  local file source
  while read -r file; do
    if [[ $file == *.cxx ]]; then
      sed -n 's/^#include "\(.*\)"$/\1/p' "$file" | while read -r source; do
        printf '#line 1 "%s"\n' "$source" && cat "$source"
      done >"$file.joined"
      mv "$file.joined" "$file"
    fi
    printf '%s %s\n' "$(wc -c <"$file")" "$file"
  done
}
# name_sources: a finding's file and line are those of the source that was joined.
name_sources() {
  awk 'match($0, /^[^:]*\.cxx:[0-9]+:/) {
      split(substr($0, 1, RLENGTH), place, ":")
      line = 0
      for (k = 1; k <= place[2] && (getline text < place[1]) > 0; ++k) {
        if (text ~ /^#line 1 "/) { source = text; gsub(/^#line 1 "|"$/, "", source); line = 0 } else { ++line }
      }
      close(place[1])
      print source ":" line ":" substr($0, RLENGTH + 1)
      next
    }
    { print }'
}
# The sources of one module are checked as one: most of the time would go into their headers. The longest come first.
# Clang does not know every warning that GCC is told to leave out.
check_tidy() {
  rm -rf build/tidy && configure tidy || return
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/tidy/compile_commands.json | join_sources | sort -n -r | cut -d ' ' -f 2 |
    xargs -n 1 -P "$(nproc)" clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option 2>&1 | name_sources |
    { grep -v '^[0-9]* warnings\? generated\.$' || true; }
}

# total ATTRIBUTE: the sum of the attribute over all ctest runs of this call.
total() {
  sed -n "s/.*[[:space:]<]$1=\"\([0-9]*\)\".*/\1/p" "${reports[@]}" | awk '{sum += $1} END {print sum + 0}'
}

# True when a test of this call was skipped because reference data are missing.
lacks_reference_data() { grep -qE '(no reference data at|reference data absent:) ' "${reports[@]}"; }

say "Packages"
scripts/install-packages.sh
if $all; then scripts/install-packages.sh scripts/all-packages.txt; fi
if [ ! -d "$reference_data" ]; then
  say "No reference data at $reference_data: the tests that need them are skipped"
  [ "${CI-}" != true ] || failed+=("Reference data are missing")
fi

rm -f build/*/ctest.xml
step "Optimised build and its tests" test_build check
if $all; then
  step "AddressSanitizer and UndefinedBehaviorSanitizer" test_build asan
  step "ThreadSanitizer" test_threads
  step "Examples against an installed copy" test_examples
  step "Reports in a browser" test_reports
  step "Formatting" check_format
  step "Static analysis" check_tidy
fi

say "Summary"
shopt -s nullglob
reports=(build/*/ctest.xml)
if [ "${CI-}" = true ] && [ ${#reports[@]} -gt 0 ] && lacks_reference_data; then
  failed+=("Parts of the reference data at $reference_data are missing")
fi
for title in "${failed[@]}"; do echo "FAILED: $title"; done
[ ${#reports[@]} -gt 0 ] || { echo "No test ran." && exit 1; }
tests=$(total tests) failures=$(total failures) skipped=$(total skipped)
echo "$((tests - failures - skipped)) passed, $failures failed, $skipped skipped"
[ ${#failed[@]} -eq 0 ]

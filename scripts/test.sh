#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs all tests: the optimised build, the sanitizers, the examples against an installed copy, formatting and static
# analysis. With --quick it runs only the tests of the optimised build. It needs only this checkout on Debian 12.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() { printf 'usage: scripts/test.sh [--quick]\n'; }
quick=false
case "${1-}" in
  '') ;;
  --quick) quick=true ;;
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

# The presets of both sanitizers leave out statistical tests over many repeats: they run many times slower there, and
# the law suite and the tests of each method's errors already run the same code. The optimised build runs them all.
# The preset of ThreadSanitizer also leaves out tests that run on one thread, and laws whose code the law of threads
# runs. GCC 12's ThreadSanitizer fails where the kernel randomises more address bits than it supports.
test_threads() {
  local launcher=()
  ! setarch --addr-no-randomize true 2>/dev/null || launcher=(setarch --addr-no-randomize)
  test_build tsan numeric_tests identify_tests pipeline_tests cli_tests
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

sources() { find proofmass apps benchmarks examples tests -name '*.[ch]pp' -print0; }
check_format() { sources | xargs -0 clang-format --dry-run -Werror; }
# Clang does not know every warning option that is given to GCC. The largest files come first, so that no processor is
# left with a long file at the end.
check_tidy() {
  configure tidy || return
  find proofmass apps -name '*.cpp' ! -name '*_test.cpp' -printf '%s %p\0' | sort -z -n -r | cut -z -d ' ' -f 2 |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option 2>&1 |
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
if [ ! -d "$reference_data" ]; then
  say "No reference data at $reference_data: the tests that need them are skipped"
  [ "${CI-}" != true ] || failed+=("Reference data are missing")
fi

rm -f build/*/ctest.xml
step "Optimised build and its tests" test_build check
if ! $quick; then
  step "AddressSanitizer and UndefinedBehaviorSanitizer" test_build asan
  step "ThreadSanitizer" test_threads
  step "Examples against an installed copy" test_examples
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

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks that every number in the result of every method on every shipped twin is the same to the bit as at another
# revision. It builds REV beside this checkout, lets both programs identify the same records, and compares the results.
# New keys are not a difference; a number that has changed or is missing is one.
#   scripts/same-bits.sh REV [METHOD…]    all methods when none is given
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1-}" in
  '' | -*) printf 'usage: scripts/same-bits.sh REV [METHOD...]\n' >&2 && exit 2 ;;
esac
revision=$(git rev-parse --verify --quiet "$1^{commit}") || { printf 'no such revision: %s\n' "$1" >&2 && exit 2; }
methods=("${@:2}")
[ ${#methods[@]} -gt 0 ] || methods=(ols wls robust tls eiv gmdh afsa bp pso-bp hybrid)
seeds=(1 2 3)
folder=$root/build/same-bits
there=$folder/$revision

say "Packages"
scripts/install-packages.sh
say "Building $(git log -1 --format='%h %s' "$revision")"
[ -d "$there" ] || git clone --quiet --shared "$root" "$there"
git -C "$there" checkout --quiet --detach "$revision"
(cd "$there" && configure release && build release --target proofmass_cli) >"$folder/build.log" 2>&1 ||
  { tail -n 20 "$folder/build.log" && exit 1; }
say "Building this checkout"
{ configure release && build release --target proofmass_cli; } >"$folder/build.log" 2>&1 ||
  { tail -n 20 "$folder/build.log" && exit 1; }
before=$there/build/release/bin/proofmass
after=$root/build/release/bin/proofmass

# identify PROGRAM RESULT RECORD METHOD SEED: where the program refuses, the result file holds the exit code instead.
identify() {
  local uncertainties=()
  [[ $4 != tls && $4 != eiv ]] || grep -q sigma_Ai "$3" || uncertainties=(--sigma-input-ug 20)
  [[ $4 != tls && $4 != eiv ]] || grep -q sigma_E "$3" || uncertainties+=(--sigma-output-ug 10)
  "$1" identify "$3" --method "$4" --seed "$5" --model full --on-rank-loss drop --split 0.7 --quiet --json "$2" \
    "${uncertainties[@]}" >/dev/null 2>&1 || echo "{\"exit\": $?}" >"$2"
}

say "Identifying"
results=$folder/results
rm -rf "$results" && mkdir -p "$results"
for twin in "$there"/data/*.toml; do
  for seed in "${seeds[@]}"; do
    record=$results/$(basename "$twin" .toml)-$seed.csv
    "$before" simulate "$twin" --seed "$seed" --out "$record" --quiet >/dev/null
    for method in "${methods[@]}"; do
      name=${record%.csv}-$method
      identify "$before" "$name.before.json" "$record" "$method" "$seed" &
      identify "$after" "$name.after.json" "$record" "$method" "$seed" &
      wait
    done
  done
  printf '%s\n' "$twin"
done

say "Comparing"
python3 - "$results" <<'PYTHON'
import glob
import json
import sys


def numbers(value, path=()):
    if isinstance(value, dict):
        for key, item in value.items():
            yield from numbers(item, path + (key,))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from numbers(item, path + (index,))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, value


compared = differing = refused = 0
for file in sorted(glob.glob(sys.argv[1] + "/*.before.json")):
    with open(file) as before, open(file.replace(".before.", ".after.")) as after:
        old, new = dict(numbers(json.load(before))), dict(numbers(json.load(after)))
    compared += len(old)
    refused += ("exit",) in old
    for path, value in old.items():
        if new.get(path) != value:
            differing += 1
            if differing <= 20:
                place = ".".join(map(str, path))
                print(f"{file}: {place}: {value!r} has become {new.get(path)!r}")
print(f"{compared} numbers compared, {differing} differ; {refused} records refused by their methods")
sys.exit(differing != 0 or compared == 0)
PYTHON

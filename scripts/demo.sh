#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds Proofmass and identifies the shipped simulated twin by several methods and, if the reference data are
# present, a real sensor. It needs only this checkout on Debian 12.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

say "Packages"
scripts/install-packages.sh

say "Building"
configure release
build release
proofmass=build/release/bin/proofmass
out=build/demo
mkdir -p "$out"

say "A simulated record of the twin: $out/run.csv"
run "$proofmass" simulate data/twin.toml --out "$out/run.csv"
run "$proofmass" inspect "$out/run.csv"

for method in ols bp pso-bp; do
  say "The twin's static model by $method"
  run "$proofmass" identify "$out/run.csv" --method "$method" --model paper --json "$out/twin-$method.json" \
    --report "$out/twin-$method.html"
done

positions=$reference_data/positions/imucal_ferraris_6pos.csv
if [ -f "$positions" ]; then
  # the axis of the triad that is the input axis, then the reference columns for Ai, Ao, Ap
  for axes in "x gx gy gz" "y gy gz gx" "z gz gx gy"; do
    read -r axis i o p <<<"$axes"
    say "A real MEMS triad in six positions: axis $axis"
    run "$proofmass" identify "$positions" --map "Ai=ref_$i,Ao=ref_$o,Ap=ref_$p,E=a${axis}_raw[count]" \
      --model linear --split 1 --json "$out/triad-$axis.json"
  done
else
  say "No reference data at $reference_data: the real sensor is left out"
fi

say "The paper's experiment, repeated, as a report"
run "$proofmass" reproduce --quick --out "$out/reproduction" --report "$out/reproduction.html" >/dev/null

say "Files written"
ls -l "$out"

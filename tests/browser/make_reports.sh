#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_reports.sh PROGRAM FOLDER: reports of every kind for reports.mjs, and kinds.json: how many figures of each can be
# zoomed (`live`), and how many of those are drawn in space.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
program=$PWD/$1 data=$PWD/data
mkdir -p "$2" && cd "$2"
export SOURCE_DATE_EPOCH=1800000000

"$program" simulate "$data/twin.toml" --rows 600 --out run.csv
# With clock, temperature and mounts; the output drifts with temperature, and one row is far off.
awk -F, 'BEGIN {OFS = ","; print "t,T,mount,Ai,Ao,Ap,E"}
  /^[-0-9.]/ {++n; T = 20 + n / 100; e = $4 + 2e-5 * (T - 20); if (n == 300) e += 1e-3
    printf "%d,%.3f,%s,%s,%s,%s,%.12f\n", 10 * n, T, n % 2 ? "radial up" : "radial down", $1, $2, $3, e}' run.csv >bench.csv

"$program" identify run.csv --model full --report identify.html --json result.json --quiet >/dev/null
"$program" identify bench.csv --report warnings.html --quiet >/dev/null
"$program" identify run.csv --method bp --early-stopping on --report network.html --quiet >/dev/null
"$program" identify run.csv --method pso-bp --report swarm.html --quiet >/dev/null
mkdir -p elsewhere && cp result.json elsewhere/
(cd elsewhere && "$program" report result.json --out ../without-record.html --quiet)
"$program" compare run.csv --methods ols,robust,gmdh,bp --repeats 4 --truth "$data/twin.toml" \
  --report compare.html --quiet >/dev/null
"$program" reproduce --quick --report reproduce.html --quiet >/dev/null

identification='"title": {"en": "Identification of the static model", "zh": "静态模型辨识"}'
cat >kinds.json <<END
[
  {"kind": "identify", "live": 12, "space": 1, $identification},
  {"kind": "warnings", "live": 15, "space": 1, $identification},
  {"kind": "network", "live": 13, "space": 1, $identification},
  {"kind": "swarm", "live": 14, "space": 1, $identification},
  {"kind": "without-record", "live": 1, "space": 0, $identification},
  {"kind": "compare", "live": 2, "space": 0, "title": {"en": "Comparison of methods", "zh": "方法比较"}},
  {"kind": "reproduce", "live": 5, "space": 0, "title": {"en": "Reproduction of the paper", "zh": "论文复现"}}
]
END

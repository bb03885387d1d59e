#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares every method on six shipped twins with the Cramér–Rao bound, the floor and the noise, and prints one Markdown
# table per twin. It needs only this checkout on Debian 12; twenty seeds take some minutes. With --write the tables
# replace those in docs/method-comparison.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=20
prepare_tables methods "$@"

# All terms are fitted, except on the twin with uncertain inputs: there Koq is aliased with Kii, and the paper's terms
# are.
tables=build/methods.md
while read -r twin model; do
  build/release/bin/methods "data/$twin.toml" "$model" "$seeds"
done <<'TWINS' | tee "$tables"
twin-300ug full
twin-10ug full
twin-heavy-tails full
twin-heteroscedastic full
twin-input-noise paper
twin-unmodelled full
TWINS

if "$write"; then renew_tables docs/method-comparison.md "$tables"; fi

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures how close every method comes to the floor on the shipped twins and prints one Markdown table a noise level.
# Needs nothing but this checkout on Debian 12; ten seeds take some minutes. With --write the tables take the place of
# those in docs/accuracy.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=10
prepare_tables accuracy "$@"

# The last column, seconds, says more of the machine than of the method.
tables=build/accuracy.md
for twin in twin twin-10ug twin-300ug; do
  build/release/bin/accuracy "data/$twin.toml" "$seeds"
done | sed -E '/^\|/s/[^|]*\|$//' | tee "$tables"

if "$write"; then renew_tables docs/accuracy.md "$tables"; fi

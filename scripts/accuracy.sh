#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the errors of every method with the floor on the shipped twins and prints one Markdown table per noise level.
# It needs only this checkout on Debian 12; ten seeds take some minutes. With --write the tables replace those in
# docs/accuracy.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=10
prepare_tables accuracy "$@"

# The last column, seconds, is left out: it depends on the machine more than on the method.
tables=build/accuracy.md
for twin in twin twin-10ug twin-300ug; do
  build/release/bin/accuracy "data/$twin.toml" "$seeds"
done | sed -E '/^\|/s/[^|]*\|$//' | tee "$tables"

if "$write"; then renew_tables docs/accuracy.md "$tables"; fi

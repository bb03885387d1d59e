#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Counts how often 95 % intervals hold the truth, over random sensors, and prints one Markdown table. It needs only this
# checkout on Debian 12; two thousand records of each kind take an hour, most of it for networks. With --write the table replaces that
# in docs/uncertainty.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=2000
prepare_tables coverage "$@"

tables=build/coverage.md
{
  build/release/bin/coverage "$seeds"
  printf '\n'
  build/release/bin/coverage $((seeds / 2)) 1 networks
} | tee "$tables"
if "$write"; then renew_tables docs/uncertainty.md "$tables"; fi

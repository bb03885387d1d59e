#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures how far PSO-BP stays above the floor on ten sensors drawn at random, and prints one Markdown table. It needs
# only this checkout on Debian 12; forty records of each sensor take some minutes. With --write the table replaces that
# in docs/pso-bp.md. SEEDS is the number of records of each sensor.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=40
prepare_tables network-floor "$@"

tables=build/network-floor.md
build/release/bin/network_floor 10 "$seeds" 7001 | tee "$tables"
if "$write"; then renew_tables docs/pso-bp.md "$tables"; fi

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Counts the warnings and notes that clean records get, over random sensors, and prints one Markdown table. It needs
# only this checkout on Debian 12; a thousand records of each kind take a minute or two. With --write the table replaces
# that in docs/diagnosis.md.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seeds=1000
prepare_tables false-alarms "$@"

tables=build/false-alarms.md
build/release/bin/false_alarms "$seeds" | tee "$tables"
if "$write"; then renew_tables docs/diagnosis.md "$tables"; fi

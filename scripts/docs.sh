#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renews the tables of options in docs/commands.md from the tables in the code. With --check PROGRAM, the built
# option_pages, it only tells whether they are the same.
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

page=docs/commands.md
# tables: those that stand in the page.
tables() { sed -n '/^<!-- options -->$/,/^<!-- end of options -->$/{/^<!-- /!p}' "$page"; }

if [ "${1-}" = --check ]; then
  diff <(tables) <("$2") || { echo "$page differs from the code: run scripts/docs.sh" && exit 1; }
  exit 0
fi
scripts/install-packages.sh
configure dev && build dev --target option_pages
made=$(mktemp)
trap 'rm -f "$made"' EXIT
build/dev/apps/option_pages/option_pages >"$made"
sed -i -e "/^<!-- options -->$/,/^<!-- end of options -->$/{/^<!-- options -->$/r $made
  /^<!-- /!d}" "$page"

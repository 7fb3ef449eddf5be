#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh BUILD ETAK: runs the tests of the module (etak.wasm, etak.mjs in BUILD) by node, against the native program ETAK,
# and, where there is chromium, those of the page.
set -euo pipefail
export ETAK_WEB ETAK
ETAK_WEB=$(cd "$1" && pwd)
ETAK=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
[ -x "$ETAK" ] || { echo "run.sh: there is no $ETAK, whose answers are the module's, too: ./dev test builds it" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
node --test "$here"/*.test.mjs
if command -v chromium >/dev/null; then
  node "$here/page.mjs" "$ETAK_WEB/etak.html" "$ETAK"
else
  echo "run.sh: there is no chromium: the page is not tested" >&2
fi

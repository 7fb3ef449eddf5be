#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run_case.sh ETAK CASE: runs one test of the command line.
#   ETAK   the etak program; its folder is put first in PATH
#   CASE   folder with
#     cmd               shell commands, run by sh -eu in a copy of the folder. ETAK_SOURCE is the source tree.
#                       With exit status 77 the test is skipped, and the output tells why
#     expected.stdout   the output; where there is no such file, the output must be empty. A line is literal;
#     expected.stderr   after "~ " it is an extended regular expression; "..." stands for any number of lines
#     expected.exit     the exit status; where there is no such file, it must be 0
set -eu
etak_folder=$(cd "$(dirname "$1")" && pwd)
case=$(cd "$2" && pwd)
matcher=$(cd "$(dirname "$0")" && pwd)/match_lines.awk
ETAK_SHARED=${ETAK_SHARED:-$(dirname "$matcher")/../../../shared}
PATH=$etak_folder:$PATH
ETAK_FOLDER=$etak_folder
ETAK_SOURCE=$(dirname "$matcher")/../..
LC_ALL=C
export ETAK_SHARED ETAK_FOLDER ETAK_SOURCE PATH LC_ALL
unset NO_COLOR ETAK_LIBRARY OCIO || true
unset CLICOLOR CLICOLOR_FORCE COLUMNS ETAK_FORCE || true

scratch=$(mktemp -d -t etak-cli.XXXXXX)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
cp -R "$case" "$scratch/case"
chmod -R u+w "$scratch/case"
cd "$scratch/case"
XDG_CONFIG_HOME=$scratch/config  # keeps the user's own configuration out of the test
export XDG_CONFIG_HOME

status=0
sh -eu ./cmd >"$scratch/stdout" 2>"$scratch/stderr" </dev/null || status=$?
if [ "$status" -eq 77 ]; then
  cat "$scratch/stdout" "$scratch/stderr"
  exit 77
fi

failed=0
expected=0
[ ! -f expected.exit ] || expected=$(cat expected.exit)
if [ "$status" -ne "$expected" ]; then
  echo "exit status $status, expected $expected"
  failed=1
fi
for stream in stdout stderr; do
  [ -f "expected.$stream" ] || : >"expected.$stream"
  awk -f "$matcher" "expected.$stream" "$scratch/$stream" >"$scratch/verdict" || {
    echo "$stream: $(cat "$scratch/verdict")"
    failed=1
  }
done
if [ "$failed" -ne 0 ]; then
  echo "--- stdout" && head -c 4000 "$scratch/stdout"
  echo "--- stderr" && head -c 4000 "$scratch/stderr"
fi
exit "$failed"

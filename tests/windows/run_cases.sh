#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run_cases.sh ETAK OUT [CASE...]: runs the cases of the command line with the program for Windows, and prints how many
# passed, failed and were left out, and why.
#   ETAK   a script that runs the program under Wine
#   OUT    a folder for what the cases print
#   CASE   names of cases; without any, all of tests/windows/cases and tests/cli
set -euo pipefail
etak=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
mkdir -p "$2"
out=$(cd "$2" && pwd)
shift 2
here=$(cd "$(dirname "$0")" && pwd)
cases=()
for cmd in "$here"/cases/*/cmd "$here"/../cli/*/cmd; do
  case=${cmd%/cmd}
  [ $# -eq 0 ] || [[ " $* " == *" ${case##*/} "* ]] || continue
  cases+=("$case")
done
[ ${#cases[@]} -gt 0 ] || { echo "run_cases.sh: $*: no such case" >&2; exit 2; }
rm -f "$out"/*.status "$out"/*.out
run_one() { # ETAK OUT SKIPPED CASE
  local name=${4##*/} reason status=0
  reason=$(awk -v name="$name" '$1 == name { sub(/^[^ ]+ +/, ""); print; exit }' "$3")
  if [ -n "$reason" ]; then
    echo "$reason" >"$2/$name.out"
    echo 77 >"$2/$name.status"
    return
  fi
  timeout 1800 "$(dirname "$3")/../cli/run_case.sh" "$1" "$4" >"$2/$name.out" 2>&1 || status=$?
  echo "$status" >"$2/$name.status"
}
export -f run_one
printf '%s\0' "${cases[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'run_one "$@"' run_one "$etak" "$out" "$here/skipped.txt"

passed=0 failed=() skipped=0
for case in "${cases[@]}"; do
  name=${case##*/}
  case $(cat "$out/$name.status") in
    0) passed=$((passed + 1)) ;;
    77) skipped=$((skipped + 1)) && head -n 1 "$out/$name.out" >>"$out/reasons.txt.new" ;;
    *) failed+=("$name") ;;
  esac
done
for name in "${failed[@]}"; do
  echo "failed: $name"
  head -n 30 "$out/$name.out" | sed 's/^/    /'
done
echo "cases of the command line: ${#cases[@]}; passed $passed, failed ${#failed[@]}, left out $skipped:"
if [ -f "$out/reasons.txt.new" ]; then
  mv "$out/reasons.txt.new" "$out/reasons.txt"
  sort "$out/reasons.txt" | uniq -c | sort -rn
fi
[ ${#failed[@]} -eq 0 ]

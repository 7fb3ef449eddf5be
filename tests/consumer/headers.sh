#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# headers.sh INCLUDE COMPILER: fails unless the headers installed below the folder INCLUDE are those that
# headers.txt lists and each of them compiles alone, with no other folder to search. A header that the source
# of its own name includes first is not compiled here: it is compiled alone with that source, by the presets
# debug and tsan (.ci/run builds the latter).
set -eu
include=$1 compiler=$2
list=${0%/*}/headers.txt
tree=${0%/*}/../..
installed=$(mktemp)
trap 'rm -f "$installed"' EXIT
(cd "$include" && find . -type f | sed 's|^\./||' | LC_ALL=C sort) >"$installed"
diff -u "$list" "$installed" || {
  echo "the installed headers are not those of $list: is a change of the public interface wanted?"
  exit 1
}
while read -r header; do
  own=${header#etak/}
  first=$(cat "$tree/${own%.h}.cpp" "$tree/${own%.h}_json.cpp" 2>/dev/null | grep -m1 '^#include' || true)
  [ "$first" = "#include \"$own\"" ] || echo "$header"
done <"$list" |
  xargs -P 2 -n 1 sh -c '
    "$0" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$1" -I"$1/etak" -include "$2" -x c++ /dev/null || exit 255
  ' "$compiler" "$include"

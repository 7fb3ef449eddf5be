#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# headers.sh INCLUDE COMPILER: the headers installed below the folder INCLUDE are those that headers.txt lists, and each of
# them compiles alone, with no other folder to search.
set -eu
include=$1 compiler=$2
list=${0%/*}/headers.txt
installed=$(mktemp)
trap 'rm -f "$installed"' EXIT
(cd "$include" && find . -type f | sed 's|^\./||' | LC_ALL=C sort) >"$installed"
diff -u "$list" "$installed" || {
  echo "the installed headers are not those of $list: is a change of the public interface wanted?"
  exit 1
}
xargs -P 2 -n 1 sh -c '
  "$0" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$1" -I"$1/etak" -include "$2" -x c++ /dev/null || exit 255
' "$compiler" "$include" <"$list"

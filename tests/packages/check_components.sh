#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# check_components.sh BUILD PREFIX LIBDIR SOURCE WORK COMPONENT=PACKAGE...: installs each component of the build into a
# folder of its own and checks its files. Together they must be what is installed in PREFIX without naming a component: no
# file may be left out of the packages.
set -eu
build=$1 prefix=$2 libdir=$3 source=$4 work=$5
shift 5
rm -rf "$work"
mkdir -p "$work"
for pair; do
  cmake --install "$build" --component "${pair%=*}" --prefix "$work/${pair%=*}" >"$work/log" || { cat "$work/log"; exit 1; }
  "${0%/*}/check_tree.sh" "${pair#*=}" "$work/${pair%=*}" "$libdir" "$source"
  (cd "$work/${pair%=*}" && find . ! -type d) >>"$work/of_packages"
done
(cd "$prefix" && find . ! -type d) | LC_ALL=C sort >"$work/installed"
LC_ALL=C sort "$work/of_packages" | diff - "$work/installed" || {
  echo "files that are installed belong to no package, or to two"
  exit 1
}
rm -rf "$work"

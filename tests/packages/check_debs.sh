#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# check_debs.sh FOLDER: checks the files of each Debian package in FOLDER. ./dev packages runs it.
set -eu
here=$(cd "${0%/*}" && pwd)
found=0
for deb in "$1"/*.deb; do
  [ -e "$deb" ] || break
  package=$(dpkg-deb -f "$deb" Package)
  tree=$(mktemp -d)
  dpkg-deb -x "$deb" "$tree"
  "$here/check_tree.sh" "$package" "$tree/usr" "lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)" "${here%/tests/packages}"
  for file in copyright changelog.Debian.gz; do
    [ -s "$tree/usr/share/doc/$package/$file" ] || { echo "$deb has no $file"; exit 1; }
  done
  [ "$package" != libetak-dev ] || [ -s "$tree/usr/share/doc/libetak-dev/html/index.html" ] ||
    { echo "$deb has no reference"; exit 1; }
  rm -rf "$tree"
  found=$((found + 1))
done
[ "$found" -ge 3 ] || { echo "$1 holds $found packages"; exit 1; }

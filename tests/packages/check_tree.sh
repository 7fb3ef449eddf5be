#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# check_tree.sh PACKAGE PREFIX LIBDIR SOURCE: checks the files of one package, which lie below the folder PREFIX: they are
# those that contents/PACKAGE.txt lists, and no program looks for libraries in a folder of its own or names the folder
# SOURCE that it was built from, unless that is empty. LIBDIR is lib, or the folder for libraries of one kind of processor
# below it.
set -eu
package=$1 prefix=$2 libdir=$3 source=$4
here=${0%/*}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The files of contents/, and what is installed by a rule: a manual page for each verb, each schema, the headers of
# tests/consumer/headers.txt. The pages of the reference are not listed. A package of Debian also holds what its rules ask
# for: copyright, changelog and compressed manual pages. The names of Python's modules tell its version.
{
  cat "$here/contents/$package.txt"
  case $package in
    libetak-dev) sed 's|^|include/|' "$here/../consumer/headers.txt" ;;
    etak)
      sed -n 's|^ETAK_VERB(\(.*\))$|share/man/man1/etak-\1.1|p' "$here/../../app/cli/verbs.inc"
      (cd "$here/../../resources" && printf 'share/etak/%s\n' schema/*)
      ;;
  esac
} | LC_ALL=C sort >"$work/expected"
(cd "$prefix" && find . ! -type d) | sed "s|^\./||; s|^$libdir/|lib/|; s|\(/man1/.*\.1\)\.gz$|\1|; s|\.cpython-[^/]*\.so$|.so|" |
  grep -vE "^share/(doc/$package/(html/.*|copyright|changelog.Debian.gz)|lintian/overrides/$package)$" |
  LC_ALL=C sort >"$work/installed"
diff -u "$work/expected" "$work/installed" || {
  echo "the files of $package are not those of tests/packages/contents/$package.txt: is the change wanted?"
  exit 1
}

failed=0
find "$prefix" -type f \( -path '*/bin/*' -o -name '*.so' -o -name '*.a' -o -name '*.cmake' -o -name '*.pc' \) >"$work/binaries"
while read -r file; do
  case $file in
    */bin/* | *.so)
      if command -v readelf >/dev/null && readelf -d "$file" | grep -E '\((RPATH|RUNPATH)\)'; then
        echo "$file looks for libraries in a folder of its own"
        failed=1
      fi
      ;;
  esac
  if [ -n "$source" ] && grep -qaF "$source/" "$file"; then
    echo "$file names the folder that it was built from"
    failed=1
  fi
done <"$work/binaries"
exit $failed

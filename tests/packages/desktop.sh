#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# desktop.sh PREFIX TREE: checks how desktops see the editor that is installed in PREFIX: the desktop file and the
# description for software centres are valid, and projects and materials are known by their content, which is tried with
# those of the checkout TREE. Programs that are not there are left out; without gio nothing says what a file is.
set -eu
share=$1/share tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "$*" >&2
  exit 1
}

desktop=$share/applications/etak-editor.desktop
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$desktop" >"$work/said" 2>&1 || fail "$(cat "$work/said")"
  [ ! -s "$work/said" ] || fail "$(cat "$work/said")"
fi
# An id that begins with a domain is asked for, which etak does not have.
if command -v appstreamcli >/dev/null; then
  appstreamcli validate --no-net --override cid-desktopapp-is-not-rdns=info "$share/metainfo/etak-editor.metainfo.xml" \
    >"$work/said" 2>&1 || fail "$(cat "$work/said")"
fi
types=$(sed -n 's/.*<mime-type type="\(application\/vnd\.etak[^"]*\)".*/\1/p' "$share/mime/packages/etak.xml")
[ "$(echo "$types" | wc -l)" -eq 2 ] || fail "types of files: $types"
for type in $types; do
  grep -q "^MimeType=.*$type;" "$desktop" || fail "the desktop file has no $type"
  grep -q "<mediatype>$type</mediatype>" "$share/metainfo/etak-editor.metainfo.xml" || fail "the description has no $type"
done

command -v update-mime-database >/dev/null && command -v gio >/dev/null || { echo "no update-mime-database or gio here"; exit 77; }
[ -e /usr/share/mime/packages/freedesktop.org.xml ] || { echo "no types of the system here"; exit 77; }
# is NAME TYPE: the type of the file $work/NAME.
is() {
  found=$(gio info -a standard::content-type "$work/$1" | sed -n 's/ *standard::content-type: //p')
  [ "$found" = "$2" ] || fail "$1 is $found with the types in $XDG_DATA_DIRS; expected $2"
}
# Both as a package, in one folder with the types of the system, and in a prefix of its own before or behind that.
mkdir -p "$work/one/mime/packages" "$work/own/mime/packages"
cp /usr/share/mime/packages/freedesktop.org.xml "$share/mime/packages/etak.xml" "$work/one/mime/packages"
cp "$share/mime/packages/etak.xml" "$work/own/mime/packages"
update-mime-database "$work/one/mime" >"$work/said" 2>&1 || fail "$(cat "$work/said")"
update-mime-database "$work/own/mime" >"$work/said" 2>&1 || fail "$(cat "$work/said")"
cp "$tree/tests/fuzz/corpus/project/view.json" "$work/project.json"
cp "$work/project.json" "$work/without_an_ending"
printf '{"schema":"etak-project/1","materials":[]}' >"$work/small.json"
cp "$tree/materials/metal/gold.json" "$work/gold.json"
cp "$tree/resources/costs.json" "$work/costs.json"
printf '{"a": 1}' >"$work/plain.json"
printf 'text' >"$work/page.txt"
export XDG_DATA_HOME="$work/none" XDG_DATA_DIRS
for XDG_DATA_DIRS in "$work/one" "$work/own:/usr/share" "/usr/share:$work/own"; do
  is project.json application/vnd.etak.project+json
  is small.json application/vnd.etak.project+json
  is without_an_ending application/vnd.etak.project+json
  is gold.json application/vnd.etak.material+json
  is costs.json application/json
  is plain.json application/json
  is page.txt text/plain
done

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# installed.sh PREFIX: checks the editor that `cmake --install` has installed: the files for the desktop, the
# man page, the messages for wrong options, and that it draws.
prefix=$1
editor=$prefix/bin/etak-editor
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "installed editor: $*" >&2
  exit 1
}

# The files for the desktop.
desktop=$prefix/share/applications/etak-editor.desktop
icon=$prefix/share/icons/hicolor/scalable/apps/etak-editor.svg
page=$prefix/share/man/man1/etak-editor.1
for file in "$editor" "$desktop" "$icon" "$page"; do [ -s "$file" ] || fail "$file is missing"; done
grep -qx 'Exec=etak-editor %f' "$desktop" || fail "the desktop file starts another program"
grep -qx 'Icon=etak-editor' "$desktop" || fail "the desktop file names another icon"
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$desktop" >"$work/desktop" 2>&1 || fail "$(cat "$work/desktop")"
  [ -s "$work/desktop" ] && fail "$(cat "$work/desktop")"
fi
if command -v xmllint >/dev/null; then xmllint --noout "$icon" || fail "the icon is no XML"; fi

# The man page must describe every option that the help lists.
"$editor" --help >"$work/help" || fail "--help ends with $?"
if command -v man >/dev/null; then
  MANWIDTH=110 man --warnings -l "$page" >"$work/page" 2>"$work/warnings" || fail "man cannot show the page"
  [ -s "$work/warnings" ] && fail "$(cat "$work/warnings")"
else
  sed 's/\\-/-/g' "$page" >"$work/page"
fi
options=$(grep -oE -- '--[a-z]+' "$work/help" | sort -u)
[ "$(echo "$options" | wc -l)" -ge 8 ] || fail "the help lists too few options: $options"
for option in $options; do
  grep -q -- "$option" "$work/page" || fail "the man page has no $option"
done
"$editor" --version | grep -qE '^etak-editor [0-9]+\.[0-9]+' || fail "--version tells no version"

export HOME="$work" XDG_RUNTIME_DIR="$work"
# A mistake must be reported in one line on stderr, with exit status 2, and without a display.
refused() {
  expected=$1
  shift
  env -u DISPLAY QT_QPA_PLATFORM=offscreen "$editor" "$@" >"$work/out" 2>"$work/error"
  status=$?
  # Removes a remark of Qt on its platform.
  sed -i '/^This plugin does not support/d' "$work/error"
  [ $status -eq 2 ] || fail "$*: status $status"
  [ -s "$work/out" ] && fail "$*: $(cat "$work/out")"
  [ "$(wc -l <"$work/error")" -eq 1 ] || fail "$*: $(cat "$work/error")"
  grep -q -- "$expected" "$work/error" || fail "$*: $(cat "$work/error")"
}
refused 'no option' --what
refused 'needs a value' --screenshot
refused 'WxH' --screenshot "$work/a.png" --size 12
refused 'WxH' --screenshot "$work/a.png" --size 1280x
refused 'specular model' --screenshot "$work/a.png" gold --model none
refused 'expected dark or light' --theme blue
refused 'expected one of' --screenshot "$work/a.png" --state none
refused 'with --screenshot' --state lobe
refused 'no material of the library' --screenshot "$work/a.png" unobtainium
refused 'less than the window needs' --screenshot "$work/a.png" gold --size 400x300
refused 'missing/a.png' --screenshot "$work/missing/a.png" gold
refused 'one file or material' --screenshot "$work/a.png" gold silver
[ -e "$work/a.png" ] && fail "a refused screenshot left a picture"

# The editor must draw without a display, and with OpenGL where there is an X server.
QT_QPA_PLATFORM=offscreen "$editor" --screenshot "$work/b.png" gold --model ggx-f82 --size 1100x760 ||
  fail "no picture without a display"
if command -v xvfb-run >/dev/null && command -v xauth >/dev/null; then
  "$(dirname "$0")"/under_xvfb.sh "$editor" --screenshot "$work/c.png" gold || fail "no picture under Xvfb"
else
  cp "$work/b.png" "$work/c.png"
fi
for picture in "$work/b.png" "$work/c.png"; do
  [ "$(head -c 8 "$picture" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "$picture is no PNG"
done
# Width and height of a PNG stand at byte 16.
[ "$(od -An -j16 -N8 -tx1 "$work/b.png" | tr -d ' ')" = 0000044c000002f8 ] || fail "--size was not heeded"

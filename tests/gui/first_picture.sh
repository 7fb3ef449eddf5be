#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# first_picture.sh ETAK-EDITOR: starts the editor three times with an empty home folder and prints the time
# until its first picture. The best run may take 1000 ms, by the clock or by the work of all processors,
# whichever is less, because on a busy machine the clock runs on while the editor waits.
set -eu
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" XDG_CACHE_HOME="$home" XDG_RUNTIME_DIR="$home"
for run in 1 2 3; do
  "$1" --time-start | tee -a "$home/times"
done
awk '/^first picture after/ { runs++; least = $4 < $6 ? $4 : $6; if (best == "" || least < best) best = least }
  END { if (runs != 3 || best > 1000) { print "too slow, or no picture at all"; exit 1 } }' "$home/times"

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs a program with windows under a virtual X server of its own.
if ! command -v xvfb-run >/dev/null || ! command -v xauth >/dev/null; then
  echo "skipped: xvfb-run and xauth are not here (Debian: xvfb xauth)"
  exit 0
fi
unset WAYLAND_DISPLAY
# The screen has room for a window of 2560x1440, at twice the scale where that is set.
screen=2600x1500x24
[ "${QT_SCALE_FACTOR:-1}" = 1 ] || screen=5200x3000x24
# A test that asks for a window manager gets it where one is installed. It ends with the server.
if [ -n "${ETAK_TEST_WINDOW_MANAGER:-}" ]; then
  if command -v openbox >/dev/null; then
    set -- sh -c 'openbox & exec "$@"' sh "$@"
  else
    echo "there is no window manager here (Debian: openbox)"
  fi
fi
exec env QT_QPA_PLATFORM=xcb xvfb-run -a -s "-screen 0 $screen" "$@"

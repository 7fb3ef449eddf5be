#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pkg_config.sh COMPILER WORK [FOLDER]: builds programs against an installed etak with what pkg-config says: one of etak::core,
# with and without --static, and one for each target beside it that takes all of that target's library in, so that nothing
# that it needs may be missing. FOLDER holds the .pc files, where these are not in a folder that pkg-config knows.
set -eu
compiler=$1 work=$2
[ -z "${3:-}" ] || export PKG_CONFIG_PATH="$3"
command -v pkg-config >/dev/null || { echo "no pkg-config here"; exit 77; }
rm -rf "$work"
mkdir -p "$work"
"$compiler" -std=c++20 -c "${0%/*}/project/main.cpp" -o "$work/main.o" $(pkg-config --cflags etak)
for static in "" --static; do
  "$compiler" "$work/main.o" -o "$work/main" $(pkg-config $static --libs etak)
  "$work/main" | tee "$work/said"
  grep -qE '^gold 1\.04[0-9]+ 0\.77[0-9]+ 0\.33[0-9]+$' "$work/said"
done
doors=0
for name in $(pkg-config --list-all | sed -n 's/^\(etak-[^ ]*\) .*/\1/p' | sort); do
  door=$(echo "${name#etak-}" | tr - _)
  "$compiler" "$work/main.o" -o "$work/$door" -L"$(pkg-config --variable=libdir "$name")" \
    -Wl,--whole-archive -letak_"$door" -Wl,--no-whole-archive $(pkg-config --libs "$name" | sed "s/-letak_$door //")
  "$work/$door" >/dev/null
  rm "$work/$door"
  doors=$((doors + 1))
done
echo "$doors targets beside etak::core"
[ "$doors" -ge 6 ]

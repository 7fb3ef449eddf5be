#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# hardening.sh FILE...: checks that each program and module is built with the hardening flags of a
# distribution.
set -eu
command -v readelf >/dev/null && command -v objdump >/dev/null || { echo "no readelf or objdump here"; exit 77; }
failed=0
expect() { # PROGRAM WHAT PATTERN TEXT
  grep -q "$3" "$4" || { echo "$1: $2 is missing"; failed=1; }
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for program; do
  readelf -hldW "$program" >"$scratch/elf"
  readelf --dyn-syms -W "$program" >"$scratch/symbols"
  begin=main
  case $program in
    */_core.*.so) begin=PyInit__core ;;
    */_pictures.so) begin=etak_python_pictures ;;
    *.so) begin=etak_pictures_module ;;
    *)
      expect "$program" "a position-independent program" 'FLAGS_1.*PIE' "$scratch/elf"
      # The module is not asked, because it calls no function that has a checked form.
      expect "$program" "_FORTIFY_SOURCE" '__[a-z]*_chk@' "$scratch/symbols"
      ;;
  esac
  objdump -d --no-show-raw-insn --disassemble=$begin "$program" >"$scratch/main"
  expect "$program" "RELRO" 'GNU_RELRO' "$scratch/elf"
  expect "$program" "binding of all symbols at the start" 'BIND_NOW\|FLAGS_1.*NOW' "$scratch/elf"
  expect "$program" "the stack protector" '__stack_chk_fail' "$scratch/symbols"
  case $(uname -m) in
    x86_64) expect "$program" "control-flow protection" 'endbr64' "$scratch/main" ;;
  esac
  if readelf -lW "$program" | grep 'GNU_STACK' | grep -q 'RWE'; then
    echo "$program: its stack can be executed"
    failed=1
  fi
done
exit $failed

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# demo_without_test_packages.sh SOURCE SCRATCH: checks that the programs of ./dev demo need no package of the tests and
# no source of them. (./dev fresh demo is the complete check; it takes minutes and needs root.)
set -eu
source=$1 scratch=$2
rm -rf "$scratch"
cmake -S "$source" -B "$scratch" -G Ninja -DCMAKE_BUILD_TYPE=Release -DETAK_BUILD_TESTS=OFF \
  -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON >"$scratch.log" 2>&1 || {
  cat "$scratch.log"
  exit 1
}
ninja -C "$scratch" -t inputs etak-programs >"$scratch.inputs"
grep -q 'core/material/f0' "$scratch.inputs" || { echo "the program's sources are not among what is built"; exit 1; }
# tests/scene makes the scene that the demo packs.
if grep 'tests/' "$scratch.inputs" | grep -v 'tests/scene/'; then echo "the demo builds parts of the tests"; exit 1; fi
sed -n '/^demo()/,/^}/p' "$source/dev" >"$scratch.demo"
grep -q 'configure OFF' "$scratch.demo" || { echo "./dev demo configures the tests"; exit 1; }
if grep -n 'test_packages' "$scratch.demo"; then echo "./dev demo installs packages of the tests"; exit 1; fi
rm -rf "$scratch" "$scratch.log" "$scratch.inputs" "$scratch.demo"

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# demo_saves_half.sh ETAK DEMO_SCENE START_PAGE SCRATCH: the demo's scene saves at least half of its texels, the
# validator finds fault with the mistakes alone, each material of which has one, and the start page says both.
set -eu
etak=$1 demo_scene=$2 start_page=$3 scratch=$4
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
fault() { echo "$*"; touch faults; }

"$demo_scene" scene mistakes
"$etak" pack scene/manifest.json --out atlas --bleed --no-validate --report none
"$etak" validate scene atlas --no-config >said || fault "the validator fails the demo's own scene"
grep -E ' (error|warning) ETK' said && fault "the validator warns of the demo's own scene"
"$etak" validate mistakes --no-config --exit-zero >said
cat said
for material in crate statue plaster pipe wall leaf; do
  grep -E "/${material}_.* (error|warning) ETK" said >found || fault "no fault is found with $material"
done
"$start_page" .
left=$(sed -n 's/.*the pages have [0-9,]* (\([0-9]*\).*/\1/p' index.html)
echo "$left % of the texels are left"
[ "$left" -le 50 ] || fault "the demo's scene saves less than half"
for rule in $(sed -n 's/.* \(error\|warning\) \(ETK[0-9]*\) .*/\2/p' said | sort -u); do
  grep -q "<b>$rule " index.html || fault "the start page does not show $rule"
done
[ ! -e faults ]

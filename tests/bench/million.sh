#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# million.sh ETAK [COUNT]: what a million of each thing that etak reads costs, as the table of resources/doc/limits.md.
#   COUNT   things of each row; 1000000. Names that are answered and materials of a manifest, of which there may be no more
#           than 100,000, are a tenth of it.
# Processor seconds (user and system, all threads) and the peak of the memory in use, by GNU time.
set -eu
etak=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
n=${2:-1000000}
tenth=$((n / 10))
work=$(mktemp -d -t etak-million.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work"

# numbered ITEM COUNT: ITEM on so many lines, its @ the number. listed HEAD ITEM TAIL COUNT: with commas between.
numbered() { seq -f '%.0f' 0 "$(($2 - 1))" | sed "s|.*|$(printf '%s' "$1" | sed 's/@/\&/g')|"; }
listed() {
  printf '%s' "$1"
  numbered "$2" "$4" | paste -sd,
  echo "$3"
}
lines() { numbered "$1" "$n"; }
samples() { awk -v n="$n" -v before="$1" -v between="$2" 'BEGIN {
  for (i = 0; i < n; i++) printf "%s%.7f%s1.5%s0.1\n", before, 0.38 + 0.4 * i / n, between, between }'; }

listed '{"a":[' '{}' ']}' "$n" >objects.json
{ echo wavelength_um,n,k; samples '' ,; } >rows.csv
{ printf 'REFERENCES: "a"\nDATA:\n  - type: tabulated nk\n    data: |\n'; samples '        ' ' '; } >page.yml
lines 'no/such/file@.yml' >missing.txt
yes gold | head -n "$tenth" >golds.txt
{ echo id,function,inputs; lines 'a@,srgb_u8,x=0.04'; } >eval.csv
awk -v n="$n" 'BEGIN { srand(1); for (i = 0; i < n; i++) print int(1 + 64 * rand()), int(1 + 64 * rand()) }' >rects.txt
listed '{"schema":"etak-baseline/1","findings":[' '{"rule":"ETK101","file":"f@.png"}' ']}' "$n" >baseline.json
echo 'wavelength_nm,n,k
380,1.5,0.1
780,1.5,0.1' >small.csv
listed '{"schema":"etak-atlas-manifest/1","materials":[' \
  '{"name":"m@","diffuse":[0.5,0.5,0.5],"specular":[0.04,0.04,0.04],"gloss":0.5}' ']}' "$tenth" >manifest.json
asset='{"asset":{"version":"2.0"},"scene":0,'
listed "$asset"'"scenes":[{"nodes":[0]}],"nodes":[' '{}' ']}' "$n" >nodes.gltf
listed "$asset"'"scenes":[{}],"materials":[' '{"name":"m@"}' ']}' "$n" >materials.gltf
listed "$asset"'"scenes":[{}],"images":[' '{"uri":"i@.png"}' ']}' "$n" >images.gltf

row() {  # row WHAT ARGUMENTS...
  what=$1
  shift
  status=0
  command time -f '%U %S %M' -o spent "$etak" "$@" >printed 2>told || status=$?
  tail -n 1 spent | awk -v what="$what" -v status="$status" -v line="$*" '{
    printf "| %s | `etak %s` | %.1f s | %d MB | %d |\n", what, line, $1 + $2, $3 / 1024, status }'
}
echo '| what | command | processor | memory | exit |'
echo '| --- | --- | --- | --- | --- |'
row "$n objects of JSON, refused" f0 objects.json
row "$n rows of a table" f0 rows.csv
row "$n rows of a page" f0 page.yml
row "$n names of a list, none there" f0 --files-from missing.txt
row "$n names of a list, none there" validate --no-config --files-from missing.txt
row "$tenth names of a list, all answered" f0 --files-from golds.txt --format csv
row "$n rows of formulas" eval --csv eval.csv
row "$n rectangles" pack --rects --in rects.txt --out placed.txt --mode strip:16384
row "$n known findings" validate --no-config small.csv --baseline baseline.json
row "$n nodes" validate --no-config nodes.gltf
row "$n materials of a scene" validate --no-config materials.gltf
row "$n images of a scene" validate --no-config images.gltf
row "$tenth materials of a manifest" pack manifest.json --out atlas --report none -q

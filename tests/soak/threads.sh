#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# threads.sh BIN: f0, validate and pack on eight threads, with programs that were built with the thread sanitizer; the
# first race ends it with status 66 and the sanitizer's report. BIN: the folder of etak.
set -eu
bin=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
corpus=$here/../fuzz/corpus
work=$(mktemp -d -t etak-threads.XXXXXX)
trap 'rm -rf "$work"' EXIT
TSAN_OPTIONS="suppressions=$here/races.supp halt_on_error=1 exitcode=66 second_deadlock_stack=1 print_suppressions=0"
XDG_CONFIG_HOME=$work/config
export TSAN_OPTIONS XDG_CONFIG_HOME
cd "$work"

# Runs etak; of its ends only those that a sanitizer or a signal makes count here.
etak() {
  status=0
  "$bin/etak" "$@" >out 2>err || status=$?
  case $status in
    0 | 1 | 2) ! grep -q "Sanitizer\|internal error" err || { cat err >&2; exit 66; } ;;
    *) echo "threads.sh: etak $*: status $status" >&2; cat err >&2; exit 66 ;;
  esac
}

python3 - "$here" "$work" <<'PYTHON'
import pathlib, random, sys
sys.path.insert(0, sys.argv[1])
from inputs import write_manifest
write_manifest(pathlib.Path(sys.argv[2]) / "in", random.Random(1), 300, 3)
PYTHON

# f0: the library, and a folder of which some files are refused.
etak f0 --all --all-datasets -j 8 --format json -o all.json
etak f0 --all -j 8 --format html -o all.html
cp -r "$corpus/material" "$corpus/table" "$corpus/rii_page" .
etak f0 material table rii_page -j 8 --format csv -o folder.csv
# validate: pictures, an atlas, data; with the cache and mask pictures; twice, so that the cache is read.
etak pack in/manifest.json --out atlas -j 8 --bleed --textures png,ktx2,dds --png-level small --fail-on never
etak validate in atlas material -j 8 --cache cache --mask mask --format json -o once.json --exit-zero --no-config
etak validate in atlas material -j 8 --cache cache --format html -o twice.html --exit-zero --no-config
# pack: again over the old atlas, from floats, a scene, and two at a time of a job file.
etak pack in/manifest.json --out atlas -j 8 --rotate 1 --page-form mixed --page-report page.html --fail-on never
[ ! -x "$bin/libetak-pictures.so" ] || etak pack in/manifest.json --out floats -j 8 --textures png,tiff --fail-on never
etak pack "$corpus/gltf/square.gltf" --out scene -j 8 --islands --fail-on never
printf '{"jobs": [{"input": "in/manifest.json", "out": "one"}, {"input": "in/manifest.json", "out": "two"}]}' >jobs.json
etak pack --batch jobs.json -j 8 --fail-on never
etak pack --rects --in "$here/rects.txt" --effort 20 --threads 8 -o rects.out
[ -s all.json ] && [ -s folder.csv ] && [ -s once.json ] && [ -s atlas/layout.json ] && [ -s rects.out ] ||
  { echo "threads.sh: something was not written" >&2; cat err >&2; exit 1; }

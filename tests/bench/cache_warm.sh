#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# cache_warm.sh ETAK READ_AND_HASH [PAIRS [ROUNDS]]: what a warm cache takes beside the reading and hashing of the same
# files.
#   READ_AND_HASH   the program of tests/bench/read_and_hash.cpp
#   PAIRS           of pictures of 4 kB; 50000, which are 100,000 pictures
#   ROUNDS          10: the two programs take turns, each with two threads, and the least of each counts, because other
#                   programs on the machine can only make a run longer
set -eu
etak=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
read_and_hash=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
pairs=${3:-50000}
rounds=${4:-10}
work=$(mktemp -d -t etak-cache.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 - "$pairs" <<'END'
import os, random, struct, sys, zlib
chance = random.Random(5)
noise = bytes(chance.randrange(90, 180) for _ in range(1 << 20))
def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
def png(rows):
    head = struct.pack(">IIBBBBB", 32, 32, 8, 6, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")
for i in range(int(sys.argv[1])):
    folder = f"t/{i // 100:03d}"
    os.makedirs(folder, exist_ok=True)
    at = chance.randrange(len(noise) - 4096)
    part = noise[at : at + 3072]
    colours = [b"".join(part[96 * y + 3 * x : 96 * y + 3 * x + 3] + b"\xff" for x in range(32)) for y in range(32)]
    mirrors = [b"".join(bytes([52 + (b & 7)] * 3 + [100 + (b & 31)]) for b in part[32 * y : 32 * y + 32]) for y in range(32)]
    for ending, rows in (("diff", colours), ("spec", mirrors)):
        with open(f"{folder}/m{i:05d}_{ending}.png", "wb") as file:
            file.write(png(rows))
END
seconds() {
  begin=$(date +%s.%N)
  "$@" >/dev/null 2>&1
  echo "$(date +%s.%N) $begin" | awk '{ printf "%.3f", $1 - $2 }'
}
check() { "$etak" validate t --no-config --exit-zero -q -j 2 --progress none "$@"; }
cold=$(seconds check --cache c)
"$etak" validate t --no-config -j 2 --format csv >alone.csv 2>/dev/null || true
"$etak" validate t --no-config -j 2 --format csv --cache c >warm.csv 2>/dev/null || true
cmp alone.csv warm.csv
for round in $(seq "$rounds"); do
  warm=$(seconds check --cache c)
  plain=$(seconds "$read_and_hash" t 2)
  echo "$warm $plain"
done | awk -v cold="$cold" 'NR == 1 || $1 < warm { warm = $1 } NR == 1 || $2 < plain { plain = $2 }
  END { printf "first run %.2f s; warm cache %.2f s; reading and hashing alone %.2f s: %.2f times\n", cold, warm, plain, warm / plain }'
echo "load of the machine: $(cut -d ' ' -f 1-3 /proc/loadavg)"

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""growth.py ETAK [CASE...]: checks the processor time of every verb over four doublings of its input.

The limits are those of tests/growth.h: 16 times as many things may take 64 times as long; work that compares
each thing with each takes 256 times. Times below `shortest` count as `shortest`. The time of the same command
on a single thing is subtracted. A case that seems to grow too fast is measured again, because a busy machine
can only add to a time.
"""
import base64
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import zlib

shortest = 0.01
most = 64
etak = os.path.abspath(sys.argv[1])
table = "wavelength_nm,n,k\n380,1.5,0.1\n780,1.5,0.1\n"


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def lines(path, count, line):
    write(path, "".join(line(i) + "\n" for i in range(count)))


def table_files(count, folder="tables"):
    os.mkdir(folder)
    for i in range(count):
        write(f"{folder}/t{i}.csv", table)


def flat(i):
    return {"name": f"m{i}", "diffuse": [0.5, 0.5, 0.5], "specular": [0.04, 0.04, 0.04], "gloss": (i % 97) / 97}


# By name: the smallest number of things, the allowed exit statuses, and make(count), which makes so many
# things in the working folder and returns the arguments of etak.
cases = {}


def case(count, *statuses):
    def add(make):
        cases[make.__name__] = (count, (0,) + statuses, make)
        return make
    return add


@case(120)
def f0_folder(n):
    table_files(n)
    return ["f0", "tables", "--format", "json"]


@case(100)
def f0_list_of_names(n):
    lines("list", n, lambda i: "gold")
    return ["f0", "--files-from", "list", "--format", "csv"]


@case(1500, 2)
def f0_list_of_nothing(n):
    lines("list", n, lambda i: f"no/such{i}.yml")
    return ["f0", "--files-from", "list"]


@case(20000, 2)
def f0_long_name(n):
    write("list", "a" * n + "\n")
    return ["f0", "--files-from", "list"]


@case(8000)
def eval_rows(n):
    lines("rows.csv", n + 1, lambda i: f"a{i},srgb_u8,x=0.04" if i else "id,function,inputs")
    return ["eval", "--csv", "rows.csv"]


@case(2000)
def eval_refused(n):
    lines("rows.csv", n + 1, lambda i: f"a{i},nothing,x=0.04" if i else "id,function,inputs")
    return ["eval", "--csv", "rows.csv"]


@case(120)
def import_tables(n):
    table_files(n)
    return ["import"] + [f"tables/t{i}.csv" for i in range(n)] + ["--id", "one", "--class", "metal"]


@case(120)
def import_one_table(n):
    write("t.csv", table)
    return ["import"] + ["t.csv"] * n + ["--class", "metal"]


@case(100)
def list_library(n):
    write("t.csv", table)
    made = subprocess.run([etak, "import", "t.csv", "--id", "m0", "--class", "metal"], capture_output=True, text=True)
    os.makedirs("library/metal")
    for i in range(n):
        write(f"library/metal/m{i}.json", made.stdout.replace('"m0"', f'"m{i}"'))
    return ["list", "--library", "library"]


@case(150)
def list_names(n):
    lines("list", n, lambda i: "gold" if i % 2 else "Au")
    return ["list", "--names-from", "list", "--format", "json"]


@case(100)
def export_folder(n):
    table_files(n)
    return ["export", "tables", "--to", "mtlx"]


@case(150)
def pack_manifest(n):
    write("m.json", json.dumps({"materials": [flat(i) for i in range(n)]}))
    return ["pack", "m.json", "--out", "atlas", "--report", "json"]


@case(4000)
def pack_constants_kept(n):
    write("m.json", json.dumps({"materials": [flat(i) for i in range(n)]}))
    return ["pack", "m.json", "--out", "atlas", "--keep", "constant", "--report", "none", "--no-validate"]


@case(10, 2)
def pack_batch(n):
    write("m.json", json.dumps({"materials": [flat(0)]}))
    jobs = [{"input": "m.json" if i % 4 == 0 else f"none{i}.json", "out": f"atlas{i}"} for i in range(n)]
    write("jobs.json", json.dumps({"jobs": jobs}))
    return ["pack", "--batch", "jobs.json", "--no-validate"]


@case(6000)
def pack_rects(n):
    lines("rects", n, lambda i: f"{1 + i * 7919 % 61} {1 + i * 104729 % 59}")
    return ["pack", "--rects", "--in", "rects", "--out", "placed", "--mode", "pages:256"]


@case(800, 2)
def validate_list(n):
    write("t.csv", table)
    lines("list", n, lambda i: "t.csv" if i % 2 else f"none{i}.csv")
    return ["validate", "--no-config", "--files-from", "list", "--format", "json"]


@case(80)
def validate_folder(n):
    table_files(n)
    return ["validate", "--no-config", "tables"]


@case(80)
def validate_shard(n):
    table_files(n)
    return ["validate", "--no-config", "tables", "--shard", "1/2", "--format", "json"]


@case(80)
def merge_shards(n):
    table_files(n)
    for part in ("1", "2"):
        subprocess.run([etak, "validate", "--no-config", "tables", "--shard", part + "/2", "--format", "json", "-q",
                        "-o", part + ".json"], check=True)
    return ["merge", "1.json", "2.json", "--format", "json"]


def scene(n, material, more):
    """A triangle for each of n materials."""
    floats = struct.pack("<15f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1)
    view = {"bufferView": 0, "componentType": 5126, "count": 3}
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(n))}],
        "nodes": [{"mesh": i} for i in range(n)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": i}]} for i in range(n)],
        "materials": [material(i) for i in range(n)],
        "buffers": [{"byteLength": 60, "uri": "data:;base64," + base64.b64encode(floats).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
        "accessors": [dict(view, type="VEC3", min=[0, 0, 0], max=[1, 1, 0]), dict(view, type="VEC2", bufferView=1)],
    }
    write("s.gltf", json.dumps(dict(document, **more)))


def write_png(path, side, seed=0):
    hue = 0 if path.endswith("_gloss.png") else 11  # a picture of one number a texel is grey
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes((x * 37 + y * 59 + c * hue + seed) * (seed + 1) % 199 for x in range(side) for c in range(3))
                    for y in range(side))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def textured(i):
    return {"name": f"m{i}", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0,
                                                      "roughnessFactor": 0.3 + 0.4 * i / (i + 9)}}


def pictures(n):
    os.mkdir("pictures")
    for i in range(n):
        for role in ("diffuse", "specular", "gloss"):
            write_png(f"pictures/m{i}_{role}.png", 4 + i % 5, i)


@case(30)
def validate_pictures(n):
    pictures(n)
    return ["validate", "--no-config", "pictures"]


@case(20)
def validate_tiles(n):
    # The tiles belong to one UDIM set, which has one entry in the report.
    os.mkdir("pictures")
    for i in range(n):
        for role in ("BaseColor", "Roughness"):
            write_png(f"pictures/hull_{role}_u{1 + i % 99}_v{1 + i // 99}.png", 4, i)
    return ["validate", "--no-config", "pictures", "--exit-zero"]


@case(20)
def pack_folder(n):
    pictures(n)
    return ["pack", "pictures", "--out", "atlas", "--no-validate", "--report", "none"]


textures = {"textures": [{"source": 0}], "images": [{"uri": "p.png"}]}


@case(200, 1)
def validate_scene(n):
    write_png("p.png", 4)
    scene(n, textured, textures)
    return ["validate", "--no-config", "s.gltf", "--format", "json"]


@case(30)
def validate_masks(n):
    # The materials have findings and the same name, so that every mask needs another name for its file.
    scene(n, lambda i: {"name": "m", "pbrMetallicRoughness": {"baseColorFactor": [0.3 + i / 1e6, 0.3, 0.3, 1]}}, {})
    return ["validate", "--no-config", "s.gltf", "--mask", "masks", "--exit-zero"]


@case(60)
def pack_scene(n):
    write_png("p.png", 4)
    scene(n, textured, textures)
    return ["pack", "s.gltf", "--out", "atlas", "--no-validate", "--report", "none"]


@case(2, 1)
def choose_scene(n):
    write_png("p.png", 4)
    scene(n, textured, textures)
    return ["choose", "s.gltf"]


def seconds(name, count):
    """The processor time in seconds of a case with `count` things."""
    _, statuses, make = cases[name]
    with tempfile.TemporaryDirectory(prefix="etak-growth.") as folder:
        home = os.getcwd()
        os.chdir(folder)
        try:
            arguments = make(count)
            with open("printed", "wb") as printed:
                child = subprocess.Popen([etak] + arguments, stdout=printed, stderr=printed, stdin=subprocess.DEVNULL)
                _, status, usage = os.wait4(child.pid, 0)
                child.returncode = os.waitstatus_to_exitcode(status)
            if child.returncode not in statuses:
                with open("printed", errors="replace") as printed:
                    sys.exit(f"{name} of {count}: exit status {child.returncode}: {printed.read(500)}")
        finally:
            os.chdir(home)
        return usage.ru_utime + usage.ru_stime


def main():
    failed = False
    for name in sys.argv[2:] or cases:
        fewest = cases[name][0]
        for attempt in range(3):
            least = seconds(name, 1)
            times = [max(0, seconds(name, fewest << k) - least) for k in range(5)]
            growth = times[-1] / max(shortest, times[0])
            if growth <= most:
                break
        exponent = math.log2(times[-1] / max(shortest, times[0]) or 1) / 4
        print(f"{name}, {fewest} and doubled: " + " ".join(f"{t:.3f}" for t in times) + f" s, exponent {exponent:.2f}",
              flush=True)
        if growth > most:
            print(f"  grows {growth:.0f} times, expected at most {most}")
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: Apache-2.0
"""make_assets.py pairs DIR COUNT [SEED] | scenes DIR COUNT: generated inputs for the tests of many machines.

pairs    COUNT texture pairs of 16 to 64 texels a side in folders of 100, some with defects, some alone, one damaged
scenes   COUNT glTF scenes with two materials and textures of their own, and a file of jobs for etak pack --batch
The same arguments give the same bytes."""
import json
import os
import random
import struct
import sys
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(side, channels, texel):
    rows = b"".join(b"\0" + bytes(c for x in range(side) for c in texel(x, y)) for y in range(side))
    kind = {1: 0, 3: 2, 4: 6}[channels]
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, kind, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def write(path, data):
    with open(path, "wb") as out:
        out.write(data)


def pairs(folder, count, seed):
    pick = random.Random(seed)
    # A few hundred pictures are drawn, and each pair takes two of them: to draw all would take minutes.
    diffuse = {}
    specular = {}
    for side in (16, 32, 64):
        for n in range(12):
            base = pick.randint(60, 160)
            noise = random.Random(n)
            diffuse[side, n] = png(side, 4, lambda x, y: (base, base - 10, base - 20 + noise.randint(0, 9), 255))
            f0 = pick.choice([56, 56, 56, 60, 170, 168, 0, 255, 235])
            specular[side, n] = png(side, 4, lambda x, y: (f0, f0, f0 if n % 5 else max(0, f0 - 40),
                                                           noise.randint(100, 140)))
    for i in range(count):
        where = os.path.join(folder, f"set{i // 100:04d}")
        os.makedirs(where, exist_ok=True)
        side = pick.choice([16, 16, 32, 64])
        name = os.path.join(where, f"prop{i:06d}")
        write(name + "_diff.png", diffuse[side, pick.randrange(12)])
        if i % 997 != 500:  # else a set without its companion
            write(name + "_spec.png", specular[side, pick.randrange(12)])
    if count > 7:
        with open(os.path.join(folder, "set0000", "prop000007_spec.png"), "r+b") as damaged:
            damaged.truncate(60)
    write(os.path.join(folder, "set0000", "palette.png"), png(16, 3, lambda x, y: (x, y, 0)))
    write(os.path.join(folder, "set0000", "notes.txt"), b"no picture\n")


def scenes(folder, count):
    corners = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)
    uvs = struct.pack("<8f", 0, 0, 1, 0, 1, 1, 0, 1)
    buffer = corners + uvs + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    jobs = []
    os.makedirs(os.path.join(folder, "out"), exist_ok=True)
    for i in range(count):
        name = f"scene{i:04d}"
        where = os.path.join(folder, name)
        os.makedirs(where, exist_ok=True)
        noise = random.Random(i)
        write(os.path.join(where, "mesh.bin"), buffer)
        for m in (0, 1):
            write(os.path.join(where, f"color{m}.png"),
                  png(32, 4, lambda x, y: (noise.randint(80, 140), 90, 40 + (i + m) % 100, 255)))
            write(os.path.join(where, f"rough{m}.png"), png(32, 3, lambda x, y: (0, noise.randint(100, 200), 0)))
        write(os.path.join(where, "scene.gltf"), json.dumps({
            "asset": {"version": "2.0"},
            "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "buffers": [{"uri": "mesh.bin", "byteLength": len(buffer)}],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                           "min": [0, 0, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                          {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
            "images": [{"uri": f"{kind}{m}.png"} for m in (0, 1) for kind in ("color", "rough")],
            "textures": [{"source": s} for s in range(4)],
            "materials": [{"name": f"part{m}", "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 2 * m}, "metallicRoughnessTexture": {"index": 2 * m + 1}}}
                          for m in (0, 1)],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": m}
                                       for m in (0, 1)]}]}).encode())
        jobs.append({"input": name + "/scene.gltf", "out": "out/" + name})
    write(os.path.join(folder, "jobs.json"),
          (json.dumps({"schema": "etak-pack-jobs/1", "jobs": jobs}, indent=1) + "\n").encode())


what, folder, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
os.makedirs(folder, exist_ok=True)
if what == "pairs":
    pairs(folder, count, int(sys.argv[4]) if len(sys.argv) > 4 else 1)
else:
    scenes(folder, count)

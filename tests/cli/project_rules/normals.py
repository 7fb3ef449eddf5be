"""Writes wall_normal.png, a wavy surface whose green points down, and scene.gltf, which reads it and the set."""
import base64
import json
import math
import pathlib
import struct
import zlib

SIDE = 128


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


rows = b""
for y in range(SIDE):
    rows += b"\0"
    for x in range(SIDE):
        # The height is a product, so that the surface is twisted.
        u = -0.5 * math.cos(x / 9) * math.sin(y / 11)
        v = -0.5 * math.sin(x / 9) * math.cos(y / 11)
        length = math.sqrt(u * u + v * v + 1)
        rows += bytes(round(127.5 + 127.5 * c / length) for c in (u, v, 1))
head = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 2, 0, 0, 0)
pathlib.Path("wall_normal.png").write_bytes(
    b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))

points = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
uvs = struct.pack("<6f", 0, 0, 1, 0, 0, 1)
uri = "data:application/octet-stream;base64," + base64.b64encode(points + uvs).decode()
scene = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "materials": [{
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
        "normalTexture": {"index": 2},
    }],
    "textures": [{"source": 0}, {"source": 1}, {"source": 2}],
    "images": [{"uri": "wall_basecolor.png"}, {"uri": "wall_orm.png"}, {"uri": "wall_normal.png"}],
    "buffers": [{"byteLength": 60, "uri": uri}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
    ],
}
pathlib.Path("scene.gltf").write_text(json.dumps(scene))

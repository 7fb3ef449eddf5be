# SPDX-License-Identifier: Apache-2.0
"""Inputs that the harnesses make themselves: small pictures, manifests, and bytes changed at random."""
import json
import struct
import zlib
from pathlib import Path


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, channels, random, level=1):
    """A PNG of noise, 8 bits, 1, 3 or 4 channels; with level 0 it is stored and as large as its texels."""
    texels = random.randbytes(width * channels * height)
    return png_of(width, height, channels, texels, level)


def png_of(width, height, channels, texels, level=1):
    """The PNG of these texels, row by row."""
    row = width * channels
    rows = b"".join(b"\0" + texels[y * row:(y + 1) * row] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + png_chunk(b"IDAT", zlib.compress(rows, level)) +
            png_chunk(b"IEND", b""))


def png_checksums(data):
    """The same file with the checksum of every chunk put right, so that what lies behind them is reached."""
    out, at = bytearray(data[:8]), 8
    while at + 12 <= len(data):
        size = struct.unpack(">I", data[at:at + 4])[0]
        if at + 12 + size > len(data):
            break
        out += png_chunk(data[at + 4:at + 8], data[at + 8:at + 8 + size])
        at += 12 + size
    return bytes(out) + data[at:]


def write_manifest(folder, random, side=64, materials=3):
    """A manifest of `materials` with pictures of noise; its path."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for i in range(materials):
        for role, channels in (("diffuse", 3), ("specular", 3), ("gloss", 1)):
            (folder / f"m{i}_{role}.png").write_bytes(png(side, side, channels, random))
        rows.append({"name": f"m{i}", "diffuse": f"m{i}_diffuse.png",
                     "specular": f"m{i}_specular.png", "gloss": f"m{i}_gloss.png"})
    rows.append({"name": "gold", "specular": "gold", "gloss": 0.8})
    path = folder / "manifest.json"
    path.write_text(json.dumps({"materials": rows}))
    return path


MAGIC = [b"0", b"-1", b"1e999", b"NaN", b"null", b"{}", b"[]", b"\"\"", b"\\u0000", b"\x00", b"\xff\xfe",
         b"\xef\xbb\xbf", b"4294967296", b"-2147483649", b"9" * 40, b"[" * 80, b"../../x", b"/dev/zero", b"\x1b[2J",
         b"\n", b",", b":", b"\xe2\x80\xae", b"true", b"1e-320", b"\x7f\xff\xff\xff", b"\xff\xff\xff\xff"]


def mutate(data, random, others=()):
    """`data` with one to six changes: bytes, pieces left out, doubled, of other files, words that parsers trip over."""
    out = bytearray(data)
    for _ in range(random.randint(1, 6)):
        at = random.randrange(len(out) + 1)
        kind = random.randrange(8)
        if kind == 0 and at < len(out):
            out[at] ^= 1 << random.randrange(8)
        elif kind == 1 and at < len(out):
            out[at] = random.randrange(256)
        elif kind == 2:
            del out[at:at + random.randint(1, 40)]
        elif kind == 3:
            out[at:at] = out[at:at + random.randint(1, 60)]
        elif kind == 4:
            out[at:at] = random.choice(MAGIC)
        elif kind == 5:
            magic = random.choice(MAGIC)
            out[at:at + len(magic)] = magic
        elif kind == 6 and others:
            other = random.choice(others)
            begin = random.randrange(len(other) + 1)
            out[at:at + random.randint(0, 40)] = other[begin:begin + random.randint(1, 80)]
        elif kind == 7 and random.random() < 0.2:
            del out[at:]
    return bytes(out[:1 << 16])

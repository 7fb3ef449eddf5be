# SPDX-License-Identifier: Apache-2.0
"""png.py NAME=CODES...: PNG files of 64 x 64 texels; CODES are 1 to 4 codes of 8 bits, with a range A-B for noise.

A name that ends with @X,Y,SIZE=CODES comes after its picture and draws a square into it."""
import random
import struct
import sys
import zlib

side = 64
random.seed(7)
pictures = {}


def value(code):
    low, _, high = code.partition("-")
    return random.randint(int(low), int(high or low))


for argument in sys.argv[1:]:
    name, codes = argument.split("=")
    name, _, square = name.partition("@")
    codes = codes.split(",")
    if not square:
        pictures[name] = [[[value(c) for c in codes] for _ in range(side)] for _ in range(side)]
    else:
        left, top, size = map(int, square.split(","))
        for y in range(top, top + size):
            for x in range(left, left + size):
                pictures[name][y][x] = [value(c) for c in codes]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


for name, rows in pictures.items():
    channels = len(rows[0][0])
    data = b"".join(b"\0" + bytes(v for texel in row for v in texel) for row in rows)
    with open(name, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" +
                  chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, {1: 0, 2: 4, 3: 2, 4: 6}[channels], 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))

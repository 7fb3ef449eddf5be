# SPDX-License-Identifier: Apache-2.0
"""middle.py NAMES...: whether the luminance code in the middle of each NAME.png (8-bit RGB) is the stated one +-3."""
import struct
import sys
import zlib

stated = {"neutral": 105}


def pixels(data):
    width, height, at, body = *struct.unpack(">II", data[16:24]), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            body += data[at + 8:at + 8 + size]
        at += 12 + size
    raw, rows = zlib.decompress(body), [bytearray(3 * width)]
    for y in range(height):
        line = bytearray(raw[y * (3 * width + 1):(y + 1) * (3 * width + 1)])
        kind, row = line[0], line[1:]
        for i in range(len(row)):
            left = row[i - 3] if i >= 3 else 0
            up, corner = rows[-1][i], rows[-1][i - 3] if i >= 3 else 0
            near = min((left, up, corner), key=lambda v: abs(left + up - corner - v))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, near)[kind]) & 255
        rows.append(row)
    return rows[1:]


def linear(code):
    return code / 255 / 12.92 if code <= 10 else ((code / 255 + 0.055) / 1.055) ** 2.4


def encoded(value):
    return 255 * (1.055 * value ** (1 / 2.4) - 0.055)


for name in sys.argv[1:]:
    rows = pixels(open(name + ".png", "rb").read())
    row = rows[len(rows) // 2]
    red, green, blue = (linear(c) for c in row[len(row) // 2:len(row) // 2 + 3])
    code = encoded(0.2126 * red + 0.7152 * green + 0.0722 * blue)
    wanted = stated.get(name, 118)
    print(name, wanted if abs(code - wanted) <= 3 else f"{code:.1f} instead of {wanted}")

# SPDX-License-Identifier: Apache-2.0
"""A reader of PNG files of 8 bits that shares no code with etak."""
import struct
import zlib


def read_png(name):
    """Rows of texels, each a bytearray of its channels."""
    data = open(name, "rb").read()
    width, height, bits, kind = struct.unpack(">IIBB", data[16:26])
    assert bits == 8
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[kind]
    at, packed = 8, b""
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        if data[at + 4:at + 8] == b"IDAT": packed += data[at + 8:at + 8 + size]
        at += 12 + size
    raw, rows, before = zlib.decompress(packed), [], bytes(width * channels)
    for y in range(height):
        line = bytearray(raw[y * (width * channels + 1):(y + 1) * (width * channels + 1)])
        how = line.pop(0)
        for x in range(len(line)):
            a, b = line[x - channels] if x >= channels else 0, before[x]
            c = before[x - channels] if x >= channels else 0
            near = min((a, b, c), key=lambda v: (abs(a + b - c - v), (a, b, c).index(v)))
            line[x] = (line[x] + (0, a, b, (a + b) // 2, near)[how]) & 255
        before = bytes(line)
        rows.append([line[x * channels:(x + 1) * channels] for x in range(width)])
    return rows

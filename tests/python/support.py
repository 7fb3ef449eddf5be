# SPDX-License-Identifier: Apache-2.0
"""What the tests of import etak share: pictures, and the program on the command line."""

import os
import re
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

PROGRAM = os.environ["ETAK"]  # the program `etak` of the same build


def png(path, width, height, texel):
    """Writes a PNG of 8-bit RGBA whose texel at x, y is texel(x, y)."""
    rows = b"".join(
        b"\0" + bytes(code for x in range(width) for code in texel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    Path(path).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def work_folder(folder):
    """Makes what the examples work on: textures/, and materials.json, a manifest."""
    folder = Path(folder)
    (folder / "textures").mkdir()
    png(folder / "textures/paint_diffuse.png", 64, 64, lambda x, y: (128, 40, 40, 255))
    # sRGB code 149 is a linear 0.30: inside the forbidden zone.
    png(folder / "textures/paint_specular.png", 64, 64, lambda x, y: (149, 149, 149, 128 + x % 2))
    (folder / "materials.json").write_text(
        '{"schema": "etak-atlas-manifest/1", "materials": [\n'
        '  {"name": "ring", "specular": "silver", "gloss": 0.7, "width": 96, "height": 64},\n'
        '  {"name": "paint", "diffuse": [0.5, 0.1, 0.1], "specular": 0.04, "gloss": 0.5, "width": 64, "height": 64}]}\n')


class InWorkFolder(unittest.TestCase):
    """Tests that run in a folder of their own, self.folder, which holds what work_folder() makes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        work_folder(self.folder)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)


def told(*words, cwd=None):
    """What the program says of its mistake, with its options as keywords: "illuminant: D66; expected ..."."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=cwd)
    last = [line for line in done.stderr.splitlines() if line.startswith("etak: ")][-1]
    return re.sub(r"--([a-z][a-z0-9-]*)", lambda m: m[1].replace("-", "_"), last[len("etak: "):])

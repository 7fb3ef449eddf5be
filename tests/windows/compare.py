#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""compare.py HERE THERE: whether two builds of etak say the same.

  HERE, THERE   two programs `etak`: that of this machine, and the one for Windows under Wine

Text must be equal at the printed digits, numbers of JSON within 1e-12 of their value, and pictures in their
pixels. Prints one line for each comparison and a count; the exit status is 1 where something differs.
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

CLOSE = 1e-12
TEXT = [
    "f0 --all", "f0 --all -v --format csv", "f0 --all --space acescg --format csv", "list", "list --format csv",
    "show gold", "show iron --format markdown", "models", "models --format csv", "eval --list",
    "nearest #ffd700 -n 20", "export gold copper water --to values", "export gold --to mtlx",
    "shader gold --model ggx-schlick --lights 2", "explain ETK", "stability", "completion bash", "help --man f0",
]
JSON = [
    "f0 --all --format json", "list --format json", "show gold --format json", "models --format json",
    "eval --list --format json", "nearest #ffd700 --format json", "explain ETK --format json",
]
MANIFEST = {"materials": [
    {"name": "metal", "specular": "gold", "gloss": 0.7},
    {"name": "wood", "diffuse": "wood.png", "specular": 0.04, "gloss": 0.3},
    {"name": "tile", "diffuse": [0.5, 0.2, 0.1], "specular": 0.05, "gloss": "tile.png"},
]}


def run(program, words, folder):
    done = subprocess.run([program, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True)
    return done.returncode, done.stdout, done.stderr


def difference(a, b, place=""):
    """The first place where two values of JSON differ; None where none does."""
    number = (int, float)
    if isinstance(a, number) and isinstance(b, number) and not isinstance(a, bool):
        close = a == b or abs(a - b) <= CLOSE * max(abs(a), abs(b))
        return None if close else f"{place}: {a!r} and {b!r}"
    if type(a) is not type(b):
        return f"{place}: {a!r} and {b!r}"
    if isinstance(a, dict):
        if list(a) != list(b):
            return f"{place}: other members"
        return next((d for key in a if (d := difference(a[key], b[key], f"{place}/{key}"))), None)
    if isinstance(a, list):
        if len(a) != len(b):
            return f"{place}: {len(a)} and {len(b)} entries"
        return next((d for i, (x, y) in enumerate(zip(a, b)) if (d := difference(x, y, f"{place}/{i}"))), None)
    return None if a == b else f"{place}: {a!r} and {b!r}"


def same_text(a, b):
    if a == b:
        return None
    lines = zip(a.decode().split("\n"), b.decode(errors="replace").split("\n"))
    return next((f"{x!r} and {y!r}" for x, y in lines if x != y), "one of them is longer")


def png(path, width, height, value):
    """Writes a picture of 8-bit RGB, of value(x, y)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in value(x, y)) for y in range(height))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def pixels(path):
    """The header and the unfiltered bytes of a PNG file."""
    data, at, head, packed = path.read_bytes(), 8, b"", b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        head, packed = (body if kind == b"IHDR" else head), packed + (body if kind == b"IDAT" else b"")
        at += 12 + length
    width, height, depth, colour = struct.unpack(">IIBB", head[:10])
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    step = max(1, channels * depth // 8)
    stride = (width * channels * depth + 7) // 8
    raw, before, out = zlib.decompress(packed), bytes(stride), []
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left = row[x - step] if x >= step else 0
            up, corner = before[x], before[x - step] if x >= step else 0
            guess = left + up - corner
            near = min((abs(guess - v), i) for i, v in enumerate((left, up, corner)))[1]
            row[x] = (row[x] + (0, left, up, (left + up) // 2, (left, up, corner)[near])[kind]) & 255
        out.append(bytes(row))
        before = bytes(row)
    return head, out


def main():
    here, there = (str(pathlib.Path(p).absolute()) for p in sys.argv[1:3])
    differing = compared = 0

    def tell(name, found):
        nonlocal differing, compared
        compared += 1
        differing += found is not None
        print(f"{name}: {'same' if found is None else found}", flush=True)

    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch)
        for line, of_json in [(line, False) for line in TEXT] + [(line, True) for line in JSON]:
            a, b = (run(program, line.split(), root) for program in (here, there))
            found = same_text(a[2], b[2]) if a[0] == b[0] else f"status {a[0]} and {b[0]}: {b[2][:200]!r}"
            if found is None:
                found = difference(json.loads(a[1]), json.loads(b[1])) if of_json else same_text(a[1], b[1])
            tell(f"etak {line}", found)
        png(root / "wood.png", 64, 64, lambda x, y: (90 + x, 60 + (x * y) % 40, 40))
        png(root / "tile.png", 32, 32, lambda x, y: (100 + 3 * x, 100 + 3 * x, 100 + 3 * x))
        (root / "m.json").write_text(json.dumps(MANIFEST))
        results = [run(p, ["pack", "m.json", "--out", out, "-q", "--fail-on", "never"], root)
                   for p, out in ((here, "here"), (there, "there"))]
        tell("etak pack", same_text(results[0][2], results[1][2]))
        names = [sorted(p.name for p in (root / out).glob("*")) for out in ("here", "there")]
        tell("names of the atlas", difference(*names))
        for name in names[0]:
            one, other = root / "here" / name, root / "there" / name
            if not other.exists():
                continue
            if name.endswith(".png"):
                tell(name, None if pixels(one) == pixels(other) else "other pixels")
            elif name.endswith(".json"):
                tell(name, difference(json.loads(one.read_bytes()), json.loads(other.read_bytes())))
            else:
                tell(name, same_text(one.read_bytes(), other.read_bytes()))
    print(f"compared with the program of this machine: {compared - differing} of {compared} the same")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())

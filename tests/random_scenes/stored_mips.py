#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""stored_mips.py ETAK COUNT [--seed N]: packs COUNT random scenes of islands into pages whose mips are stored, and compares
what triangles read there on each level that layout.json calls free of neighbours with the mips of the source. Of a third of
the scenes a part is packed before, whose islands must stay where they are (--previous). Shares no code with etak. A text is printed for each fault; ends with 1 where there is one, or where no island was packed by its outline.

Based on: Khronos Group, glTF 2.0, and KHR_materials_pbrSpecularGlossiness (archived); Microsoft, Programming Guide for DDS;
Toksvig 2005, with Olano and Baker 2010 (the variance of normals adds to the squared width of the lobe, twice)."""
import argparse
import json
import math
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from evaluate import CLAMP, DECODED, GLOSSY, MIRRORED, REPEAT, Scene, Texture, code, elements_of
from generate import Generator, png

# Of a code that is rounded once, from what is computed by single precision.
MOST = 1.01
# How far a texel may lie from where its own level has it, in texels: what floats of UVs lose.
DRIFT = 5e-3
DIFFUSE = GLOSSY["base"]


def charts(rng, count):
    """Fans and bands of triangles at places of their own: bands lie across, so that their boxes are mostly empty."""
    out = []
    for i in range(count):
        x, y = (i % 3 + rng.uniform(0.2, 0.8)) / 3, (i // 3 + rng.uniform(0.2, 0.8)) / 3
        if rng.random() < 0.7:
            length, turn, wide = rng.uniform(0.3, 0.8), rng.uniform(0, math.pi), rng.uniform(0.004, 0.02)
            dx, dy = math.cos(turn), math.sin(turn)
            row = [[x + t * length * dx + s * wide * dy, y + t * length * dy - s * wide * dx]
                   for t in (-0.5, -0.2, 0.1, 0.5) for s in (-1, 1)]
            out += [[row[i], row[i + 1], row[i + 2]] for i in range(len(row) - 2)]
        else:
            ring = [[x + r * math.cos(a), y + r * math.sin(a)] for a in [math.tau * k / 6 for k in range(6)]
                    for r in [rng.uniform(0.02, 0.1)]]
            out += [[[x, y], ring[k], ring[(k + 1) % 6]] for k in range(6)]
    return out


class Islands(Generator):
    """Materials of a pair of textures, two of three with normals, and triangles that read parts of them."""

    def picture(self, size, what):
        width, height = size
        rng, texels = self.rng, []
        waves = [(rng.uniform(0.1, 1.2), rng.uniform(0.1, 1.2), rng.uniform(0, 6)) for _ in range(4)]
        for y in range(height):
            for x in range(width):
                texel = [round(127.5 + 100 * math.sin(a * x + b * y + c) + rng.uniform(-25, 25)) for a, b, c in waves]
                if what == "normal":
                    texel = [128 + (v - 128) // 3 for v in texel[:2]] + [225]
                elif what == "diffuse" and texel[3] < 90:
                    texel[3] = 0
                texels.append(texel)
        name = f"{what}{len(self.root['images'])}.png"
        (self.folder / name).write_bytes(png(width, height, len(texels[0]), texels))
        self.root["images"].append({"uri": name})
        self.root["textures"].append({"source": len(self.root["images"]) - 1, "sampler": len(self.root["samplers"]) - 1})
        return {"index": len(self.root["textures"]) - 1}

    def material(self):
        size = self.rng.choice(((128, 128), (256, 128), (128, 256)))
        self.root["samplers"].append({"wrapS": self.rng.choice((REPEAT, MIRRORED, CLAMP)), "magFilter": 9729,
                                      "wrapT": self.rng.choice((REPEAT, MIRRORED, CLAMP)), "minFilter": 9987})
        m = {"name": f"m{len(self.root['materials'])}", "alphaMode": "BLEND"}
        self.extension(m, "KHR_materials_pbrSpecularGlossiness",
                       {"diffuseTexture": self.picture(size, "diffuse"),
                        "specularGlossinessTexture": self.picture(size, "gloss")})
        if self.maybe(0.67):
            m["normalTexture"] = self.picture(size, "normal")
        self.root["materials"].append(m)

    def write(self, share=1):
        """share: of the triangles, the first of each material's."""
        for index in range(self.rng.choice((1, 2))):
            self.material()
            # Some end at an edge of the picture, beyond which filtering reads what the sampler wraps to.
            corners = [[min(max(c, 0.0), 1.0) for c in uv]
                       for triangle in charts(self.rng, self.rng.choice((2, 4, 6))) for uv in triangle]
            corners = corners[:3 * math.ceil(share * (len(corners) // 3))]
            self.root["meshes"].append({"primitives": [{"material": index, "attributes": {
                "POSITION": self.accessor([[*uv, 0.0] for uv in corners], bounds=True),
                "TEXCOORD_0": self.accessor(corners)}}]})
        self.root["nodes"] = [{"mesh": i} for i in range(len(self.root["meshes"]))]
        self.root["scenes"], self.root["scene"] = [{"nodes": list(range(len(self.root["meshes"])))}], 0
        self.root["buffers"] = [{"uri": "scene.bin", "byteLength": len(self.buffer)}]
        self.root["extensionsUsed"] = sorted(self.used)
        (self.folder / "scene.bin").write_bytes(self.buffer)
        path = self.folder / "scene.gltf"
        path.write_text(json.dumps(self.root))
        return path


def read_dds(path):
    """Levels of rows of texels of four codes."""
    data = path.read_bytes()
    height, width, levels = struct.unpack_from("<II", data, 12) + struct.unpack_from("<I", data, 28)
    at, out = 148 if data[84:88] == b"DX10" else 128, []
    for _ in range(max(levels, 1)):
        out.append([[tuple(data[at + 4 * (y * width + x):at + 4 * (y * width + x) + 4]) for x in range(width)]
                    for y in range(height)])
        at += 4 * width * height
        width, height = max(1, width // 2), max(1, height // 2)
    return out


def halved(rows, mean):
    return [[mean([rows[2 * y + j][2 * x + i] for j in (0, 1) for i in (0, 1)]) for x in range(len(rows[0]) // 2)]
            for y in range(len(rows) // 2)]


def plain_mean(texels):
    return [sum(each) / len(texels) for each in zip(*texels)]


def weighted_mean(texels):
    """Of colours by alpha; the last value is the least alpha of level 0."""
    alpha, least = sum(t[3] for t in texels), min(t[4] for t in texels)
    if alpha == 0:
        return [*plain_mean(texels)[:4], least]
    return [sum(t[c] * t[3] for t in texels) / alpha for c in range(3)] + [alpha / len(texels), least]


class Mips:
    """The pair of a material of diffuse and F0 with gloss, and its mips in codes that are not rounded."""

    def __init__(self, scene, material):
        glossy = material["extensions"]["KHR_materials_pbrSpecularGlossiness"]

        def rows(info):
            return scene.picture(scene.root["textures"][info["index"]]["source"])

        self.texture = scene.texture(material, DIFFUSE)
        diffuse = [[[DECODED[v] for v in t[:3]] + [t[3] / 255] * 2 for t in row] for row in rows(glossy["diffuseTexture"])]
        gloss = [[[DECODED[v] for v in t[:3]] + [(1 - t[3] / 255) ** 4] for t in row]
                 for row in rows(glossy["specularGlossinessTexture"])]
        normal = None
        if "normalTexture" in material:
            normal = [[self.unit(t) for t in row] for row in rows(material["normalTexture"])]
        # By level: with the spread of the normals, and as a level is that is stored in the place of level 0.
        self.levels, self.stored = [], []
        while True:
            self.levels.append(self.codes(diffuse, gloss, normal if self.levels else None))
            self.stored.append(self.codes(diffuse, gloss, None))
            if min(len(diffuse), len(diffuse[0])) < 2:
                break
            diffuse, gloss = halved(diffuse, weighted_mean), halved(gloss, plain_mean)
            normal = normal and halved(normal, plain_mean)

    @staticmethod
    def unit(texel):
        v = [c / 127.5 - 1 for c in texel[:3]]
        length = math.hypot(*v)
        return [c / length for c in v]

    @staticmethod
    def codes(diffuse, gloss, normal):
        def of(x, y):
            d, s = diffuse[y][x], gloss[y][x]
            width = s[3]
            if normal:
                length = math.hypot(*normal[y][x])
                width = min(1, width + 2 * max(0.0, (1 - length) / length))
            return [code(v) for v in d[:3]] + [255 * d[3]], d[4] == 0, [code(v) for v in s[:3]] + [255 * (1 - width ** 0.25)]

        return [[of(x, y) for x in range(len(diffuse[0]))] for y in range(len(diffuse))]

    def at(self, level, x, y, stored):
        """Both textures' codes of a texel, as the sampler finds it, and whether a texel of alpha 0 has a part in it."""
        rows = (self.stored if stored else self.levels)[level]
        return rows[Texture.wrapped(y, len(rows), self.texture.wrap[1])][
            Texture.wrapped(x, len(rows[0]), self.texture.wrap[0])]


class Affine:
    """Takes UVs of the source to UVs of the page, from a triangle's corners in both; None for one without area."""

    @staticmethod
    def of(old, new):
        (ax, ay), (bx, by), (cx, cy) = old
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if abs(area) < 1e-7:
            return None

        def to(x, y):
            b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
            c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
            return [p + b * (q - p) + c * (r - p) for p, q, r in zip(*new)]

        return to


class Comparison:
    def __init__(self, bleed):
        self.bleed, self.texels, self.fewer, self.faults = bleed, 0, 0, []  # fewer: of islands with fewer texels
        self.wrap = CLAMP, CLAMP  # of the page
        self.by_level = {}

    def fault(self, text):
        if len(self.faults) < 3:
            self.faults.append(text)

    def place(self, mips, pages, rects, old, new, rng):
        """What one triangle reads at a few of its places."""
        to = Affine.of(old, new)
        if to is None:
            return
        width, height = len(pages[0][0][0]), len(pages[0][0])
        middle = [sum(c) / 3 for c in zip(*new)]
        rect = min(rects, key=lambda r: max(r["x"] - middle[0] * width, middle[0] * width - r["x"] - r["w"],
                                            r["y"] - middle[1] * height, middle[1] * height - r["y"] - r["h"]))
        fewer = (rect["crop"][2] // rect["h" if rect["rotated"] else "w"]).bit_length() - 1  # the level that is stored
        shares = [(1, 0, 0), (0, 1, 0), (0, 0, 1)] + [[-math.log(1 - rng.random()) for _ in range(3)] for _ in range(6)]
        for each in shares:
            u, v = (sum(s * p[c] for s, p in zip(each, old)) / sum(each) for c in (0, 1))
            for level in range(min(rect["mips"], len(pages[0]), len(mips.levels) - fewer)):
                self.level(mips, pages, level, fewer, u, v, to)

    def level(self, mips, pages, level, fewer, u, v, to):
        rows = mips.levels[fewer + level]
        across, down = len(rows[0]), len(rows)
        x, y = u * across - 0.5, v * down - 0.5
        left, top = math.floor(x), math.floor(y)
        for i, j in ((0, 0), (1, 0), (0, 1), (1, 1)):
            if abs(1 - i - (x - left)) < 1e-3 or abs(1 - j - (y - top)) < 1e-3:
                continue  # of no weight to speak of
            page_u, page_v = to((left + i + 0.5) / across, (top + j + 0.5) / down)
            column, row = page_u * len(pages[0][level][0]), page_v * len(pages[0][level])
            if max(abs(p - math.floor(p) - 0.5) for p in (column, row)) > DRIFT:
                self.fault(f"level {level}: texel {left + i}, {top + j} lies at {column:.4f}, {row:.4f}")
                continue
            diffuse, hidden, gloss = mips.at(fewer + level, left + i, top + j, level == 0)
            if hidden and self.bleed:
                continue  # its colours were filled from around it
            self.texels += 1
            self.fewer += fewer > 0
            self.by_level[level] = self.by_level.get(level, 0) + 1
            for name, page, codes in zip(("diffuse", "F0 and gloss"), pages, (diffuse, gloss)):
                rows = page[level]
                found = rows[Texture.wrapped(math.floor(row), len(rows), self.wrap[1])][
                    Texture.wrapped(math.floor(column), len(rows[0]), self.wrap[0])]
                if max(abs(a - b) for a, b in zip(found, codes)) > MOST:
                    self.fault(f"level {level}: {name} of texel {left + i}, {top + j} is {found}, expected "
                               f"{[round(c, 2) for c in codes]}")


def options_of(seed):
    rng = random.Random(f"{seed} options")
    out = ["--textures", "png,dds", "--gltf-form", "specular-glossiness", "--goal", "gpu"]
    if seed % 4 == 1:
        # Triangles of these scenes have as many texels for a unit as the picture has a side: half of them are enough. Of
        # the small pictures that are left outlines with wide gutters would be no less.
        out += ["--texel-density", "64", "--gutter", "1"]
    elif rng.random() < 0.75:
        out += ["--gutter", str(rng.choice((1, 2, 4, 8)))]
    if rng.random() < 0.3:
        out.append("--bleed")
    if rng.random() < 0.3:
        out += ["--rotate", "1"]
    return out


def shifts(layout):
    """Where the islands of several pieces lie: a shift of the picture to the page for each."""
    out = {}
    for r in layout["rects"]:
        x, y, w, h = r["crop"]
        shift = (r["x"] + y + h, r["y"] - x, True) if r["rotated"] else (r["x"] - x, r["y"] - y, False)
        out.setdefault((r["name"], r.get("island", 0)), []).append(shift)
    return {(name, of[0]) for (name, _), of in out.items() if len(of) > 1}


def pack(etak, source, out, options):
    command = [str(etak), "pack", str(source), "-o", str(out), "--no-validate", "-q", "-j", "1", *options]
    subprocess.run(command, check=True, timeout=60)
    return json.loads((out / "layout.json").read_text()), command


def check(etak, seed, folder):
    """Returns the comparison, how many outlines of several pieces there are, and how many of these stayed where they were."""
    options, earlier, stayed = options_of(seed), None, 0
    if seed % 3 == 0:
        (folder / "part").mkdir()
        earlier, _ = pack(etak, Islands(seed, folder / "part").write(0.6), folder / "earlier", options)
        options += ["--previous", str(folder / "earlier" / "layout.json"), "--extra-area", "100"]
    source = Islands(seed, folder).write()
    out = folder / "out"
    layout, command = pack(etak, source, out, options)
    before, after = Scene(source), Scene(out / "scene.gltf")
    if "--texel-density" in command and not shifts(layout):
        return Comparison(False), 0, 0, command  # mips of boxes are their own
    comparison, pages, rng = Comparison("--bleed" in command), {}, random.Random(seed)
    names = [(r["name"], r.get("island", 0)) for r in layout["rects"]]
    for old, new in zip(before.primitives(), after.primitives(), strict=True):
        material = before.root["materials"][old["material"]]
        rects = [r for r in layout["rects"] if r["name"] == material["name"]]
        page = rects[0]["page"]
        if page not in pages:
            pages[page] = [read_dds(out / f"page{page}_{texture}.dds") for texture in ("diffuse_alpha", "specular_gloss")]
        mips = Mips(before, material)
        written = after.texture(after.root["materials"][new["material"]], DIFFUSE)
        comparison.wrap = written.wrap
        if not any(i["uri"].startswith("page") and after.picture(k) is written.rows
                   for k, i in enumerate(after.root["images"])):
            continue  # it stays as it was
        was = before.accessor(old["attributes"]["TEXCOORD_0"])
        now = [[p / size for p, size in zip(written.place(uv), (written.width, written.height))]
               for uv in after.accessor(new["attributes"][f"TEXCOORD_{written.set}"])]
        for a, b in zip(elements_of(before, old), elements_of(after, new), strict=True):
            comparison.place(mips, pages[page], rects, [was[i] for i in a], [now[i] for i in b], rng)
    if earlier:
        stayed = len(shifts(earlier) & shifts(layout))
    return comparison, sum(names.count(name) > 1 for name in set(names)), stayed, command


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("etak", type=Path)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; each further one has the next number")
    args = parser.parse_args()
    texels = fewer = outlines = stayed = faults = 0
    by_level = {}
    for seed in range(args.seed, args.seed + args.count):
        with tempfile.TemporaryDirectory() as name:
            comparison, pieces, kept, command = check(args.etak, seed, Path(name))
        for text in comparison.faults:
            print(f"scene {seed}: {text}\n  {' '.join(command)}", flush=True)
        faults += len(comparison.faults)
        texels += comparison.texels
        fewer += comparison.fewer
        outlines += pieces
        stayed += kept
        for level, count in comparison.by_level.items():
            by_level[level] = by_level.get(level, 0) + count
    print(f"{args.count} scenes, {outlines} outlines, of which {stayed} stayed, {texels:,} texels compared ({fewer:,} of islands "
          f"with fewer; by level: {', '.join(str(by_level[k]) for k in sorted(by_level))}), {faults} faults")
    return 1 if faults or 0 in (outlines, stayed, fewer) or len(by_level) < 2 else 0


if __name__ == "__main__":
    sys.exit(main())

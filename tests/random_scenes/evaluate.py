# SPDX-License-Identifier: Apache-2.0
"""What the surfaces of a glTF scene look like, point by point, and how two scenes differ. Shares no code with etak.

Based on: Khronos Group, glTF 2.0 specification, appendix B; KHR_texture_transform, KHR_materials_ior, _specular, _unlit,
_variants, _pbrSpecularGlossiness (archived); MSFT_lod. Textures are read at level 0, colours filtered in linear light."""
import json
import math
import random
import struct
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from png_read import read_png  # noqa: E402

COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
FULL = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535}
REPEAT, MIRRORED, CLAMP, NEAREST = 10497, 33648, 33071, 9728
DECODED = [c / 255 / 12.92 if c / 255 <= 0.04045 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in range(256)]
PLAIN = [c / 255 for c in range(256)]
# Textures of a material in the order of which the first leads: path in the material, and whether its first three
# channels are colours.
SURFACE = {"base": (("pbrMetallicRoughness", "baseColorTexture"), True),
           "metal": (("pbrMetallicRoughness", "metallicRoughnessTexture"), False),
           "tint": (("extensions", "KHR_materials_specular", "specularColorTexture"), True),
           "strength": (("extensions", "KHR_materials_specular", "specularTexture"), False)}
GLOSSY = {"base": (("extensions", "KHR_materials_pbrSpecularGlossiness", "diffuseTexture"), True),
          "gloss": (("extensions", "KHR_materials_pbrSpecularGlossiness", "specularGlossinessTexture"), True)}
OTHERS = {"normal": (("normalTexture",), False), "occlusion": (("occlusionTexture",), False),
          "emissive": (("emissiveTexture",), True)}
MOST_CENTRES = 300  # of one element on one texture


def code(linear):
    """Of linear light; unrounded."""
    v = min(max(linear, 0.0), 1.0)
    return 255 * (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055)


def found(node, path):
    for key in path:
        node = node.get(key) if isinstance(node, dict) else None
    return node


class Scene:
    """A document with its buffers and PNG files beside it."""

    def __init__(self, path):
        self.folder = Path(path).parent
        self.root = json.loads(Path(path).read_text())
        self.buffers = [(self.folder / each["uri"]).read_bytes() for each in self.root.get("buffers", [])]
        self.pictures, self.read = {}, {}

    def view(self, index):
        view = self.root["bufferViews"][index]
        begin = view.get("byteOffset", 0)
        return self.buffers[view["buffer"]][begin:begin + view["byteLength"]], view.get("byteStride")

    def elements(self, view, offset, kind, width, count):
        data, stride = self.view(view)
        size = struct.calcsize("<" + FORMATS[kind]) * width
        return [struct.unpack_from("<" + FORMATS[kind] * width, data, offset + i * (stride or size))
                for i in range(count)]

    def accessor(self, index):
        """Tuples of numbers."""
        if index in self.read:
            return self.read[index]
        a = self.root["accessors"][index]
        kind, width = a["componentType"], COMPONENTS[a["type"]]
        out = [(0,) * width] * a["count"]
        if "bufferView" in a:
            out = self.elements(a["bufferView"], a.get("byteOffset", 0), kind, width, a["count"])
        if "sparse" in a:
            s = a["sparse"]
            places = self.elements(s["indices"]["bufferView"], s["indices"].get("byteOffset", 0),
                                   s["indices"]["componentType"], 1, s["count"])
            values = self.elements(s["values"]["bufferView"], s["values"].get("byteOffset", 0), kind, width, s["count"])
            out = list(out)
            for (place,), value in zip(places, values):
                out[place] = value
        if a.get("normalized"):
            out = [tuple(max(v / FULL[kind], -1.0) for v in each) for each in out]
        self.read[index] = out
        return out

    def picture(self, index):
        if index not in self.pictures:
            rows = read_png(self.folder / self.root["images"][index]["uri"])
            grown = {1: lambda t: (t[0], t[0], t[0], 255), 2: lambda t: (t[0], t[0], t[0], t[1]),
                     3: lambda t: (*t, 255), 4: tuple}
            self.pictures[index] = [[grown[len(t)](t) for t in row] for row in rows]
        return self.pictures[index]

    def primitives(self):
        for mesh in self.root["meshes"]:
            yield from mesh["primitives"]

    def texture(self, material, slot):
        path, colour = slot
        info = found(material, path)
        return None if info is None else Texture(self, info, colour)


class Texture:
    """One texture of a material, as a sampler reads it at level 0."""

    def __init__(self, scene, info, colour):
        texture = scene.root["textures"][info["index"]]
        sampler = scene.root["samplers"][texture["sampler"]] if "sampler" in texture else {}
        self.rows = scene.picture(texture["source"])
        self.width, self.height = len(self.rows[0]), len(self.rows)
        self.wrap = sampler.get("wrapS", REPEAT), sampler.get("wrapT", REPEAT)
        self.nearest = sampler.get("magFilter") == NEAREST
        self.tables = (DECODED if colour else PLAIN,) * 3 + (PLAIN,)
        self.set = info.get("texCoord", 0)
        moved = found(info, ("extensions", "KHR_texture_transform")) or {}
        self.set = moved.get("texCoord", self.set)
        (ox, oy), (sx, sy) = moved.get("offset", (0, 0)), moved.get("scale", (1, 1))
        c, s = math.cos(moved.get("rotation", 0)), math.sin(moved.get("rotation", 0))
        # A positive rotation turns counter-clockwise where v points down.
        self.matrix = (c * sx, s * sy, ox, -s * sx, c * sy, oy)

    def place(self, uv):
        """In texels."""
        a, b, c, d, e, f = self.matrix
        return (a * uv[0] + b * uv[1] + c) * self.width, (d * uv[0] + e * uv[1] + f) * self.height

    @staticmethod
    def wrapped(i, size, wrap):
        if wrap == CLAMP:
            return min(max(i, 0), size - 1)
        if wrap == REPEAT:
            return i % size
        i %= 2 * size
        return i if i < size else 2 * size - 1 - i

    def texel(self, x, y):
        row = self.rows[self.wrapped(y, self.height, self.wrap[1])]
        texel = row[self.wrapped(x, self.width, self.wrap[0])]
        return [table[value] for table, value in zip(self.tables, texel)]

    def at(self, uv):
        x, y = self.place(uv)
        if self.nearest:
            return self.texel(math.floor(x), math.floor(y))
        x, y = x - 0.5, y - 0.5
        left, top = math.floor(x), math.floor(y)
        u, v = x - left, y - top
        out = [0.0] * 4
        for i, j, share in ((0, 0, (1 - u) * (1 - v)), (1, 0, u * (1 - v)), (0, 1, (1 - u) * v), (1, 1, u * v)):
            if share > 0:
                out = [o + share * t for o, t in zip(out, self.texel(left + i, top + j))]
        return out

    def is_doubtful(self, uv):
        """Whether the place is so near to the border of a texel that rounding decides which is read."""
        return self.nearest and any(abs(p - round(p)) < 2e-3 for p in self.place(uv))


class Surface:
    """A material: what is seen where its textures are read at given UVs."""

    def __init__(self, scene, index):
        self.material = m = {} if index is None else scene.root["materials"][index]
        extensions = m.get("extensions", {})
        self.unlit = "KHR_materials_unlit" in extensions
        self.glossy = None if self.unlit else extensions.get("KHR_materials_pbrSpecularGlossiness")
        slots = GLOSSY if self.glossy is not None else {"base": SURFACE["base"]} if self.unlit else SURFACE
        self.leading = {key: t for key, slot in slots.items() if (t := scene.texture(m, slot)) is not None}
        self.textures = dict(self.leading)
        if not self.unlit:
            self.textures.update({key: t for key, slot in OTHERS.items() if (t := scene.texture(m, slot)) is not None})
        self.core = m.get("pbrMetallicRoughness", {})
        self.specular = extensions.get("KHR_materials_specular", {})
        self.ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)

    def look(self, uvs, colour):
        """Codes by name; colours as three."""
        t = {key: texture.at(uvs[texture.set]) for key, texture in self.textures.items()}
        white = [1.0] * 4
        base = t.get("base", white)
        if self.glossy is not None:
            base = [b * f * c for b, f, c in zip(base, self.glossy.get("diffuseFactor", white), colour)]
            f0 = [a * b for a, b in zip(t.get("gloss", white), self.glossy.get("specularFactor", (1, 1, 1)))]
            diffuse, lost = base[:3], max(f0)
            rough = 1 - t.get("gloss", white)[3] * self.glossy.get("glossinessFactor", 1)
        else:
            base = [b * f * c for b, f, c in zip(base, self.core.get("baseColorFactor", white), colour)]
            metal = t.get("metal", white)[2] * self.core.get("metallicFactor", 1)
            rough = t.get("metal", white)[1] * self.core.get("roughnessFactor", 1)
            scale = ((self.ior - 1) / (self.ior + 1)) ** 2
            tint = [a * b for a, b in zip(t.get("tint", white), self.specular.get("specularColorFactor", (1, 1, 1)))]
            weight = t.get("strength", white)[3] * self.specular.get("specularFactor", 1)
            dielectric = [min(scale * each, 1) * weight for each in tint]
            f0 = [d * (1 - metal) + b * metal for d, b in zip(dielectric, base)]
            diffuse, lost = [b * (1 - metal) for b in base[:3]], max(dielectric)
        out = {}
        if self.material.get("alphaMode", "OPAQUE") != "OPAQUE":
            out["alpha"] = [255 * base[3]]
        if self.unlit:
            out["base colour"] = [code(v) for v in base[:3]]
            return out
        out["diffuse"] = [code(v) for v in diffuse]
        out["F0"] = [code(v) for v in f0]
        if len({(each.width, each.height) for each in self.leading.values()}) < 2:
            out["diffuse light"] = [code(v * (1 - lost)) for v in diffuse]
        out["roughness"] = [255 * rough]
        normal = t.get("normal")
        out["normal"] = [0.0, 0.0, 0.0]
        if normal is not None:
            # 127 and 128 stand for flat: a texture that says so everywhere may be left out.
            out["normal"] = [255 * v - flat if abs(255 * v - flat) > 0.6 else 0.0
                             for v, flat in zip(normal, (127.5, 127.5, 255))]
        out["occlusion"] = [255 * t.get("occlusion", white)[0]]
        factor = self.material.get("emissiveFactor", (0, 0, 0))
        out["emissive"] = [code(v * f) for v, f in zip(t.get("emissive", white), factor)]
        return out


def elements_of(scene, primitive):
    """The vertices of points, lines and triangles, in the order in which they are drawn."""
    attributes = primitive["attributes"]
    count = scene.root["accessors"][attributes["POSITION"]]["count"]
    row = [i for i, in scene.accessor(primitive["indices"])] if "indices" in primitive else list(range(count))
    mode, n = primitive.get("mode", 4), len(row)
    return {0: lambda: [(row[i],) for i in range(n)],
            1: lambda: [(row[i], row[i + 1]) for i in range(0, n - 1, 2)],
            2: lambda: [(row[i], row[(i + 1) % n]) for i in range(n)] if n > 1 else [],
            3: lambda: [(row[i], row[i + 1]) for i in range(n - 1)],
            4: lambda: [(row[i], row[i + 1], row[i + 2]) for i in range(0, n - 2, 3)],
            5: lambda: [(row[i], row[i + 1 + i % 2], row[i + 2 - i % 2]) for i in range(n - 2)],
            6: lambda: [(row[i + 1], row[i + 2], row[0]) for i in range(n - 2)]}[mode]()


class Drawn:
    """The UVs and colours of a primitive's vertices, with its morph targets at one weight."""

    def __init__(self, scene, primitive, weight):
        self.attributes = {}
        for name, index in primitive["attributes"].items():
            if not name.startswith(("TEXCOORD_", "COLOR_0")):
                continue
            values = [list(v) for v in scene.accessor(index)]
            for target in primitive.get("targets", ()):
                if name in target:
                    values = [[a + weight * b for a, b in zip(v, d)] for v, d in zip(values, scene.accessor(target[name]))]
            self.attributes[name] = values

    def at(self, name, corners, shares):
        values = self.attributes.get(name)
        if values is None:
            return None
        return [sum(s * values[i][c] for i, s in zip(corners, shares)) for c in range(len(values[0]))]

    def uvs(self, corners, shares):
        return {s: self.at(f"TEXCOORD_{s}", corners, shares) or [0.0, 0.0] for s in range(8)}

    def colour(self, corners, shares):
        out = self.at("COLOR_0", corners, shares) or [1.0] * 4
        return out if len(out) == 4 else [*out, 1.0]


def centres(texture, corners, rng):
    """Shares of three corners, in texels, at which the texture's texel centres lie in their triangle."""
    (ax, ay), (bx, by), (cx, cy) = corners
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    if abs(area) < 1e-6:
        return []
    columns = range(math.ceil(min(ax, bx, cx) - 0.5), math.floor(max(ax, bx, cx) - 0.5) + 1)
    rows = range(math.ceil(min(ay, by, cy) - 0.5), math.floor(max(ay, by, cy) - 0.5) + 1)
    places = [(x, y) for y in rows for x in columns] if len(rows) * len(columns) <= 4000 else \
        [(rng.choice(columns), rng.choice(rows)) for _ in range(2000)]
    out = []
    for x, y in places:
        px, py = x + 0.5 - ax, y + 0.5 - ay
        b = (px * (cy - ay) - (cx - ax) * py) / area
        c = ((bx - ax) * py - px * (by - ay)) / area
        if b >= -1e-9 and c >= -1e-9 and b + c <= 1 + 1e-9:
            out.append((1 - b - c, b, c))
    return out if len(out) <= MOST_CENTRES else rng.sample(out, MOST_CENTRES)


def places_of(surface, drawn, corners, rng):
    """Where one element is compared: shares of its corners, and whether a texel centre of colour, metal, roughness or
    F0 lies there. Light behind F0 is a product, which no texture holds between texels: it counts at centres where all of
    these textures are of one size."""
    n = len(corners)
    out = [(tuple(float(i == j) for j in range(n)), False) for i in range(n)]
    if n == 1:
        return out
    for _ in range(4):
        parts = [rng.random() for _ in range(n)]
        out.append((tuple(p / sum(parts) for p in parts), False))
    if n == 3:
        for texture in surface.leading.values():
            uvs = [drawn.at(f"TEXCOORD_{texture.set}", (i,), (1.0,)) or [0.0, 0.0] for i in corners]
            out += [(each, True) for each in centres(texture, [texture.place(uv) for uv in uvs], rng)]
    return out


def surfaces_of(primitive, materials):
    """The materials of a primitive: its own, those of variants, and lower levels of detail of all of these."""
    out = [primitive.get("material")]
    out += [each["material"] for each in
            (found(primitive, ("extensions", "KHR_materials_variants")) or {}).get("mappings", ())]
    for index in list(out):
        if index is not None:
            out += (found(materials[index], ("extensions", "MSFT_lod")) or {}).get("ids", [])
    return out


class Difference:
    """The largest differences in codes of a material, by what they are of: at texel centres, and anywhere."""

    def __init__(self):
        self.at_centres, self.anywhere, self.texels, self.where = {}, {}, 0, {}

    def add(self, before, after, is_centre, where):
        self.texels += is_centre
        for what in before.keys() | after.keys():
            a, b = before.get(what), after.get(what)
            if what == "diffuse light" and (a is None or b is None):
                continue
            worst = 255.0 if a is None or b is None else max(abs(x - y) for x, y in zip(a, b))
            for to in (self.anywhere, self.at_centres) if is_centre else (self.anywhere,):
                if worst > to.get(what, -1):
                    to[what] = worst
                    if to is self.anywhere:
                        self.where[what] = where


def compare(before, after, seed=0):
    """By the name of a material: how a written scene differs from its source."""
    rng, out = random.Random(seed), {}
    old_materials, new_materials = before.root.get("materials", []), after.root.get("materials", [])
    for number, (old, new) in enumerate(zip(before.primitives(), after.primitives(), strict=True)):
        pairs = list(zip(surfaces_of(old, old_materials), surfaces_of(new, new_materials), strict=True))
        old_elements, new_elements = elements_of(before, old), elements_of(after, new)
        assert len(old_elements) == len(new_elements), f"primitive {number} draws {len(new_elements)} elements"
        for weight in (0, 1) if "targets" in old else (0,):
            was, now = Drawn(before, old, weight), Drawn(after, new, weight)
            for a, b in pairs:
                if a is None:
                    continue
                surface, written = Surface(before, a), Surface(after, b)
                difference = out.setdefault(old_materials[a].get("name", str(a)), Difference())
                for i, (corners, moved) in enumerate(zip(old_elements, new_elements)):
                    for shares, is_centre in places_of(surface, was, corners, rng):
                        uvs, new_uvs = was.uvs(corners, shares), now.uvs(moved, shares)
                        if any(t.is_doubtful(uvs[t.set]) for t in surface.textures.values()):
                            continue
                        difference.add(surface.look(uvs, was.colour(corners, shares)),
                                       written.look(new_uvs, now.colour(moved, shares)), is_centre,
                                       f"primitive {number} element {i} at {shares} weight {weight} uv {uvs[0]}")
    return out

# SPDX-License-Identifier: Apache-2.0
"""Random glTF scenes of everything that touches texels: transforms, wraps, UV sets, factors, vertex colours, unlit and
further extensions, variants, morph targets, sparse and quantised accessors, primitives of every mode, levels of detail,
instances and several scenes. One seed makes one scene."""
import json
import random
import struct
import zlib

FORMATS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535), 5125: ("I", 1), 5126: ("f", 1)}
NAMES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
SIZES = ((4, 4), (8, 8), (8, 8), (12, 8), (6, 10), (16, 16))


def png(width, height, channels, texels):
    """The bytes of a PNG file; `texels` are width * height lists of as many codes as there are channels."""
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    rows = b"".join(b"\0" + bytes(v for t in texels[y * width:(y + 1) * width] for v in t) for y in range(height))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Generator:
    def __init__(self, seed, folder):
        self.rng, self.folder = random.Random(seed), folder
        self.buffer = bytearray()
        self.root = {"asset": {"version": "2.0"}, "images": [], "textures": [], "samplers": [], "materials": [],
                     "accessors": [], "bufferViews": [], "meshes": [], "nodes": []}
        self.used, self.required = set(), set()
        self.contents = {}

    def maybe(self, chance):
        return self.rng.random() < chance

    # Buffers

    def view(self, data, stride=None):
        self.buffer += b"\0" * (-len(self.buffer) % 4)
        view = {"buffer": 0, "byteOffset": len(self.buffer), "byteLength": len(data)}
        if stride is not None:
            view["byteStride"] = stride
        self.buffer += data
        self.root["bufferViews"].append(view)
        return len(self.root["bufferViews"]) - 1

    def accessor(self, values, kind=5126, bounds=False):
        """Values are numbers, or shares of the full range for integers of more than one component."""
        width = len(values[0])
        letter, full = FORMATS[kind]
        normalized = kind != 5126 and width > 1
        whole = [[round(v * full) if normalized else v for v in each] for each in values]
        packed = [struct.pack("<" + letter * width, *each) for each in whole]
        stride = -(-len(packed[0]) // 4) * 4 if width > 1 else None
        if width > 1 and self.maybe(0.2):
            stride += 4
        out = {"componentType": kind, "count": len(values), "type": NAMES[width]}
        if normalized:
            out["normalized"] = True
        if width == 2 and len(values) > 2 and self.maybe(0.1):
            places = sorted(self.rng.sample(range(len(values)), 2))
            out["sparse"] = {"count": 2, "values": {"bufferView": self.view(b"".join(packed[i] for i in places))},
                             "indices": {"bufferView": self.view(struct.pack("<2H", *places)), "componentType": 5123}}
            packed = [bytes(len(p)) if i in places else p for i, p in enumerate(packed)]
        data = b"".join(p.ljust(stride or len(p), b"\0") for p in packed)
        out["bufferView"] = self.view(data, stride)
        if bounds:
            rounded = [[struct.unpack("<f", struct.pack("<f", v))[0] for v in each] for each in values]
            out["min"], out["max"] = [min(c) for c in zip(*rounded)], [max(c) for c in zip(*rounded)]
        self.root["accessors"].append(out)
        return len(self.root["accessors"]) - 1

    # Pictures

    def texels(self, width, height, style):
        """Four codes for each texel."""
        rng, out = self.rng, []
        a, b = ([rng.randrange(256) for _ in range(4)] for _ in range(2))
        for y in range(height):
            for x in range(width):
                if style == "noise":
                    out.append([rng.randrange(256) for _ in range(4)])
                elif style == "smooth":
                    t = (x + y) / (width + height - 1)
                    out.append([round(p + (q - p) * t) for p, q in zip(a, b)])
                elif style == "two":
                    out.append(list(a if (x // 2 + y // 2) % 2 else b))
                else:
                    out.append(list(a))
        return out

    def metal(self, texels):
        """Sets blue of a metal-rough picture."""
        style, rng = self.rng.choice(("none", "none", "all", "mask", "noise", "stripes")), self.rng
        for i, t in enumerate(texels):
            t[2] = {"none": 0, "all": 255, "mask": 255 * (i % 5 < 2), "noise": rng.randrange(256),
                    "stripes": 255 * (i // 8 % 2)}[style]
        return texels

    def image(self, size, what):
        known = self.contents.get((size, what))
        if known and self.maybe(0.3):
            return self.rng.choice(known)
        width, height = size
        texels = self.texels(width, height, self.rng.choice(("noise", "smooth", "two", "one")))
        channels = {"metal": 3, "normal": 3, "gloss": 4, "strength": 4}.get(what) or self.rng.choice((1, 2, 3, 3, 4, 4))
        if what == "metal":
            self.metal(texels)
        if what == "normal":
            texels = [[128 + (v - 128) // 3 for v in t[:2]] + [230] for t in texels]
        kept = {1: (0,), 2: (0, 3), 3: (0, 1, 2), 4: (0, 1, 2, 3)}[channels]
        index = len(self.root["images"])
        name = f"{what}{index}.png"
        (self.folder / name).write_bytes(png(width, height, channels, [[t[c] for c in kept] for t in texels]))
        self.root["images"].append({"uri": name})
        self.contents.setdefault((size, what), []).append(index)
        return index

    def sampler(self):
        wraps = (10497, 10497, 33648, 33071)
        out = {"wrapS": self.rng.choice(wraps), "wrapT": self.rng.choice(wraps)}
        if self.maybe(0.15):
            out.update(magFilter=9728, minFilter=self.rng.choice((9728, 9984)))
        elif self.maybe(0.5):
            out.update(magFilter=9729, minFilter=self.rng.choice((9729, 9987)))
        self.root["samplers"].append(out)
        return len(self.root["samplers"]) - 1

    def transform(self):
        rng, out = self.rng, {}
        if self.maybe(0.7):
            out["offset"] = [round(rng.uniform(-1, 1), 3) for _ in range(2)]
        if self.maybe(0.7):
            out["scale"] = [rng.choice((1, 2, 0.5, -1, 1.5)) for _ in range(2)]
        if self.maybe(0.4):
            out["rotation"] = rng.choice((0.5, 1.5707963267948966, -2.0))
        return out

    def info(self, what, like):
        """A texture; most lie where the others of the material lie."""
        size = like["size"] if self.maybe(0.8) else self.rng.choice(SIZES)
        sampler = like["sampler"] if self.maybe(0.95) else self.sampler()
        self.root["textures"].append({"source": self.image(size, what), "sampler": sampler})
        out = {"index": len(self.root["textures"]) - 1}
        if (uv_set := like["set"] if self.maybe(0.97) else 0) != 0:
            out["texCoord"] = uv_set
        moved = like["transform"] if self.maybe(0.97) else self.transform()
        if moved:
            out["extensions"] = {"KHR_texture_transform": dict(moved)}
            self.used.add("KHR_texture_transform")
        return out

    # Materials

    def factor(self, count):
        return [1 if self.maybe(0.3) else round(self.rng.random(), 3) for _ in range(count)]

    def extension(self, material, name, value):
        material.setdefault("extensions", {})[name] = value
        self.used.add(name)

    def core(self, like):
        core = {}
        if self.maybe(0.85):
            core["baseColorTexture"] = self.info("base", like)
        if self.maybe(0.7):
            core["metallicRoughnessTexture"] = self.info("metal", like)
        if self.maybe(0.3):
            core["baseColorFactor"] = self.factor(4)
        if self.maybe(0.6):
            core["metallicFactor"] = self.rng.choice((0, 0, 0.5, 1))
        if self.maybe(0.3):
            core["roughnessFactor"] = self.factor(1)[0]
        return core

    def glossy(self, material, like):
        out = {}
        if self.maybe(0.85):
            out["diffuseTexture"] = self.info("base", like)
        if self.maybe(0.7):
            out["specularGlossinessTexture"] = self.info("gloss", like)
        if self.maybe(0.4):
            out["diffuseFactor"], out["specularFactor"] = self.factor(4), self.factor(3)
            out["glossinessFactor"] = self.factor(1)[0]
        self.extension(material, "KHR_materials_pbrSpecularGlossiness", out)

    def material(self):
        like = {"size": self.rng.choice(SIZES), "sampler": self.sampler(), "set": int(self.maybe(0.15)),
                "transform": self.transform() if self.maybe(0.4) else {}}
        m = {"name": f"m{len(self.root['materials'])}"}
        kind = self.rng.choice(("core",) * 6 + ("glossy", "specular", "ior", "unlit"))
        if kind == "glossy":
            self.glossy(m, like)
        else:
            m["pbrMetallicRoughness"] = self.core(like)
        if kind == "specular":
            specular = {"specularFactor": self.factor(1)[0], "specularColorFactor": self.factor(3)}
            if self.maybe(0.4):
                specular["specularColorTexture"] = self.info("tint", like)
            if self.maybe(0.3):
                specular["specularTexture"] = self.info("strength", like)
            self.extension(m, "KHR_materials_specular", specular)
        if kind in ("ior", "specular") and self.maybe(0.6):
            self.extension(m, "KHR_materials_ior", {"ior": self.rng.choice((1.0, 1.33, 1.8, 2.4))})
        if kind == "unlit":
            self.extension(m, "KHR_materials_unlit", {})
        elif kind != "glossy" and self.maybe(0.15):
            self.extension(m, self.rng.choice(("KHR_materials_clearcoat", "KHR_materials_sheen")), {})
        for key, what, chance in (("normalTexture", "normal", 0.3), ("occlusionTexture", "occlusion", 0.25),
                                  ("emissiveTexture", "emissive", 0.2)):
            if self.maybe(chance):
                m[key] = self.info(what, like)
        if "emissiveTexture" in m:
            m["emissiveFactor"] = self.factor(3)
        if self.maybe(0.3):
            m["alphaMode"] = self.rng.choice(("MASK", "BLEND"))
        self.root["materials"].append(m)

    # Meshes

    def uvs(self, count):
        rng = self.rng
        low, high = rng.choice(((0, 1), (0.1, 0.9), (0.25, 0.5), (-0.7, 2.3), (1.1, 1.8), (-0.6, -0.1)))
        if count >= 4 and self.maybe(0.3):
            corner = ((low, low), (high, low), (high, high), (low, high))
            return [list(corner[i]) if i < 4 else [rng.uniform(low, high) for _ in range(2)] for i in range(count)]
        return [[rng.uniform(low, high) for _ in range(2)] for _ in range(count)]

    def uv_accessor(self, count):
        values, kind = self.uvs(count), 5126
        inside = all(0 <= v <= 1 for each in values for v in each)
        if inside and self.maybe(0.4):
            kind = self.rng.choice((5121, 5123, 5122))
            if kind == 5122:
                self.used.add("KHR_mesh_quantization")
                self.required.add("KHR_mesh_quantization")
        return self.accessor(values, kind)

    def primitive(self):
        rng = self.rng
        mode = rng.choice((4,) * 8 + (0, 1, 2, 3, 5, 6))
        count = rng.choice((4, 6, 8)) if mode != 4 else rng.choice((3, 4, 6, 9))
        out = {"mode": mode, "attributes": {
            "POSITION": self.accessor([[rng.uniform(-1, 1) for _ in range(3)] for _ in range(count)], bounds=True),
            "TEXCOORD_0": self.uv_accessor(count), "TEXCOORD_1": self.uv_accessor(count)}}
        if count == 4 and mode == 4 or self.maybe(0.4):
            row = [0, 1, 2, 0, 2, 3] if count == 4 and mode == 4 else \
                [rng.randrange(count) for _ in range(count - count % {1: 2, 4: 3}.get(mode, 1))]
            out["indices"] = self.accessor([[i] for i in row], rng.choice((5121, 5123, 5125)))
        if self.maybe(0.25):
            width = rng.choice((3, 4))
            white = self.maybe(0.2)
            colours = [[1.0 if white else rng.random() for _ in range(width)] for _ in range(count)]
            out["attributes"]["COLOR_0"] = self.accessor(colours, rng.choice((5126, 5121, 5123)))
        if self.maybe(0.12):
            name = rng.choice(("TEXCOORD_0", "TEXCOORD_0", "TEXCOORD_1"))
            out["targets"] = [{name: self.accessor([[rng.uniform(-0.5, 0.5) for _ in range(2)] for _ in range(count)]),
                               "POSITION": self.accessor([[rng.random() for _ in range(3)] for _ in range(count)],
                                                         bounds=True)}]
        out["material"] = rng.randrange(len(self.root["materials"]))
        return out

    def mesh(self):
        primitives = [self.primitive() for _ in range(self.rng.choice((1, 1, 2)))]
        # All primitives of a mesh have as many targets.
        if any("targets" in p for p in primitives):
            primitives = [next(p for p in primitives if "targets" in p)]
        self.root["meshes"].append({"primitives": primitives})

    def variants(self):
        self.root.setdefault("extensions", {})["KHR_materials_variants"] = {"variants": [{"name": "a"}, {"name": "b"}]}
        self.used.add("KHR_materials_variants")
        for mesh in self.root["meshes"]:
            if self.maybe(0.6):
                mappings = [{"material": self.rng.randrange(len(self.root["materials"])), "variants": [i]}
                            for i in range(self.rng.choice((1, 2)))]
                mesh["primitives"][0].setdefault("extensions", {})["KHR_materials_variants"] = {"mappings": mappings}

    def nodes(self):
        """Every mesh is reached: from the first scene, from another, or as a lower level of detail."""
        nodes, scenes = self.root["nodes"], [[]]
        for index in range(len(self.root["meshes"])):
            node = {"mesh": index}
            way = self.rng.choice(("plain",) * 6 + ("scene", "level", "copies"))
            if way == "copies":
                at = self.accessor([[self.rng.random() for _ in range(3)] for _ in range(2)])
                node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": at}}}
                self.used.add("EXT_mesh_gpu_instancing")
                self.required.add("EXT_mesh_gpu_instancing")
            if way == "level" and scenes[0]:
                above = nodes[scenes[0][0]].setdefault("extensions", {}).setdefault("MSFT_lod", {"ids": []})
                above["ids"].append(len(nodes))
                self.used.add("MSFT_lod")
            elif way == "scene" and scenes[0]:
                scenes.append([len(nodes)])
            else:
                scenes[0].append(len(nodes))
            nodes.append(node)
        self.root["scene"], self.root["scenes"] = 0, [{"nodes": each} for each in scenes]

    def levels_of_material(self):
        """The last material is a lower level of the first."""
        if len(self.root["materials"]) > 1 and self.maybe(0.1):
            self.extension(self.root["materials"][0], "MSFT_lod", {"ids": [len(self.root["materials"]) - 1]})

    def write(self):
        for _ in range(self.rng.choice((1, 2, 3, 4))):
            self.material()
        for _ in range(self.rng.choice((1, 2, 3))):
            self.mesh()
        if self.maybe(0.15):
            self.variants()
        self.levels_of_material()
        self.nodes()
        self.root["buffers"] = [{"uri": "scene.bin", "byteLength": len(self.buffer)}]
        (self.folder / "scene.bin").write_bytes(self.buffer)
        for key, names in (("extensionsUsed", self.used), ("extensionsRequired", self.required)):
            if names:
                self.root[key] = sorted(names)
        root = {key: value for key, value in self.root.items() if value != []}
        path = self.folder / "scene.gltf"
        path.write_text(json.dumps(root, indent=1))
        return path


def write_scene(seed, folder):
    """Writes the scene of a seed into a folder, which is there; returns the document's path."""
    return Generator(seed, folder).write()

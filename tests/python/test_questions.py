# SPDX-License-Identifier: Apache-2.0
"""nearest(), export(), eval() and delta_e() say what the command line says; what notebooks show; and names of the module."""
import importlib.util
import json
import subprocess
import tempfile
import unittest
import unittest.mock
import warnings
from pathlib import Path

import numpy as np

import etak
from support import PROGRAM, told


def said(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


class Questions(unittest.TestCase):
    def test_the_nearest_materials_are_those_of_the_command_line(self):
        for color, words, more in (("#ffe29b", ["#ffe29b"], {}), ((255, 226, 155), ["255,226,155"], {}),
                                   ([1.0, 0.76, 0.33], ["1.0,0.76,0.33", "--linear"], {"linear": True}),
                                   ("#808080", ["#808080", "--class", "surface"], {"classes": "surface"})):
            theirs = json.loads(said("nearest", *words, "-n", "4", "--format", "json"))["nearest"]
            mine = etak.nearest(color, count=4, **more)
            self.assertEqual([each.material.id for each in mine], [each["id"] for each in theirs])
            self.assertEqual([each.hex for each in mine], [each["hex"] for each in theirs])
            for each, other in zip(mine, theirs):
                self.assertEqual(each.band_share is None, other["band_share"] is None)
                if each.band_share is not None:
                    self.assertAlmostEqual(each.band_share, other["band_share"], places=6)
        theirs = json.loads(said("nearest", "gold/johnson-1972", "-n", "4", "--format", "json"))["nearest"]
        for asked in ("gold/johnson-1972", etak.read("gold/johnson-1972"), etak.f0("gold/johnson-1972")):
            mine = etak.nearest(asked, count=4)
            self.assertEqual([(each.material.id, each.hex) for each in mine], [(each["id"], each["hex"]) for each in theirs])
        for bad, text in (("blue", "blue"), ((1, 2), "shape"), ((1.5, 0, 0), "1.5 is no 8-bit code"), ((300, 0, 0), "300")):
            with self.subTest(bad), self.assertRaisesRegex(etak.Error, text):
                etak.nearest(bad)
        with self.assertRaises(etak.Error) as caught:
            etak.nearest("#ffffff", classes="metall")
        self.assertEqual(str(caught.exception), told("nearest", "#ffffff", "--class", "metall"))

    def test_what_a_colour_could_be_is_what_the_command_line_says(self):
        theirs = json.loads(said("identify", "#ffe29b", "--without", "gold/mcpeak-2015", "--format", "json"))["results"][0]
        mine = etak.identify("#ffe29b", without="gold/mcpeak-2015")
        self.assertEqual((mine.verdict, mine.groups), (theirs["verdict"], theirs["groups"]))
        self.assertEqual([(each.material.id, each.p, each.delta_e, each.band_share) for each in mine.candidates],
                         [(each["id"], each["p"], each["delta_e"], each["band_share"]) for each in theirs["candidates"]])
        self.assertEqual(etak.identify(["#ffe29b", (200, 60, 200)])[1].verdict, "none")
        self.assertEqual(etak.identify("gold").candidates[0].material.id, "gold")
        weighed = etak.identify([0.58, 0.56, 0.53], linear=True, classes="metal", prior={"iron": 1000})
        self.assertEqual(weighed.candidates[0].material.id, "iron")
        film = etak.identify("#5b3382", film="titanium")["answers"]
        self.assertEqual([(each["film"], round(each["thickness_nm"])) for each in film], [("titania_amorphous", 40)])
        for call, text in ((lambda: etak.identify(), "color: expected a colour"),
                           (lambda: etak.identify([1.2, 0, 0], linear=True), "0 to 1.1"),
                           (lambda: etak.identify("#ffe29b", prior={"wood9": 1}), "prior:2: wood9 is no material"),
                           (lambda: etak.identify("#ffe29b", without="gold"), "without: gold names no dataset"),
                           (lambda: etak.identify(measured="r.csv"), "measured: without stack")):
            with self.subTest(text), self.assertRaisesRegex(etak.Error, text):
                call()

    def test_f0_leaves_publications_out(self):
        self.assertNotEqual(etak.f0("titanium", without="titanium/johnson-1974").dataset, "johnson-1974")
        bands = [etak.f0("gold", without=names).band["publications"] for names in (None, ["gold/mcpeak-2015"])]
        self.assertEqual(bands[0] - 1, bands[1])

    def test_differences_are_those_of_ciede2000(self):
        self.assertEqual(etak.delta_e("#102030", "#102030"), 0)
        self.assertAlmostEqual(etak.delta_e("#ff0000", "#00ff00"), 86.6, places=1)
        gold = etak.f0("gold")
        near = etak.nearest(gold.srgb, linear=True, count=3)
        for each in near:
            self.assertAlmostEqual(etak.delta_e(gold, etak.f0(each.material)), each.delta_e, places=9)
        many = np.random.default_rng(1).random((4, 5, 3))
        out = etak.delta_e(many, "#808080")
        self.assertEqual(out.shape, (4, 5))
        self.assertEqual(out[1, 2], etak.delta_e(many[1, 2], "#808080"))
        with self.assertRaisesRegex(etak.Error, r"b: shape \(2,\); expected \(..., 3\)"):
            etak.delta_e(many, [1, 2])

    def test_formulas_are_those_of_the_command_line(self):
        for words in (["schueler_ksk", "theta_l=30", "theta_v=40", "phi_v=180", "K=0.04", "g=0.5"],
                      ["schlick", "f0=0.04", "cos=0.5"]):
            inputs = {name: float(value) for name, value in (each.split("=") for each in words[1:])}
            self.assertEqual(etak.eval(words[0], **inputs), float(said("eval", *words)))
        c = np.linspace(0, 1, 7)
        out = etak.eval("schlick", f0=[[0.04], [0.5]], cos=c)
        self.assertEqual(out.shape, (2, 7))
        self.assertEqual(out[1, 3], etak.eval("schlick", f0=0.5, cos=c[3]))
        self.assertEqual(etak.sources(), json.loads(said("sources", "--format", "json"))["rows"])
        self.assertEqual([each["id"] for each in etak.functions()],
                         [each["id"] for each in json.loads(said("eval", "--list", "--format", "json"))["functions"]])
        with self.assertRaises(etak.Error) as caught:
            etak.eval("schlick", f0=0.04)
        self.assertEqual(str(caught.exception), told("eval", "schlick", "f0=0.04"))
        for name, inputs in (("schlik", {"f0": 1}), ("schlick", {"f0": 1, "cos": 3}), ("schlick", {"f0": 1, "cos": 1, "x": 1})):
            with self.assertRaises(etak.Error):
                etak.eval(name, **inputs)

    def test_curves_and_plots_are_those_of_the_command_line(self):
        warnings.simplefilter("ignore")
        for words, call in {
                ("gold", "copper", "--channel", "rgb", "--step", "5"): ((["gold", "copper"],), dict(channel="rgb", step=5)),
                ("f0=0.02", "gloss=0.5", "f0=0.04", "--term", "schlick"):
                    ((["f0=0.02", "gloss=0.5", "f0=0.04"],), dict(term="schlick")),
                ("--of", "D", "--term", "phong", "--set", "e=8", "--set", "e=92"):
                    ((), dict(of="D", term=["phong"], set=["e=8", "e=92"])),
                ("water", "--of", "lobe", "--model", "ggx-schlick", "--roughness", "0.3", "--light", "60"):
                    (("water",), dict(of="lobe", model="ggx-schlick", roughness=0.3, light=60)),
                ("gold/johnson", "--of", "R"): (("gold/johnson",), dict(of="R"))}.items():
            with self.subTest(words):
                theirs, mine = json.loads(said("curve", *words, "--format", "json")), etak.curve(*call[0], **call[1])
                self.assertEqual({k: v for k, v in theirs.items() if k not in ("schema", "curves")},
                                 {k: v for k, v in mine.items() if k != "curves"})
                self.assertEqual([each["title"] for each in theirs["curves"]], [each["title"] for each in mine["curves"]])
                for a, b in zip(theirs["curves"], mine["curves"]):
                    np.testing.assert_array_equal(a["x"], b["x"])
                    np.testing.assert_array_equal(np.array(a["y"], float), b["y"])
        with tempfile.TemporaryDirectory() as folder:
            for form in ("svg", "png"):
                file = Path(folder) / f"a.{form}"
                etak.plot(["gold", "silver"], file, dark=True)
                theirs = subprocess.run([PROGRAM, "curve", "gold", "silver", "--dark", "--format", form],
                                        capture_output=True, check=True).stdout
                self.assertEqual(file.read_bytes(), theirs)
                with self.assertRaisesRegex(etak.Error, "exists"):
                    etak.plot("gold", file)
            etak.plot("gold", file, of="lobe", scale="log", force=True)
            self.assertNotEqual(file.read_bytes(), theirs)
            with self.assertRaisesRegex(etak.Error, "ending .svg or .png"):
                etak.plot("gold", Path(folder) / "a.jpg")
        for words, call in {("gold", "--of", "D"): lambda: etak.curve("gold", of="D"),
                            ("gold", "--term", "ggx"): lambda: etak.curve("gold", term="ggx"),
                            ("f0=0.04", "--of", "R"): lambda: etak.curve("f0=0.04", of="R"),
                            ("gold", "--of", "R", "--set", "m=8"): lambda: etak.curve("gold", of="R", set="m=8"),
                            ("nosuchthing",): lambda: etak.curve("nosuchthing"),
                            (): lambda: etak.curve()}.items():
            with self.subTest(words), self.assertRaises(etak.Error) as failed:
                call()
            self.assertEqual(str(failed.exception), told("curve", *words))
        for more in ({"light": 90}, {"step": 0}, {"channel": "cyan"}, {"of": "X"}):
            with self.subTest(more), self.assertRaises(etak.Error):
                etak.curve("gold", **more)

    def test_exports_are_those_of_the_command_line(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            for to in ("mtlx", "gltf"):
                self.assertEqual(etak.export(["gold", "glass_bk7"], to, roughness=0.3),
                                 said("export", "gold", "glass_bk7", "--to", to, "--roughness", "0.3"))
            self.assertEqual(etak.export("gold", "glb")[:4], b"glTF")
        self.assertTrue(any("base_color" in str(each.message) for each in caught), [str(c.message) for c in caught])
        self.assertEqual(etak.export("gold", target=["unreal", "filament"], gloss=0.7, fit="preserve-hue"),
                         json.loads(said("export", "gold", "--to", "values", "--target", "unreal,filament", "--gloss", "0.7",
                                         "--fit", "preserve-hue", "--format", "json")))
        self.assertEqual(etak.export("water", "unreal"), json.loads(said("export", "water", "--to", "unreal", "--format", "json")))
        self.assertEqual(etak.export("marble", "blender", diffuse="#ff8040"), json.loads(
            said("export", "marble", "--to", "blender", "--diffuse", "#ff8040", "--format", "json")))
        self.assertEqual(etak.export("gold", "openpbr", coat=1.5), json.loads(
            said("export", "gold", "--to", "openpbr", "--coat", "1.5", "--format", "json")))
        self.assertEqual(etak.export("sapphire", "hex", axis_average=True), json.loads(
            said("export", "sapphire", "--to", "hex", "--axis-average", "--format", "json")))
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "bright.csv"
            table.write_text("nm R\n360 0.8\n830 0.9\n")
            with self.assertRaisesRegex(etak.Error, "material_class"):
                etak.export(table, "unreal")
            self.assertEqual(etak.export(table, "unreal", material_class="metal"), json.loads(
                said("export", str(table), "--to", "unreal", "--class", "metal", "--format", "json")))
        with self.assertWarnsRegex(UserWarning, "gltf_form metal-rough: is now called specular-ior"):
            self.assertEqual(etak.export("gold", "gltf", gltf_form="metal-rough"),
                             said("export", "gold", "--to", "gltf", "--gltf-form", "specular-ior"))
        for words, call in {("gold", "--to", "values", "--target", "unrea"): lambda: etak.export("gold", target="unrea"),
                            ("gold", "--to", "mtlx", "--gloss", "2"): lambda: etak.export("gold", "mtlx", gloss=2),
                            ("gold", "--to", "mtlx", "--space", "rec2020"):
                                lambda: etak.export("gold", "mtlx", space="rec2020")}.items():
            with self.subTest(words), self.assertRaises(etak.Error) as failed:
                call()
            self.assertEqual(str(failed.exception), told("export", *words))
        with self.assertRaises(etak.Error):
            etak.export([], "mtlx")

    def test_a_library_is_searched_as_the_command_line_lists_it(self):
        listed = json.loads(said("list", "--search", "steel", "--format", "json"))["materials"]
        self.assertEqual(etak.library.search("steel"), [each["id"] for each in listed])
        self.assertEqual(etak.library.search("", classes=["glass"]),
                         [i for i in etak.library if etak.library[i].material_class == "glass"])
        self.assertEqual(etak.library.keys(), list(etak.library))
        self.assertEqual(dict(etak.library)["gold"], etak.library["gold"])


class Notebooks(unittest.TestCase):
    def test_types_show_themselves_with_their_colours(self):
        gold = etak.library["gold"]
        for value in (gold, gold.preferred, etak.library):
            html = value._repr_html_()
            self.assertIn("background:#ffe49c", html)
            self.assertEqual(html.count("<tr>"), html.count("</tr>"))
        self.assertEqual(gold._repr_html_().count("<tr>"), len(gold) + 1)
        odd = etak.dataset([500, 600], n=[1, 1], name="<b>&")
        self.assertIn("&lt;b&gt;&amp;", odd.material._repr_html_())
        self.assertIn("no F0", odd._repr_html_())

    def test_citations_are_entries_of_bibtex(self):
        for each in etak.library:
            for data in etak.library[each]:
                entry = data.citation.bibtex()
                self.assertRegex(entry, r"\A@(article|misc)\{[a-z0-9]+,\n(  [a-z]+ = \{.*\},\n)*  [a-z]+ = \{.*\}\n\}\n\Z")
                self.assertEqual(entry.count("{") - entry.count(r"\{"), entry.count("}") - entry.count(r"\}"))
        entry = etak.library["gold"].preferred.citation.bibtex("olmon")
        self.assertTrue(entry.startswith("@article{olmon,\n  author = {R. L. Olmon and B. Slovick"), entry)
        self.assertIn("  doi = {10.1103/PhysRevB.86.235147}", entry)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "no matplotlib")
    def test_plots_draw_on_the_axes_that_are_given(self):
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib.figure import Figure
        axis = Figure().add_subplot()
        self.assertIs(etak.library["gold"].plot(axis), axis)
        self.assertEqual(len(axis.lines), len(etak.library["gold"]))
        for name in ("gold", "glass_bk7", "water"):
            axis = Figure().add_subplot()
            of = etak.read(name)
            of.plot(axis, linestyle="--")
            self.assertEqual(len(axis.lines), of.has_n + of.has_k)
        surface = next(m for m in map(etak.library.__getitem__, etak.library) if not m.preferred.has_n)
        self.assertEqual(len(surface.plot(Figure().add_subplot()).lines), len(surface))
        self.assertEqual(len(surface.preferred.plot(Figure().add_subplot()).lines), 1)

    def test_the_names_of_the_module_are_its_own(self):
        names = {name for name in dir(etak) if not name.startswith("__")}
        self.assertEqual({name for name in names if not hasattr(etak, name)}, set())
        self.assertEqual(names, {name for name in etak.__all__ if not name.startswith("__")} | {"convert", "eval"})
        for name in ("Any", "Callable", "Optional", "Union", "annotations"):
            self.assertNotIn(name, dir(etak))


if __name__ == "__main__":
    unittest.main()

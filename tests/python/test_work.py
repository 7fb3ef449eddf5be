# SPDX-License-Identifier: Apache-2.0
"""validate(), pack() and choose(), against what the command line says of the same."""
import json
import os
import signal
import subprocess
import threading
import unittest
from pathlib import Path

import etak
from support import PROGRAM, InWorkFolder, png, told


class Work(InWorkFolder):
    def said(self, *words):
        return subprocess.run([PROGRAM, *words], capture_output=True, text=True).stdout


class Validation(Work):
    def test_findings_are_those_of_the_command_line(self):
        report = etak.validate("textures")
        told_json = json.loads(self.said("validate", "textures", "--format", "json"))
        mine = json.loads(report.form("json"))
        for both in (told_json, mine):  # only the command line reads the files once more for their hashes
            for each in both["files"]:
                each.pop("sha256", None)
        self.assertEqual(mine, told_json)
        self.assertEqual(str(report) + "\n", self.said("validate", "textures"))
        self.assertFalse(report.passed)
        self.assertFalse(report.incomplete)
        self.assertEqual(len(report), len(report.findings))
        self.assertEqual([f.rule for f in report], [f.rule for f in report.findings])
        self.assertEqual(report[-1].rule, report.findings[-1].rule)
        with self.assertRaises(IndexError):
            report[len(report)]
        for form in ("sarif", "junit", "github", "csv"):
            self.assertIn("ETK101", report.form(form))
        with self.assertRaisesRegex(etak.Error, "format: pdf; expected text"):
            report.form("pdf")

    def test_a_finding_has_rule_place_value_limit_and_advice(self):
        finding = etak.validate(Path("textures"), only=["ETK101"])[0]
        self.assertEqual((finding.rule, finding.slug, finding.severity), ("ETK101", "f0-forbidden-zone", "error"))
        self.assertEqual(finding.path, "textures/paint_specular.png")
        self.assertTrue(finding.place.startswith(finding.path))
        self.assertEqual(finding.box, (0, 0, 64, 64))
        self.assertEqual(finding.area, 64 * 64)
        self.assertTrue(0.2 < finding.luminance < 0.45)
        for text in (finding.value, finding.limit, finding.message, finding.advice, finding.source, finding.explanation):
            self.assertTrue(text)
        self.assertFalse(finding.suppressed or finding.known)
        self.assertTrue(finding.counts)
        self.assertTrue(finding.nearest[0][0] in etak.library)
        self.assertIn("ETK101", str(finding))

    def test_a_finding_outlives_its_report(self):
        finding = etak.validate("textures")[0]
        for _ in range(20):
            etak.validate("textures")
        self.assertTrue(finding.message)

    def test_settings_are_those_of_the_command_line(self):
        self.assertTrue(etak.validate("textures", fail_on="never", ignore="ETK1").passed)
        self.assertEqual(len(etak.validate("textures", only="ETK205")), 0)
        with self.assertWarnsRegex(FutureWarning, "transfer gamma22: is now called power-2.2$") as warned:
            etak.validate("textures", transfer="gamma22")
        self.assertEqual(warned.filename, __file__)
        for words, call in {
                ("--profile", "lax"): lambda: etak.validate("textures", profile="lax"),
                ("--fail-on", "hint"): lambda: etak.validate("textures", fail_on="hint"),
                ("--only", "ETK777"): lambda: etak.validate("textures", only="ETK777"),
                ("--role", "bump"): lambda: etak.validate("textures", role="bump"),
                ("--today", "now"): lambda: etak.validate("textures", today="now"),
                ("--config", "no.toml"): lambda: etak.validate("textures", config="no.toml"),
                ("--transfer", "log"): lambda: etak.validate("textures", transfer="log")}.items():
            with self.subTest(words), self.assertRaises(etak.Error) as caught:
                call()
            self.assertEqual(str(caught.exception), told("validate", "textures", *words))

    def test_what_cannot_be_read_is_a_finding(self):
        Path("textures/paint_specular.png").write_bytes(b"\x89PNG\r\n\x1a\nbroken")
        report = etak.validate("textures")
        self.assertTrue(report.incomplete)
        self.assertIn("ETK001", [f.rule for f in report])
        self.assertTrue(etak.validate("nowhere").incomplete)

    def test_progress_is_told_and_its_exceptions_come_out(self):
        told_of = []
        etak.validate("textures", progress=lambda done, all: told_of.append((done, all)))
        self.assertEqual(told_of[-1][0], told_of[-1][1])

        def fails(done, all):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            etak.validate("textures", progress=fails)

    def test_an_interrupt_stops_the_work(self):
        many = self.folder / "many"
        many.mkdir()
        for i in range(60):
            png(many / f"m{i}_specular.png", 512, 512, lambda x, y, i=i: ((x * y + i) % 256, x % 256, y % 256, 255)) \
                if i == 0 else (many / f"m{i}_specular.png").write_bytes((many / "m0_specular.png").read_bytes())
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                for _ in range(1000):
                    etak.validate(many, threads=2)
        finally:
            timer.cancel()


class Packing(Work):
    def test_an_atlas_is_that_of_the_command_line(self):
        packed = etak.pack("materials.json", "mine", page=256, keep="all")
        subprocess.run([PROGRAM, "pack", "materials.json", "-o", "theirs", "--page", "256", "--keep", "all", "-q"],
                       check=True)
        names = sorted(os.listdir("mine"))
        self.assertEqual(names, sorted(os.listdir("theirs")))
        self.assertEqual(sorted(packed.files), names)
        for name in names:
            self.assertEqual(Path("mine", name).read_bytes(), Path("theirs", name).read_bytes(), name)
        self.assertEqual((packed.materials, packed.input, packed.output), (2, "materials.json", "mine"))
        self.assertEqual(packed.layout, json.loads(Path("mine/layout.json").read_text()))
        self.assertEqual(len(packed.pages), len(packed.layout["pages"]))
        self.assertTrue(packed.report.passed)
        self.assertIn("materials", json.loads(packed.json()))
        self.assertIn("2 materials", str(packed))
        self.assertIn("mine", repr(packed))

    def test_settings_have_types_and_ranges(self):
        cases = {
            "page: 0; expected a whole number from 1 to": {"page": 0},
            "page: 10.5; expected a whole number": {"page": 10.5},
            "page: True; expected a number": {"page": True},
            "page_form: round; expected": {"page_form": "round"},
            "islands: 1; expected True or False": {"islands": 1},
            "textures: gif; expected png, ktx2": {"textures": "gif"},
            "gutter: wide; expected auto": {"gutter": "wide"},
            "keep: x; expected": {"keep": ["x"]},
            "memory: lots; expected a number of bytes": {"memory": "lots"},
        }
        for text, settings in cases.items():
            with self.subTest(text), self.assertRaisesRegex(etak.Error, "^" + text):
                etak.pack("materials.json", "out", **settings)
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'pge'"):
            etak.pack("materials.json", "out", pge=3)
        self.assertFalse(Path("out").exists())
        self.assertEqual(etak.pack("materials.json", "out", gutter=4, mips=2, page_form="pot").materials, 2)
        self.assertIn("page_form", etak.pack_settings())
        self.assertIn("textures", etak.pack_settings())
        with self.assertWarnsRegex(FutureWarning, "^format: is now called textures$") as warned:
            etak.pack("materials.json", "older", format="png")
        self.assertEqual(warned.filename, __file__)
        with self.assertWarnsRegex(FutureWarning, "^gloss: is now called gloss-channel$"):
            etak.pack("materials.json", "older", gloss="roughness", force=True)

    def test_mistakes_have_the_text_of_the_command_line(self):
        Path("taken").mkdir()
        Path("taken/layout.json").write_text("mine")
        for words, call in {
                ("none.json", "-o", "out"): lambda: etak.pack("none.json", "out"),
                ("materials.json", "-o", "taken"): lambda: etak.pack("materials.json", "taken"),
                ("materials.json", "-o", "materials.json/out"): lambda: etak.pack("materials.json", "materials.json/out")}.items():
            with self.subTest(words), self.assertRaises(etak.Error) as caught:
                call()
            self.assertEqual(str(caught.exception), told("pack", *words))
        self.assertEqual(Path("taken/layout.json").read_text(), "mine")

    def test_an_atlas_is_left_alone_where_it_is_up_to_date_and_in_a_dry_run(self):
        self.assertTrue(etak.pack("materials.json", "out", dry_run=True).dry_run)
        self.assertFalse(Path("out").exists())
        etak.pack("materials.json", "out")
        again = etak.pack("materials.json", "out", update=True)
        self.assertTrue(again.up_to_date)
        self.assertIsNone(again.report)

    def test_findings_come_with_the_atlas(self):
        Path("plastic.json").write_text('{"schema": "etak-atlas-manifest/1", "materials": '
                                        '[{"name": "odd", "specular": 0.3, "gloss": 0.5, "width": 64, "height": 64}]}')
        packed = etak.pack("plastic.json", "out", keep="all")
        self.assertFalse(packed.report.passed)
        self.assertIn("ETK101", [f.rule for f in packed.report])
        self.assertTrue(Path("out/layout.json").exists())
        self.assertIsNone(etak.pack("plastic.json", "unchecked", validate=False).report)

    def test_progress_that_fails_leaves_no_atlas(self):
        def fails(done, all):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            etak.pack("materials.json", "out", keep="all", progress=fails)
        self.assertFalse(Path("out").exists())


class Choosing(Work):
    def test_choices_are_those_of_the_command_line(self):
        choices = etak.choose(["gold", "silver"], roughness=0.3)
        self.assertEqual(json.loads(choices.json()),
                         json.loads(self.said("choose", "gold", "silver", "--roughness", "0.3", "--format", "json")))
        self.assertEqual(str(choices) + "\n", self.said("choose", "gold", "silver", "--roughness", "0.3"))
        self.assertEqual([c.material for c in choices], ["gold", "silver"])
        self.assertEqual(len(choices), 2)
        gold = choices[0]
        self.assertTrue(gold.met and gold.error <= 1 and gold.chosen_ns < gold.everything_ns)
        self.assertIn(gold.fresnel, gold.model)
        self.assertIn(gold.fresnel, etak.fresnel_forms())

    def test_progress_is_told_and_its_exceptions_come_out(self):
        told_of = []
        etak.choose(["gold", "silver", "iron"], threads=1, progress=lambda done, all: told_of.append((done, all)))
        self.assertEqual(told_of, [(1, 3), (2, 3), (3, 3)])

        def fails(done, all):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            etak.choose(["gold", "silver", "iron"], threads=1, progress=fails)

    def test_a_scene_gives_a_choice_for_each_material_that_the_packer_takes(self):
        choices = etak.choose("materials.json")
        self.assertEqual(choices.scene, "materials.json")
        self.assertEqual([c.material for c in choices], ["paint", "ring"])
        Path("choice.json").write_text(choices.json())
        self.assertEqual(etak.pack("materials.json", "out", choice="choice.json").materials, 2)

    def test_mistakes_have_the_text_of_the_command_line(self):
        for words, call in {
                ("gold", "--budget", "-1"): lambda: etak.choose("gold", budget=-1),
                ("gold", "--gloss", "2"): lambda: etak.choose("gold", gloss=2),
                ("gold", "--gloss", "0.5", "--roughness", "0.5"): lambda: etak.choose("gold", gloss=0.5, roughness=0.5),
                ("godl",): lambda: etak.choose("godl"),
                ("gold", "--costs", "no.json"): lambda: etak.choose("gold", costs="no.json")}.items():
            with self.subTest(words), self.assertRaises(etak.Error) as caught:
                call()
            self.assertEqual(str(caught.exception), told("choose", *words))


if __name__ == "__main__":
    unittest.main()

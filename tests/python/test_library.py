# SPDX-License-Identifier: Apache-2.0
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import etak
from support import PROGRAM, told


class TheLibrary(unittest.TestCase):
    def test_it_holds_what_the_command_line_lists(self):
        listed = subprocess.run([PROGRAM, "list", "--format", "json"], capture_output=True, text=True, check=True)
        ids = [each["id"] for each in json.loads(listed.stdout)["materials"]]
        self.assertEqual(sorted(ids), list(etak.library))
        self.assertEqual(len(etak.library), len(ids))
        self.assertIn("Au", etak.library)
        self.assertNotIn("unobtainium", etak.library)
        self.assertNotIn(3, etak.library)

    def test_a_material_has_name_class_datasets_and_their_citations(self):
        gold = etak.library["Au"]
        self.assertEqual((gold.id, gold.name, gold.material_class), ("gold", "Gold", "metal"))
        self.assertEqual([d.id for d in gold], [d.id for d in gold.datasets])
        self.assertEqual(gold.preferred.label, "gold/" + gold.preferred.id)
        self.assertIn(gold.preferred.id, [d.id for d in gold])
        for each in gold.datasets:
            self.assertTrue(each.citation.authors and each.citation.licence)
            self.assertIn(each.citation.authors[0], str(each.citation))
            self.assertTrue(each.citation.year is None or str(each.citation.year) in str(each.citation))
            self.assertIn(each.kind, ("measured", "fit", "computed"))
            self.assertEqual(each.material.id, "gold")
            self.assertTrue(each.has_n and each.has_k)
        self.assertEqual(gold.dataset("mcp").id, gold.dataset(gold.dataset("mcp").id).id)

    def test_unknown_names_raise_with_the_nearest(self):
        with self.assertRaises(etak.Error) as caught:
            etak.library["godl"]
        self.assertIn("no material has this name; expected one of the nearest names: gold", str(caught.exception))
        self.assertIn("gold", " ".join(etak.library.suggest("godl")))
        with self.assertRaises(etak.Error) as caught:
            etak.library["gold"].dataset("nobody")
        self.assertEqual(str(caught.exception), told("f0", "gold/nobody"))

    def test_a_table_without_a_class_is_decided_by_its_numbers_as_a_page_is(self):
        with tempfile.TemporaryDirectory() as folder:
            table, file = Path(folder) / "gold.csv", Path(folder) / "gold.json"
            table.write_text("wavelength_um,n,k\n0.4,1.47,1.95\n0.55,0.43,2.46\n0.7,0.13,4.1\n")
            subprocess.run([PROGRAM, "import", table, "-o", file, "-q"], check=True)
            for path in (table, file):
                read = etak.read(str(path))
                self.assertEqual((read.material.optical_kind, read.kind), ("conductor", "unknown"))

    def test_folders_lie_over_the_built_in_materials(self):
        with tempfile.TemporaryDirectory() as folder:
            shown = subprocess.run(
                [PROGRAM, "show", "gold", "--format", "json"], capture_output=True, text=True, check=True)
            material = json.loads(shown.stdout)["material"]
            material["id"], material["name"], material["aliases"] = "my_gold", "My gold", []
            material.pop("alias_notes", None)
            (Path(folder) / "mine.json").write_text(json.dumps(material))
            mine = etak.Library(folder)
            self.assertEqual(len(mine), len(etak.library) + 1)
            self.assertEqual(mine["my gold"].name, "My gold")
            self.assertEqual(etak.f0("my_gold", library=mine).hex, etak.f0("gold").hex)
            self.assertNotIn("my_gold", etak.library)
        with self.assertRaisesRegex(etak.Error, "cannot be opened"):
            len(etak.Library("/no/such/folder"))


class Datasets(unittest.TestCase):
    def test_n_and_k_are_those_of_the_table_at_its_rows_and_on_a_line_between(self):
        gold = etak.library["gold"].preferred
        at = gold.wavelength
        n, k = gold.n(at), gold.k(at)
        self.assertEqual(n.shape, at.shape)
        middle = (at[3] + at[4]) / 2
        self.assertAlmostEqual(gold.n(middle), (n[3] + n[4]) / 2, places=14)
        self.assertIsInstance(gold.k(550), float)
        self.assertEqual(gold.n([[500, 600], [700, 500]]).shape, (2, 2))
        self.assertEqual(gold.n([700, 500]).tolist(), gold.n([500, 700])[::-1].tolist())
        self.assertNotEqual(gold.n(middle, interpolation="pchip"), gold.n(middle))
        np.testing.assert_array_equal(gold.k(np.array([500.0, 600.0])[::-1]), gold.k([600, 500]))

    def test_outside_of_the_data_it_raises_unless_told_to_extrapolate(self):
        gold = etak.library["gold"].preferred
        first, last = gold.range
        for nm in (first - 1e-3, last + 1e-3):
            with self.assertRaisesRegex(etak.Error, "nm is outside of the data; expected .* nm, or extrapolate"):
                gold.n([500, nm])
            with self.assertRaises(etak.Error):
                gold.k(nm)
        self.assertEqual(gold.n(last + 50, extrapolate=True), gold.n(last))
        self.assertEqual(gold.k(first - 50, extrapolate=True), gold.k(first))
        with self.assertRaisesRegex(etak.Error, "wavelength nan nm; expected a positive number"):
            gold.n(np.nan, extrapolate=True)
        with self.assertRaisesRegex(etak.Error, "interpolation: cubic; expected linear or pchip"):
            gold.n(500, interpolation="cubic")

    def test_formulas_and_reflectances_say_what_they_are(self):
        formula = next(d for i in etak.library for d in etak.library[i] if d.is_formula)
        self.assertIsNone(formula.wavelength)
        self.assertGreater(formula.n(sum(formula.range) / 2), 0)
        if not formula.has_k:
            with self.assertRaisesRegex(etak.Error, "no k is given; expected a dataset with k"):
                formula.k(500)
        surface = next(m.preferred for m in map(etak.library.__getitem__, etak.library) if not m.preferred.has_n)
        self.assertTrue(0 <= surface.reflectance(550) <= 1)
        with self.assertRaisesRegex(etak.Error, "has reflectance data only"):
            surface.n(550)
        with self.assertRaisesRegex(etak.Error, "has n and k"):
            etak.library["gold"].preferred.reflectance(550)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
import json
import os
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import etak
from support import PROGRAM, told

NM = np.arange(360.0, 831.0)


def answer(*words):
    done = subprocess.run([PROGRAM, "f0", *words, "--format", "json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["results"][0]


def spectra(name):
    of = etak.read(name)
    n = of.n(NM, extrapolate=True)
    return n, of.k(NM, extrapolate=True) if of.has_k else np.zeros_like(n)


class OneMaterial(unittest.TestCase):
    def test_an_answer_is_that_of_the_command_line(self):
        for name, settings in {
                "gold": {}, "water": {"illuminant": "A"}, "silicon": {"outside": "water", "method": "exact"},
                "copper": {"space": "acescg", "observer": "1964-10deg", "interpolation": "pchip"},
                "diamond": {"outside": 1.33}}.items():
            with self.subTest(name):
                words = [f"--{key.replace('_', '-')}={value}" for key, value in settings.items()]
                mine, theirs = etak.f0(name, **settings), answer(name, *words)
                self.assertEqual(json.loads(mine.json())["results"][0], theirs)
                self.assertEqual(dict(zip("rgb", mine.rgb)), theirs["linear"])
                self.assertEqual(mine.hex, theirs["hex"])
                self.assertEqual(mine.luminance, theirs["Y"])

    def test_all_parts_of_an_answer_have_their_types(self):
        gold = etak.f0("Au")
        self.assertEqual((gold.name, gold.material_name, gold.material_class), ("gold", "Gold", "metal"))
        self.assertEqual(gold.rgb.shape, (3,))
        self.assertEqual(gold.rgb.dtype, np.float64)
        self.assertEqual(gold.rgb8, (255, 228, 156))
        self.assertEqual(gold.flags, ["out-of-gamut", "channel-in-zone"])
        self.assertEqual(list(gold.flag_meanings), gold.flags)
        self.assertEqual(gold.zone, "above")
        self.assertEqual(gold.coverage, min(gold.coverage_xyz))
        self.assertGreater(gold.gamut_excess[0], 0.04)
        self.assertIn("2012", gold.citation)
        self.assertIn("D65", gold.policy)
        self.assertTrue((gold.f82 < 1).all() and (gold.f82_tint > 0).all())
        self.assertGreater(gold.spread.count, 3)
        self.assertTrue((gold.spread.least <= gold.rgb).all() and (gold.rgb <= gold.spread.most).all())
        self.assertIn(gold.hex, gold._repr_html_())

    def test_text_is_the_table_of_the_command_line(self):
        table = subprocess.run([PROGRAM, "f0", "gold", "-v"], capture_output=True, text=True, check=True).stdout
        gold = etak.f0("gold")
        self.assertEqual(str(gold), table + gold.citation)
        self.assertEqual(repr(gold), "<etak.F0 gold: #ffe49c, 1.0428 0.7738 0.3347 in srgb>")

    def test_files_are_read_by_name_and_by_path(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "mine.csv"
            path.write_text("wavelength (nm),n,k\n380,1.5,0\n780,1.5,0\n")
            for asked in (str(path), path):
                self.assertEqual(etak.f0(asked).hex, "#383838")
            table = Path(folder) / "gold"  # no ending, and a name of the library
            table.write_text(path.read_text())
            here = os.getcwd()
            try:
                os.chdir(folder)
                self.assertEqual(etak.f0("gold").hex, "#ffe49c")
                with self.assertRaisesRegex(etak.Error, "gold: has no ending that etak knows"):
                    etak.f0(Path("gold"))
            finally:
                os.chdir(here)

    def test_a_dataset_of_ones_own_numbers_is_like_one_of_the_library(self):
        n, k = spectra("gold")
        mine = etak.dataset(NM, n=n, k=k, name="My gold")
        np.testing.assert_allclose(etak.f0(mine).rgb, etak.f0("gold").rgb, rtol=1e-14)
        self.assertEqual(etak.f0(mine).name, "my_gold/given")
        self.assertEqual(etak.f0(mine.material).hex, "#ffe49c")

    def test_mistakes_have_the_text_of_the_command_line(self):
        cases = {
            ("gold", "--illuminant", "D66"): lambda: etak.f0("gold", illuminant="D66"),
            ("gold", "--observer", "x"): lambda: etak.f0("gold", observer="x"),
            ("gold", "--method", "2nm"): lambda: etak.f0("gold", method="2nm"),
            ("gold", "--integration-bound", "1e-3"): lambda: etak.f0("gold", integration_bound="1e-3"),
            ("gold", "--outside", "soup"): lambda: etak.f0("gold", outside="soup"),
            ("gold", "--outside", "-1"): lambda: etak.f0("gold", outside=-1),
            ("gold", "--space", "nothing"): lambda: etak.f0("gold", space="nothing"),
            ("gold", "--ocio", "x.ocio"): lambda: etak.f0("gold", ocio="x.ocio"),
            ("gold", "--dataset", "nobody"): lambda: etak.f0("gold", dataset="nobody"),
            ("gld",): lambda: etak.f0("gld"),
            ("milk",): lambda: etak.f0("milk"),
            ("no/such.csv",): lambda: etak.f0("no/such.csv"),
            ("gold", "--unit", "mile"): lambda: etak.f0("gold", unit="mile"),
            ("gold", "--duplicates", "all"): lambda: etak.f0("gold", duplicates="all"),
        }
        for words, call in cases.items():
            with self.subTest(words):
                with self.assertRaises(etak.Error) as caught:
                    call()
                self.assertEqual(str(caught.exception), told("f0", *words))
                self.assertIsInstance(caught.exception, ValueError)

    def test_data_without_a_colour_raise_with_the_reason_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "short.csv"
            path.write_text("wavelength (nm),n,k\n500,1.5,0\n600,1.5,0\n")
            flags = subprocess.run(
                [PROGRAM, "f0", path, "--format", "csv"], capture_output=True, text=True).stdout.splitlines()[1]
            with self.assertRaises(etak.Error) as caught:
                etak.f0(path)
            reason = str(caught.exception).split(": refused: ")[1]
            self.assertIn(reason, flags)
            self.assertIn("extrapolated", etak.f0(path, allow_extrapolation=True).flags)

    def test_several_materials_are_no_one_material(self):
        with self.assertRaisesRegex(etak.Error, "stands for 11 of them; expected one material"):
            etak.f0("gold/*")


class Arrays(unittest.TestCase):
    def test_rows_are_what_one_material_after_the_other_is(self):
        names = ["gold", "silver", "copper", "silicon", "glass_bk7", "water"]
        both = [spectra(name) for name in names]
        n, k = (np.stack([each[i] for each in both]) for i in (0, 1))
        for settings in ({}, {"illuminant": "A", "space": "rec2020"}, {"outside": 1.33, "method": "10nm"}):
            out = etak.f0(n=n, k=k, wavelength=NM, **settings)
            self.assertEqual((out.shape, out.dtype), ((6, 3), np.float64))
            for row, name in zip(out, names):
                np.testing.assert_allclose(row, etak.f0(name, **settings).rgb, rtol=1e-12, err_msg=name)

    def test_one_spectrum_gives_one_colour(self):
        n, k = spectra("gold")
        one = etak.f0(n=n, k=k, wavelength=NM)
        self.assertEqual(one.shape, (3,))
        np.testing.assert_array_equal(one, etak.f0(n=n[None], k=k[None], wavelength=NM)[0])
        self.assertEqual(etak.f0(n=np.empty((0, 471)), wavelength=NM).shape, (0, 3))

    def test_n_without_k_and_reflectance_are_taken(self):
        np.testing.assert_allclose(etak.f0(n=[1.5, 1.5], wavelength=[380, 780]), 0.04, rtol=1e-12)
        np.testing.assert_allclose(etak.f0(reflectance=[[0.3, 0.3]], wavelength=[380, 780]), 0.3, rtol=1e-12)

    def test_read_only_and_non_contiguous_arrays_give_the_same_and_stay_as_they_are(self):
        n, k = (np.tile(each, (40, 1)) * np.linspace(0.9, 1.1, 40)[:, None] for each in spectra("copper"))
        expected = etak.f0(n=n, k=k, wavelength=NM)
        wide = np.empty((80, 942))
        wide[::2, ::2] = n
        backward = k[::-1, ::-1].copy()[::-1, ::-1]
        frozen = n.copy()
        frozen.flags.writeable = False
        big = n.astype(">f8")
        for first, second in ((wide[::2, ::2], backward), (np.asfortranarray(n), np.asfortranarray(k)), (frozen, k),
                              (big, k), (n.tolist(), k.tolist()), (np.broadcast_to(n[0], n.shape), k)):
            before = np.array(first)
            out = etak.f0(n=first, k=second, wavelength=NM)
            np.testing.assert_array_equal(np.array(first), before)
            if not np.array_equal(before, n):
                continue
            np.testing.assert_array_equal(out, expected)
        np.testing.assert_array_equal(
            etak.f0(n=np.broadcast_to(n[0], n.shape), k=np.broadcast_to(k[0], n.shape), wavelength=NM)[7], expected[0])
        np.testing.assert_allclose(
            etak.f0(n=n.astype(np.float32), k=k.astype(np.float32), wavelength=NM.astype(int)), expected, atol=1e-6)

    def test_any_number_of_threads_gives_the_same_bytes(self):
        n, k = (np.tile(each, (300, 1)) * np.linspace(0.9, 1.1, 300)[:, None] for each in spectra("gold"))
        one = etak.f0(n=n, k=k, wavelength=NM, threads=1)
        for threads in (2, 3, 16, 0):
            np.testing.assert_array_equal(etak.f0(n=n, k=k, wavelength=NM, threads=threads), one)

    def test_numbers_of_threads_that_are_none_are_refused(self):
        for threads in (-1, 257):
            with self.assertRaisesRegex(etak.Error, f"^threads: {threads}; expected 1 to 256, or 0 for all cores"):
                etak.f0(n=[1.5, 1.5], wavelength=[380, 780], threads=threads)

    def test_wrong_shapes_are_refused(self):
        w = [400.0, 500.0, 700.0]
        for text, n, k, wavelength in [
                (r"n: shape \(2,\); expected \(N, M\) or \(M,\) with M = 3", [1, 2], None, w),
                (r"n: shape \(\); expected", 1.5, None, w),
                (r"n: shape \(1, 1, 3\); expected", [[[1, 2, 3]]], None, w),
                (r"n: shape \(3, 2\); expected", np.ones((3, 2)), None, w),
                (r"k: shape \(3,\); expected \(2, 3\) as n has", np.ones((2, 3)), np.ones(3), w),
                (r"k: shape \(3, 3\); expected \(2, 3\) as n has", np.ones((2, 3)), np.ones((3, 3)), w),
                (r"wavelength: shape \(1, 3\); expected \(M,\)", np.ones((1, 3)), None, [w]),
                (r"wavelength: no samples; expected at least one", np.ones((1, 0)), None, []),
                (r"wavelength: is not given", [1, 2], None, None),
                (r"n: is not given", None, [0, 0, 0], w)]:
            with self.subTest(text), self.assertRaisesRegex(etak.Error, text):
                etak.f0(n=n, k=k, wavelength=wavelength)
        with self.assertRaisesRegex(etak.Error, "material: is given beside arrays"):
            etak.f0("gold", n=[1, 1, 1], wavelength=w)
        with self.assertRaisesRegex(etak.Error, "reflectance: is given beside n"):
            etak.f0(n=[1, 1, 1], reflectance=[0, 0, 0], wavelength=w)

    def test_values_that_no_table_may_hold_are_refused_with_their_place(self):
        w = [400.0, 500.0, 700.0]
        n = np.full((40, 3), 1.5)
        n[17, 1] = np.nan
        n[30, 0] = -1
        with self.assertRaisesRegex(etak.Error, r"^n\[17\]: n = nan at 500 nm; expected 0 <= n <= 10000$"):
            etak.f0(n=n, wavelength=w)
        n[17, 1] = np.inf
        with self.assertRaisesRegex(etak.Error, r"^n\[17\]: n = inf at 500 nm"):
            etak.f0(n=n, wavelength=w, threads=4)
        good = np.full((40, 3), 1.5)
        with self.assertRaisesRegex(etak.Error, r"^k\[0\]: k = -0.5 at 400 nm; expected 0 <= k <= 1000000$"):
            etak.f0(n=good, k=-good / 3, wavelength=w)
        with self.assertRaisesRegex(etak.Error, r"^n: refused: n = 0 at 500 nm; n must be above 0"):
            etak.f0(n=[1, 0, 1], wavelength=w, allow_extrapolation=True)
        with self.assertRaisesRegex(etak.Error, r"^reflectance: reflectance = 1.5 at 500 nm; expected 0 <="):
            etak.f0(reflectance=[0, 1.5, 0], wavelength=w)
        for bad, text in (([400, 400, 700], "400 nm behind 400 nm; expected strictly ascending"),
                          ([700, 500, 400], "500 nm behind 700 nm"), ([np.nan, 500, 700], "wavelength nan nm"),
                          ([-1, 500, 700], "wavelength -1 nm; expected a positive number")):
            with self.assertRaisesRegex(etak.Error, "^wavelength: " + text):
                etak.f0(n=[1, 1, 1], wavelength=bad)
        with self.assertRaisesRegex(etak.Error, r"^n\[0\]: refused: data cover .* of the Y weight \(500-600 nm\)"):
            etak.f0(n=[[1.5, 1.5]], wavelength=[500, 600])

    def test_what_is_no_array_of_real_numbers_is_refused(self):
        w = [400.0, 500.0, 700.0]
        for bad, text in ((["a", "b", "c"], "an array of <U1"),
                          ([True, False, True], "an array of bool"), ([None, 1, 2], "an array of object"),
                          (np.ma.masked_equal([1.0, 2.0, 3.0], 2), "a masked array")):
            with self.subTest(text), self.assertRaisesRegex(etak.Error, f"^n: {text}; expected"):
                etak.f0(n=bad, wavelength=w)
        with self.assertRaisesRegex(etak.Error, "^n: no array of numbers: "):
            etak.f0(n=[[1, 2], [1, 2, 3]], wavelength=w)
        with self.assertRaisesRegex(etak.Error, "^k: an array of complex128; expected real numbers"):
            etak.f0(n=[1, 1, 1], k=np.ones(3) * 1j, wavelength=w)

    def test_a_complex_index_is_n_and_k(self):
        n, k = (np.tile(each, (3, 1)) for each in spectra("gold"))
        np.testing.assert_array_equal(etak.f0(n=n + 1j * k, wavelength=NM), etak.f0(n=n, k=k, wavelength=NM))
        self.assertEqual(etak.f0(etak.dataset(NM, n=(n + 1j * k)[0])), etak.f0(etak.dataset(NM, n=n[0], k=k[0])))
        with self.assertRaisesRegex(etak.Error, "^k: is given beside a complex n; expected one of the two"):
            etak.f0(n=n + 1j * k, k=k, wavelength=NM)
        with self.assertRaisesRegex(etak.Error, r"^k\[0\]: k = -1 at 400 nm; expected 0 <= k"):
            etak.f0(n=[[1 - 1j, 1, 1]], wavelength=[400, 500, 700])

    def test_wavelengths_of_arrays_have_a_unit(self):
        n, k = spectra("copper")
        expected = etak.f0(n=n, k=k, wavelength=NM)
        np.testing.assert_allclose(etak.f0(n=n, k=k, wavelength=NM / 1000, unit="um"), expected, rtol=1e-12)
        np.testing.assert_allclose(etak.f0(n=n, k=k, wavelength=NM * 10, unit="A"), expected, rtol=1e-12)
        ev = 1239.8419843320026 / NM[::-1]
        np.testing.assert_allclose(etak.f0(n=n[::-1], k=k[::-1], wavelength=ev, unit="eV"), expected, rtol=1e-9)
        with self.assertRaisesRegex(etak.Error, "^unit: mile; expected"):
            etak.f0(n=n, wavelength=NM, unit="mile")
        with self.assertRaisesRegex(etak.Error, "^columns: is given beside arrays"):
            etak.f0(n=n, wavelength=NM, columns="wavelength,n")

    def test_methods_with_knots_of_their_own_give_rows_what_materials_get(self):
        n, k = spectra("silver")
        for method in ("exact", "auto", "5nm", "e308-10nm", "point-650-550-450"):
            np.testing.assert_allclose(
                etak.f0(n=n[None], k=k[None], wavelength=NM, method=method)[0],
                etak.f0(etak.dataset(NM, n=n, k=k), method=method).rgb, rtol=1e-12, err_msg=method)


class CoatsAndInstruments(unittest.TestCase):
    def test_a_coat_is_that_of_the_command_line_and_of_the_formula(self):
        for name, coat in (("gold", 1.5), ("copper", "water:2mm"), ("anatase:40nm/titanium", "pmma")):
            with self.subTest(name):
                mine = etak.f0(name, coat=coat)
                theirs = answer(name, "--coat", str(coat))
                self.assertEqual(json.loads(mine.json())["results"][0], theirs)
                self.assertEqual(dict(zip("rgb", mine.coat["f0_under"])), theirs["coat"]["f0_under"])
                self.assertEqual(pickle.loads(pickle.dumps(mine)).coat, mine.coat)
        gold = etak.f0("gold", coat=1.5)
        self.assertEqual(gold.coat["n"], 1.5)
        # At each wavelength F0 of the whole is the coat's own 0.04 and what gets out; of colours nearly.
        np.testing.assert_allclose(0.04 + np.multiply(gold.coat["energy_left"], gold.coat["f0_under"]),
                                   gold.coat["f0"], atol=0.004)
        under = [etak.eval("f0_under", f0=a, f82=b, coat=1.5) for a, b in zip(gold.rgb[1:], gold.f82[1:])]
        np.testing.assert_allclose(under, gold.coat["f0_under"][1:], atol=0.008)
        self.assertIsNone(etak.f0("gold").coat)
        self.assertIn("under the coat", str(gold))

    def test_means_over_the_hemisphere_are_those_of_the_command_line(self):
        gold = etak.f0("gold")
        self.assertEqual(dict(zip("rgb", gold.mean)), answer("gold")["mean"]["exact"])
        self.assertEqual(dict(zip("rgb", gold.f82_mean)), answer("gold")["mean"]["f82"])
        np.testing.assert_allclose(gold.f82_mean, [etak.eval("f82_mean", f0=a, f82=b) for a, b in zip(gold.rgb, gold.f82)],
                                   rtol=1e-12)
        np.testing.assert_allclose(gold.mean, gold.f82_mean, atol=0.01)
        self.assertIsNone(etak.f0("spectralon").mean)

    def test_an_aperture_and_scatter_are_those_of_the_command_line(self):
        mine = etak.f0("anatase:40nm/titanium", aperture=0.9, scatter=0.1)
        theirs = answer("anatase:40nm/titanium", "--aperture", "0.9", "--scatter", "0.1")
        self.assertEqual(json.loads(mine.json())["results"][0], theirs)
        self.assertIsNone(mine.f82)
        self.assertIn("cone of aperture 0.9", mine.policy)
        many = etak.f0("rutile", axis_average=True, aperture=0.6)
        self.assertEqual(dict(zip("rgb", many.rgb)), answer("rutile", "--axis-average", "--aperture", "0.6")["linear"])

    def test_what_cannot_be_is_refused_with_one_line(self):
        for settings, text in (({"coat": "copper"}, "^coat: copper/.* is not clear"), ({"coat": 0}, "^coat: 0; expected"),
                               ({"coat": "pmma:?mm"}, "^coat: pmma"), ({"coat": 1.5, "aperture": 0.5}, "^coat: beside aperture"),
                               ({"coat": 1.5, "axis_average": True}, "^coat: beside axis.average"),
                               ({"aperture": 1}, "^aperture: 1; expected 0 to below"), ({"scatter": 2}, "^scatter: 2"),
                               ({"aperture": "wide"}, "^aperture: wide; expected a number")):
            with self.subTest(text), self.assertRaisesRegex(etak.Error, text) as caught:
                etak.f0("gold", **settings)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(etak.Error, "^coat: is given beside arrays"):
            etak.f0(n=[1.5, 1.5], wavelength=[380, 780], coat=1.5)
        with self.assertRaisesRegex(etak.Error, "spectralon: reflectance at normal incidence"):
            etak.f0("spectralon", coat=1.5)


class Several(unittest.TestCase):
    def test_a_list_of_names_gives_a_list_of_answers(self):
        names = ["gold", "silver", Path("none.csv")]
        self.assertEqual(etak.f0(names[:2]), [etak.f0("gold"), etak.f0("silver")])
        self.assertEqual(etak.f0(("gold", etak.read("silver")), threads=2)[1].hex, etak.f0("silver").hex)
        self.assertEqual(etak.f0([]), [])
        with self.assertRaisesRegex(etak.Error, "none.csv"):
            etak.f0(names)


class OwnViewing(unittest.TestCase):
    def setUp(self):
        # CIE's own tables, as etak tells them: XYZ of a narrow band is a row of observer x illuminant.
        table = Path(__file__).parents[2] / "resources/cie"
        rows = lambda name: np.array([[float(x) for x in line.split(",")] for line in
                                      (table / name).read_text().splitlines() if line[:1].isdigit()])
        self.observers, self.illuminants = rows("observers.csv"), rows("illuminants.csv")

    def test_tables_of_cie_give_what_their_names_give(self):
        for column, light in ((2, "D50"), (3, "A")):
            mine = (self.illuminants[:, 0], self.illuminants[:, column])
            for name in ("gold", "water"):
                for method in ("1nm", "10nm", "exact"):
                    np.testing.assert_allclose(etak.f0(name, illuminant=mine, method=method).rgb,
                                               etak.f0(name, illuminant=light, method=method).rgb, rtol=1e-9)
        observer = (self.observers[:, 0], self.observers[:, 4:7])
        both = etak.f0("copper", observer=observer, illuminant=(self.illuminants[:, 0], self.illuminants[:, 3]))
        np.testing.assert_allclose(both.rgb, etak.f0("copper", observer="1964-10deg", illuminant="A").rgb, rtol=1e-9)
        self.assertIn("own observer; illuminant own", both.policy)
        np.testing.assert_allclose(etak.fresnel("gold", [1, 0.5], observer=observer),
                                   etak.fresnel("gold", [1, 0.5], observer="1964-10deg"), rtol=1e-9)
        n, k = spectra("gold")
        np.testing.assert_allclose(etak.f0(n=n, k=k, wavelength=NM, observer=observer),
                                   etak.f0(n=n, k=k, wavelength=NM, observer="1964-10deg"), rtol=1e-9)

    def test_a_flat_reflectance_has_no_hue_under_any_light(self):
        light = ([380, 500, 600, 780], [1, 0.2, 3, 0.5])
        np.testing.assert_allclose(etak.f0(reflectance=[0.3, 0.3], wavelength=[380, 780], illuminant=light), 0.3, rtol=1e-9)

    def test_answers_keep_their_tables_and_many_can_come_and_go(self):
        first = etak.f0("gold", illuminant=([380, 780], [1, 3]))
        before = first.spread.most.copy()
        for i in range(300):
            etak.f0("gold", illuminant=([380, 780], [1, i]))
        np.testing.assert_array_equal(first.spread.most, before)

    def test_tables_that_are_none_are_refused(self):
        for light, text in ((([380, 780], [1]), "shapes"), (([380, 780], [1, -1]), "negative"), (([400, 700], [1, 1]), "380-780 nm"),
                            (([380, 780], [0, 0]), "no power"), (([780, 380], [1, 1]), "ascending"), (([1, 2, 3],), "a list of 1"),
                            (([380, 780], [1, float("nan")]), "nan")):
            with self.subTest(text), self.assertRaisesRegex(etak.Error, "^illuminant: .*" + text):
                etak.f0("gold", illuminant=light)
        with self.assertRaisesRegex(etak.Error, "^observer: the sum of y"):
            etak.f0("gold", observer=([380, 780], [[1, 0, 0], [1, 0, 0]]))


if __name__ == "__main__":
    unittest.main()

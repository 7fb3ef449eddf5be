# SPDX-License-Identifier: Apache-2.0
"""Converters. Those that need colour-science or Mitsuba are tested where these are present."""
import importlib.util
import sys
import types
import unittest
import unittest.mock

import numpy as np

import etak
from etak import convert


def has(package):
    try:
        return importlib.util.find_spec(package) is not None
    except ModuleNotFoundError:
        return False


class Distribution:
    """What the converters use of a colour.SpectralDistribution, for machines without colour-science."""

    def __init__(self, data, name=""):
        self.wavelengths, self.values, self.name = np.array(list(data)), np.array(list(data.values())), name


class Mitsuba(unittest.TestCase):
    def test_a_conductor_has_the_rows_of_its_dataset(self):
        gold = etak.library["gold"].preferred
        out = convert.to_mitsuba("gold", roughness=0.3)
        self.assertEqual((out["type"], out["distribution"], out["alpha"]), ("roughconductor", "ggx", 0.09))
        at = [w for w, _ in out["eta"]["value"]]
        self.assertEqual([v for _, v in out["eta"]["value"]], gold.n(at).tolist())
        self.assertEqual([v for _, v in out["k"]["value"]], gold.k(at).tolist())
        self.assertEqual(convert.to_mitsuba(gold)["type"], "conductor")

    def test_a_dielectric_has_its_index_at_the_sodium_line_with_or_without_k(self):
        for name in ("water", "glass_bk7", "diamond"):
            out = convert.to_mitsuba(name)
            self.assertEqual((out["type"], out["int_ior"]), ("dielectric", etak.read(name).n(589.3)))
        self.assertEqual(convert.to_mitsuba("silicon")["type"], "conductor")
        mine = etak.dataset([400, 700], n=[1.5, 1.5])
        self.assertEqual(convert.to_mitsuba(mine, roughness=0.5)["type"], "roughdielectric")
        self.assertEqual(convert.to_mitsuba(etak.dataset([400, 700], n=[1, 1], k=[2, 2]))["type"], "conductor")

    def test_there_and_back_is_the_same_colour(self):
        for name in ("gold", "copper", "silicon"):
            again = convert.from_mitsuba(convert.to_mitsuba(name), name=name)
            np.testing.assert_allclose(etak.f0(again).rgb, etak.f0(name).rgb, rtol=1e-12)

    def test_other_dictionaries_are_refused(self):
        for bad in ({"type": "conductor", "material": "Au"}, {"eta": 1.5, "k": 0},
                    {"eta": {"value": [(400, 1), (500, 1)]}, "k": {"value": [(400, 1), (501, 1)]}}):
            with self.assertRaises(etak.Error):
                convert.from_mitsuba(bad)

    @unittest.skipUnless(has("mitsuba"), "no mitsuba")
    def test_mitsuba_loads_what_was_made(self):
        import mitsuba
        mitsuba.set_variant("scalar_spectral")
        for name in ("gold", "glass_bk7"):
            for roughness in (None, 0.3):
                self.assertIsNotNone(mitsuba.load_dict(convert.to_mitsuba(name, roughness=roughness)))


@unittest.skipUnless(has("colour.colorimetry"), "no colour-science")
class Colour(unittest.TestCase):
    def test_there_and_back_is_the_same_colour(self):
        gold = etak.library["gold"].preferred
        n, k = convert.to_colour(gold), convert.to_colour(gold, "k")
        np.testing.assert_array_equal(n.values, gold.n(n.wavelengths))
        again = convert.from_colour(n, k)
        np.testing.assert_allclose(etak.f0(again).rgb, etak.f0("gold").rgb, rtol=1e-12)

    def test_a_reflectance_of_colour_science_has_the_xyz_that_it_computes(self):
        import colour
        sd = colour.SpectralDistribution({w: 0.2 + 0.5 * (w > 560) for w in range(360, 831)})
        theirs = colour.sd_to_XYZ(
            sd, colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(sd.shape),
            colour.SDS_ILLUMINANTS["D65"].copy().align(sd.shape), method="Integration") / 100
        np.testing.assert_allclose(etak.f0(convert.from_colour(reflectance=sd)).xyz, theirs, atol=2e-4)


class ColourWithoutThePackage(unittest.TestCase):
    def setUp(self):
        stand_in = types.ModuleType("colour")
        stand_in.SpectralDistribution = Distribution
        patch = unittest.mock.patch.dict(sys.modules, {"colour": stand_in})
        patch.start()
        self.addCleanup(patch.stop)

    def test_a_distribution_has_the_rows_of_its_dataset(self):
        gold = etak.library["gold"].preferred
        n = convert.to_colour("gold")
        self.assertEqual(n.name, gold.label + " n")
        np.testing.assert_array_equal(n.wavelengths, gold.wavelength)
        np.testing.assert_array_equal(n.values, gold.n(gold.wavelength))
        k = convert.to_colour(gold, "k", name="extinction")
        self.assertEqual(k.name, "extinction")
        np.testing.assert_allclose(etak.f0(convert.from_colour(n, k)).rgb, etak.f0("gold").rgb, rtol=1e-12)

    def test_a_formula_is_sampled_and_a_reflectance_is_one(self):
        formula = next(d for i in etak.library for d in etak.library[i] if d.is_formula)
        of = convert.to_colour(formula)
        np.testing.assert_array_equal(np.diff(of.wavelengths), 1)
        np.testing.assert_array_equal(of.values, formula.n(of.wavelengths))
        sd = Distribution({380: 0.3, 780: 0.3}, name="grey")
        self.assertEqual(convert.from_colour(reflectance=sd).material.name, "grey")
        np.testing.assert_allclose(etak.f0(convert.from_colour(reflectance=sd)).rgb, 0.3)

    def test_what_does_not_fit_is_refused(self):
        with self.assertRaisesRegex(etak.Error, "quantity: q; expected n, k or reflectance"):
            convert.to_colour("gold", "q")
        with self.assertRaisesRegex(etak.Error, "k: has other wavelengths than n"):
            convert.from_colour(Distribution({400: 1, 700: 1}), Distribution({400: 1, 600: 1}))
        with self.assertRaisesRegex(etak.Error, "n: is not given"):
            convert.from_colour()


class Imports(unittest.TestCase):
    @unittest.skipIf(has("colour.colorimetry"), "colour-science is here")
    def test_what_needs_colour_science_says_so_where_it_is_not(self):
        with self.assertRaises(ImportError):
            convert.to_colour("gold")


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
"""Converters. Those that need colour-science or Mitsuba are tested where these are present."""
import importlib.util
import unittest

import numpy as np

import etak
from etak import convert


def has(package):
    return importlib.util.find_spec(package) is not None


class Mitsuba(unittest.TestCase):
    def test_a_conductor_has_the_rows_of_its_dataset(self):
        gold = etak.library["gold"].preferred
        out = convert.to_mitsuba("gold", roughness=0.3)
        self.assertEqual((out["type"], out["distribution"], out["alpha"]), ("roughconductor", "ggx", 0.09))
        at = [w for w, _ in out["eta"]["value"]]
        self.assertEqual([v for _, v in out["eta"]["value"]], gold.n(at).tolist())
        self.assertEqual([v for _, v in out["k"]["value"]], gold.k(at).tolist())
        self.assertEqual(convert.to_mitsuba(gold)["type"], "conductor")

    def test_a_material_without_k_is_a_dielectric_of_its_index_at_the_sodium_line(self):
        glass = next(m.preferred for m in map(etak.library.__getitem__, etak.library)
                     if m.preferred.has_n and not m.preferred.has_k)
        out = convert.to_mitsuba(glass)
        self.assertEqual((out["type"], out["int_ior"]), ("dielectric", glass.n(589.3)))

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


@unittest.skipUnless(has("colour"), "no colour-science")
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


class Names(unittest.TestCase):
    def test_quantities_that_are_none_are_refused(self):
        if not has("colour"):
            with self.assertRaises(ImportError):
                convert.to_colour("gold")
        with self.assertRaisesRegex(etak.Error, "n: is not given"):
            convert.from_colour()


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
import unittest

import numpy as np

import etak


class Fresnel(unittest.TestCase):
    def test_at_normal_incidence_it_is_f0_and_at_grazing_everything(self):
        for name in ("gold", "silicon", "glass_bk7"):
            both = etak.fresnel(name, [1, 1 / 7, 0])
            f0 = etak.f0(name)
            np.testing.assert_allclose(both[0], f0.rgb, rtol=1e-10)
            np.testing.assert_allclose(both[1], f0.f82, rtol=1e-10)
            np.testing.assert_allclose(both[2], 1, rtol=1e-10)

    def test_a_dielectric_of_one_index_follows_the_closed_form(self):
        glass = etak.dataset([380, 780], n=[1.5, 1.5], k=[0, 0])
        c = np.linspace(0, 1, 101)
        t = np.sqrt(1 - (1 - c * c) / 2.25)
        s, p = (c - 1.5 * t) / (c + 1.5 * t), (t - 1.5 * c) / (t + 1.5 * c)
        np.testing.assert_allclose(etak.fresnel(glass, c)[:, 1], (s * s + p * p) / 2, atol=1e-12)

    def test_shapes_of_cosines_are_kept(self):
        self.assertEqual(etak.fresnel("gold", 0.5).shape, (3,))
        self.assertEqual(etak.fresnel("gold", np.ones((4, 5))).shape, (4, 5, 3))
        self.assertEqual(etak.fresnel("gold", []).shape, (0, 3))

    def test_every_form_is_near_the_truth_as_far_as_it_says(self):
        c = np.linspace(0.05, 1, 50)
        truth = etak.fresnel("gold", c)
        self.assertEqual(list(etak.fresnel_forms())[0], "exact")
        for form in etak.fresnel_forms():
            out = etak.fresnel("gold", c, form=form)
            self.assertEqual(out.shape, truth.shape)
            if form == "f82":
                self.assertLess(np.abs(out - truth).max(), 0.03, form)
        f0 = etak.f0("gold").rgb
        schlick = f0 + (1 - f0) * (1 - c[:, None]) ** 5
        np.testing.assert_allclose(etak.fresnel("gold", c, form="schlick"), schlick, rtol=1e-10)

    def test_what_cannot_be_is_refused(self):
        for bad in (1.5, -0.1, np.nan):
            with self.assertRaisesRegex(etak.Error, "^cos_theta: .*; expected 0 to 1$"):
                etak.fresnel("gold", [0.5, bad])
        with self.assertRaisesRegex(etak.Error, "^form: snell; expected exact, schlick, .*f82"):
            etak.fresnel("gold", 1, form="snell")
        surface = next(m for m in map(etak.library.__getitem__, etak.library) if not m.preferred.has_n)
        with self.assertRaisesRegex(etak.Error, "has reflectance data only; expected n and k"):
            etak.fresnel(surface, 1)


if __name__ == "__main__":
    unittest.main()

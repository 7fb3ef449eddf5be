# SPDX-License-Identifier: Apache-2.0
import pickle
import unittest

import etak
from support import told


class Stacks(unittest.TestCase):
    def test_layers_and_base_are_the_text_of_the_command_line(self):
        blue = etak.stack([("water", 2e6), ("anatase", 50)], "titanium/palm-2018")
        self.assertEqual(list(etak.f0(blue).rgb), list(etak.f0("water:2mm/anatase:50nm/titanium/palm-2018").rgb))
        self.assertEqual([(id, nm, c) for id, _, nm, c in blue.stack],
                         [("water", 2e6, False), ("anatase", 50, True), ("titanium", None, False)])
        self.assertEqual(etak.f0(blue.label).hex, etak.f0(blue).hex)
        self.assertFalse(blue.has_n or blue.is_formula)
        self.assertIsNone(blue.wavelength)
        self.assertLess(blue.range[0], 400)
        self.assertIsNone(etak.read("gold").stack)

    def test_coherence_can_be_said(self):
        self.assertTrue(etak.stack([("water", 20000, True)], "copper").stack[0][3])
        self.assertFalse(etak.stack([("water", 200, False)], "copper").stack[0][3])

    def test_a_stack_has_the_spread_of_all_media_and_survives_a_pickle(self):
        blue = etak.stack([("anatase", 50)], "titanium")
        self.assertGreater(len(blue.material), 3)
        self.assertEqual(etak.f0(pickle.loads(pickle.dumps(blue))).hex, etak.f0(blue).hex)

    def test_faults_are_those_of_the_command_line(self):
        for layers, text in (([("anatase", -1)], "anatase:-1.0nm/titanium"), ([("anatase", float("nan"))], "anatase:nannm/titanium"),
                             ([("nobody", 3)], "nobody:3.0nm/titanium")):
            with self.assertRaises(etak.Error) as caught:
                etak.stack(layers, "titanium")
            self.assertEqual(str(caught.exception), told("f0", text))
        with self.assertRaisesRegex(etak.Error, "is a stack of layers"):
            etak.stack([("anatase", 50)], "titanium").n(550)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
"""All types are values: pickled, copied and compared they are the same, and none can be made without its contents."""
import copy
import dataclasses
import itertools
import json
import pickle
import unittest

import numpy as np

import etak
from support import InWorkFolder


class Values(InWorkFolder):
    def everything(self):
        gold = etak.f0("gold", space="acescg")
        report = etak.validate("textures", fail_on="never")
        packed = etak.pack("materials.json", "atlas", keep="all", force=True)
        choices = etak.choose(["gold", "water"], roughness=0.3)
        return [gold, etak.f0("water"), gold.spread, etak.library, etak.Library(),
                etak.library["silver"], etak.read("silver"), etak.read("water"), etak.read("gold").citation,
                etak.dataset([400, 700], n=[1.5, 1.5], name="mine"), report, report[0], report.files[0], packed, choices,
                choices[0]]

    def shown(self, value):
        """All that Python sees of a value."""
        out = {"str": str(value), "repr": repr(value)}
        names = [name for name in dir(type(value)) if isinstance(getattr(type(value), name), property)]
        if dataclasses.is_dataclass(value):
            names += [each.name for each in dataclasses.fields(value) if not each.name.startswith("_")]
        for name in names:
            each = getattr(value, name)
            out[name] = each.tolist() if isinstance(each, np.ndarray) else each
        for name in ("json", "_repr_html_"):
            if hasattr(value, name):
                out[name] = getattr(value, name)()
        if isinstance(value, etak.Report):
            for form in ("text", "json", "sarif", "junit", "github", "csv"):
                out[form] = value.form(form)
        return out

    def test_pickled_and_copied_they_show_the_same(self):
        for value in self.everything():
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                again = pickle.loads(pickle.dumps(value, protocol))
                with self.subTest(repr(value), protocol=protocol):
                    self.assertEqual(again, value)
                    self.assertEqual(hash(again), hash(value))
                    self.assertEqual(type(again), type(value))
            self.assertEqual(self.shown(again), self.shown(value), repr(value))
            self.assertEqual(self.shown(pickle.loads(pickle.dumps(again))), self.shown(value), repr(value))
            for each in (copy.copy(value), copy.deepcopy(value), copy.deepcopy([value])[0]):
                self.assertEqual(each, value)

    def test_they_are_equal_where_they_say_the_same_and_to_nothing_else(self):
        self.assertEqual(etak.f0("gold"), etak.f0("Au"))
        self.assertNotEqual(etak.f0("gold"), etak.f0("gold", illuminant="A"))
        self.assertNotEqual(etak.read("gold"), etak.library["gold"].dataset("mcp"))
        self.assertEqual(etak.library["gold"], etak.library["Au"])
        self.assertEqual(etak.Library(), etak.library)
        self.assertNotEqual(etak.Library("a"), etak.library)
        self.assertEqual(len({etak.f0("gold"), etak.f0("gold"), etak.f0("silver")}), 2)
        first, second = etak.validate("textures"), etak.validate("textures")
        self.assertEqual(first, second)
        self.assertEqual((first[0], first.files), (second[0], second.files))
        self.assertNotEqual(first[0], second[1])
        self.assertNotEqual(first.files[0], etak.validate("textures", only="ETK101").files[0])
        everything = self.everything()
        for a, b in itertools.combinations(everything, 2):
            if type(a) is not type(b):
                self.assertNotEqual(a, b)
        for value in everything:
            self.assertNotEqual(value, 3)
            self.assertFalse(value == "gold")

    def test_nothing_changes_an_attribute(self):
        for value in self.everything():
            for name in self.shown(value):
                if name not in ("str", "repr", "json", "_repr_html_"):
                    with self.subTest(type(value).__name__, name=name), self.assertRaises(AttributeError):
                        setattr(value, name, 1)

    def test_a_pickle_of_data_of_ones_own_is_whole(self):
        mine = pickle.loads(pickle.dumps(etak.dataset([380, 780], n=[1.5, 1.6], k=[0, 0.1], name="My own")))
        self.assertEqual(mine.n([380, 780]).tolist(), [1.5, 1.6])
        self.assertEqual(mine.material.name, "My own")
        self.assertEqual(etak.f0(mine), etak.f0(etak.dataset([380, 780], n=[1.5, 1.6], k=[0, 0.1], name="My own")))
        self.assertEqual(json.loads(etak.f0(mine).json())["results"][0]["hex"], etak.f0(mine).hex)

    def test_objects_without_contents_and_subclasses_are_refused(self):
        for value in self.everything():
            kind = type(value)
            with self.subTest(kind.__name__):
                for make in (lambda: kind.__new__(kind), kind if kind is not etak.Library else object.__new__, lambda: object.__new__(kind),
                             lambda: kind.__mro__[1].__new__(kind)):
                    with self.assertRaises(TypeError) as caught:
                        make()
                    self.assertNotIn("\n", str(caught.exception))
                with self.assertRaises(TypeError):
                    type("Sub", (kind,), {})

    def test_broken_pickles_and_those_of_other_versions_are_refused(self):
        restored, (kind, version, state) = etak.read("gold").__reduce__()
        with self.assertRaisesRegex(etak.Error, "pickle: of etak 9.9; expected etak"):
            restored(kind, "9.9", state)
        for bad in ((b"", 0), (state[0][:-1], 0), (state[0], 99), (b"\xff" * 64, 0)):
            with self.assertRaisesRegex(etak.Error, "^pickle: "):
                restored(kind, version, bad)
        for wrong in ((), (1, 2), (state,)):
            with self.assertRaises(TypeError):
                restored(kind, version, wrong)
        for value in self.everything():
            restored, (kind, version, state) = value.__reduce__()
            for i in range(len(state)):
                for bad in (b"\1" * 40, [], "x", None):
                    try:
                        repr(restored(kind, version, state[:i] + (bad,) + state[i + 1:]))
                    except (etak.Error, TypeError, ValueError, RuntimeError, IndexError):
                        pass


if __name__ == "__main__":
    unittest.main()

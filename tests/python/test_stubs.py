# SPDX-License-Identifier: Apache-2.0
"""The stubs, which the build writes, say what the compiled module holds: by mypy's stubtest where it is present, by names everywhere."""
import ast
import dataclasses
import importlib.util
import inspect
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import etak
import etak._core

STUBS = Path(etak.__file__).with_name("_core.pyi")


def is_public(name):
    return not name.startswith("_")


def names_in_stubs():
    """Of the module and of each class: the names that the stubs declare."""
    module, classes = set(), {}
    for node in ast.parse(STUBS.read_text()).body:
        if isinstance(node, ast.ClassDef):
            module.add(node.name)
            classes[node.name] = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            module.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            module.add(node.target.id)
    return module, classes


class Stubs(unittest.TestCase):
    def test_every_public_name_has_a_stub_and_no_stub_is_without_a_name(self):
        module, classes = names_in_stubs()
        self.assertEqual({n for n in module if is_public(n)}, {n for n in dir(etak._core) if is_public(n)})
        for name, members in classes.items():
            if name == "Error":
                continue
            real = {n for n in dir(getattr(etak._core, name)) if is_public(n)}
            self.assertEqual({n for n in members if is_public(n)}, real, name)

    def test_every_public_name_is_documented(self):
        for name in etak.__all__:
            each = getattr(etak, name)
            if inspect.isclass(each) or inspect.isfunction(each):
                self.assertTrue((each.__doc__ or "").strip(), name)
        _, classes = names_in_stubs()
        for name in classes:
            for member, value in vars(getattr(etak._core, name)).items():
                if is_public(member) and isinstance(value, property):
                    self.assertTrue((value.__doc__ or "").strip(), f"{name}.{member}")

        for kind in filter(dataclasses.is_dataclass, map(etak.__dict__.get, etak.__all__)):
            for each in dataclasses.fields(kind):
                if is_public(each.name):
                    meaning = re.escape(each.metadata["meaning"])
                    self.assertRegex(kind.__doc__, rf"\n  {each.name} +{meaning}")
            for member, value in vars(kind).items():
                if is_public(member) and (isinstance(value, property) or inspect.isfunction(value)):
                    self.assertTrue((value.__doc__ or "").strip(), f"{kind}.{member}")

    def test_the_package_says_that_it_is_typed(self):
        self.assertTrue(STUBS.with_name("py.typed").exists())

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "no mypy")
    def test_stubtest_finds_no_difference(self):
        with tempfile.TemporaryDirectory() as folder:
            # The classes of pybind11 have a metaclass and an __init__ that refuses all arguments.
            allowed = Path(folder, "allowed")
            allowed.write_text(r"etak\.((_core|convert|documents|notebook)\.)?[A-Z]\w*(\.__init__)?" "\n")
            done = subprocess.run(
                [sys.executable, "-m", "mypy.stubtest", "etak", "--ignore-missing-stub", "--allowlist", allowed],
                capture_output=True, text=True, cwd=folder,
                env={**os.environ, "MYPYPATH": str(STUBS.parent.parent)})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "no mypy")
    def test_a_program_that_uses_etak_is_checked(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "uses.py").write_text(
                "import etak\n"
                "findings: 'list[etak.Finding]' = list(etak.validate('textures'))\n"
                "count: int = etak.pack('a', 'b').materials\n"
                "hex: str = etak.f0('gold', illuminant='A').hex\n"
                "shape = etak.f0(n=[1, 1], wavelength=[380, 780]).shape\n"
                "wrong: int = etak.read('gold').label\n"
                "etak.f0('gold', illuminate='A')\n"
                "other: int = etak.validate('textures')[0].rule\n"
                "ids: 'list[str]' = [each.id for each in etak.library['gold']]\n")
            done = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "uses.py"], capture_output=True, text=True, cwd=folder,
                env={**os.environ, "MYPYPATH": str(STUBS.parent.parent)})
        self.assertEqual([line.split(":")[1] for line in done.stdout.splitlines() if ": error:" in line], ["6", "7", "8"],
                         done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()

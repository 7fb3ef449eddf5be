# SPDX-License-Identifier: Apache-2.0
"""The examples of the docstrings are doctests, and the recipes of resources/doc/python.md run as they stand there.

Pictures of the recipes go to the folder ETAK_RECIPES, for people to look at; without it nowhere.
"""
import doctest
import importlib.util
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

import etak
import etak.convert
from support import InWorkFolder

PAGE = Path(__file__).parents[2] / "resources/doc/python.md"


def recipes():
    """The title and the code of every recipe."""
    text = PAGE.read_text()
    return re.findall(r"^## ([^\n]*)\n(?:(?!^## ).)*?^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


class Documentation(InWorkFolder):
    def test_examples_of_the_docstrings_are_true(self):
        for module in (etak, etak.convert):
            tests = [t for t in doctest.DocTestFinder().find(module, module.__name__, extraglobs={"etak": etak})
                     if t.examples]
            self.assertTrue(tests)
            runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
            said = []
            for test in tests:
                runner.run(test, out=said.append)
            self.assertEqual(runner.failures, 0, "".join(said))
        documented = {name for name in etak.__all__ if callable(getattr(etak, name)) and name.islower()}
        without = {n for n in documented if n != "library" and ">>>" not in (getattr(etak, n).__doc__ or "")}
        self.assertEqual(without, set())

    def test_examples_of_the_page_are_true(self):
        examples = re.findall(r"^```pycon\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
        self.assertTrue(examples)
        names = {}
        runner, said = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS), []
        for text in examples:
            test = doctest.DocTestParser().get_doctest(text, names, "python.md", str(PAGE), 0)
            runner.run(test, out=said.append, clear_globs=False)
            names = test.globs
        self.assertEqual(runner.failures, 0, "".join(said))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "no matplotlib")
    def test_recipes_run_and_draw_what_they_say(self):
        found = recipes()
        self.assertGreaterEqual(len(found), 5)
        kept = os.environ.get("ETAK_RECIPES")
        for title, code in found:
            with self.subTest(title):
                lines = [line for line in code.splitlines() if line.strip() and not line.startswith("import")]
                self.assertLessEqual(len(lines), 10, "a recipe has at most ten lines")
                done = subprocess.run(
                    [sys.executable, "-c", code], capture_output=True, text=True,
                    env={**os.environ, "MPLBACKEND": "Agg"})
                self.assertEqual(done.returncode, 0, done.stderr)
                for name in re.findall(r'savefig\("([^"]+)"', code):
                    picture = self.folder / name
                    self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
                    self.assertGreater(picture.stat().st_size, 4000, name)
                    if kept:
                        Path(kept).mkdir(parents=True, exist_ok=True)
                        (Path(kept) / name).write_bytes(picture.read_bytes())


if __name__ == "__main__":
    unittest.main()

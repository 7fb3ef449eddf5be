# SPDX-License-Identifier: Apache-2.0
"""What is installed as the component `python` can be imported alone, and finds its module of pictures."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class Install(unittest.TestCase):
    def test_the_installed_module_is_whole(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run([os.environ["CMAKE"], "--install", os.environ["ETAK_BUILD"], "--component", "python",
                            "--prefix", prefix], check=True, capture_output=True)
            files = {path.name for path in Path(prefix).rglob("*") if path.is_file()}
            self.assertEqual({name for name in files if not name.startswith("_core.cpython")},
                             {"__init__.py", "_core.pyi", "_pictures.so", "convert.py", "documents.py", "notebook.py", "py.typed"})
            folder = next(Path(prefix).rglob("__init__.py")).parents[1]
            self.assertEqual(folder.name, "dist-packages")
            said = subprocess.run(
                [sys.executable, "-c", "import etak; print(etak.__file__, etak.f0('gold', space='ACES2065-1').hex)"],
                capture_output=True, text=True, check=True, cwd=prefix,
                env={**os.environ, "PYTHONPATH": str(folder)}).stdout.split()
            self.assertEqual(said, [str(folder / "etak/__init__.py"), "#ffe49c"])

    def test_the_module_of_pictures_is_found_from_any_folder(self):
        code = ("import os, sys; sys.path.insert(0, os.path.relpath(os.environ['MODULES'])); import etak; os.chdir('/');"
                "print(etak.f0('gold', space='ACES2065-1').hex)")
        environment = {**os.environ, "MODULES": os.environ["PYTHONPATH"]}
        del environment["PYTHONPATH"]
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
        self.assertEqual((said.stdout, said.stderr), ("#ffe49c\n", ""))

    def test_without_the_module_of_pictures_the_message_names_it(self):
        with tempfile.TemporaryDirectory() as folder:
            package = Path(folder) / "etak"
            package.mkdir()
            for path in Path(os.environ["PYTHONPATH"], "etak").iterdir():
                if path.is_file() and path.name != "_pictures.so":
                    (package / path.name).write_bytes(path.read_bytes())
            said = subprocess.run(
                [sys.executable, "-c", "import etak; print(etak.f0('gold').hex); etak.f0('gold', space='ACES2065-1')"],
                capture_output=True, text=True, cwd=folder, env={**os.environ, "PYTHONPATH": folder})
            self.assertEqual(said.stdout, "#ffe49c\n")
            self.assertIn(f"etak.Error: space: needs etak/_pictures.so; is not {package}/_pictures.so; expected an etak "
                          "built with OpenImageIO and OpenColorIO", said.stderr)


if __name__ == "__main__":
    unittest.main()

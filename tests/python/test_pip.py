# SPDX-License-Identifier: Apache-2.0
"""`pip install .` of a checkout and of an sdist, without a network, in a virtual environment. The build folder of the tests
is used, because building anew takes many minutes; that an sdist is whole is seen by configuring it."""
import importlib.util
import os
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
# No index can be asked: what is not there fails at once.
OFFLINE = {**os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_CONFIG_FILE": os.devnull}
for name in ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE"):
    OFFLINE.pop(name, None)


def run(*command, **more):
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True, **{"env": OFFLINE, **more})
    if done.returncode != 0:
        raise AssertionError(done.stdout[-4000:] + done.stderr[-4000:])
    return done.stdout


@unittest.skipUnless(importlib.util.find_spec("pip") and importlib.util.find_spec("ensurepip"), "no python3-pip and python3-venv")
class Pip(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        run(sys.executable, "-m", "venv", "--system-site-packages", cls.folder / "venv")
        cls.python = cls.folder / "venv/bin/python"

    def install(self, source):
        run(self.python, "-m", "pip", "install", "--force-reinstall", "--no-deps",
            f"--config-settings=build-dir={os.environ['ETAK_BUILD']}", source, cwd=self.folder)
        said = run(self.python, "-c", "import etak, etak.convert; print(etak.__file__, etak.__version__, etak.f0('gold').hex,"
                   "etak.f0('gold', space='ACES2065-1').hex)", cwd=self.folder).split()
        self.assertTrue(said[0].startswith(str(self.folder / "venv")), said)
        self.assertEqual(said[2:], ["#ffe49c", "#ffe49c"])
        shown = run(self.python, "-m", "pip", "show", "-f", "etak", cwd=self.folder)
        self.assertIn(f"Version: {said[1]}", shown)
        self.assertIn("Requires: numpy", shown)
        self.assertIn("etak/py.typed", shown)

    def test_a_checkout_is_installed(self):
        self.install(ROOT)

    @unittest.skipUnless((ROOT / ".git").exists(), "no checkout of git")
    def test_an_sdist_holds_what_git_tracks_and_is_installed(self):
        code = "import sys; sys.path.insert(0, 'app/python'); import build_backend as b; print(b.build_sdist(sys.argv[1]))"
        name = run(sys.executable, "-c", code, self.folder, cwd=ROOT).strip()
        with tarfile.open(self.folder / name) as archive:
            archive.extractall(self.folder)
        source = self.folder / name[:-len(".tar.gz")]
        held = {str(path.relative_to(source)) for path in source.rglob("*") if path.is_file()}
        tracked = {os.fsdecode(each) for each in subprocess.run(
            ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.split(b"\0") if each}
        self.assertEqual(held, {each for each in tracked if (ROOT / each).is_file()} | {"PKG-INFO"})
        run(os.environ["CMAKE"], "-S", source, "-B", self.folder / "build", "-DETAK_BUILD_EDITOR=OFF", "-DETAK_BUILD_PYTHON=ON")
        self.install(self.folder / name)
        # An sdist makes the same sdist again.
        again = run(sys.executable, "-c", code, self.folder / "venv", cwd=source).strip()
        with tarfile.open(self.folder / name) as first, tarfile.open(self.folder / "venv" / again) as second:
            self.assertEqual(sorted(second.getnames()), sorted(n for n in first.getnames() if "__pycache__" not in n))

    def test_a_wheel_names_what_it_is_for_and_holds(self):
        run(self.python, "-m", "pip", "wheel", "--no-deps", "-w", self.folder, ROOT,
            f"--config-settings=build-dir={os.environ['ETAK_BUILD']}")
        wheel = next(self.folder.glob("etak-*.whl"))
        self.assertRegex(wheel.name, r"^etak-[0-9.]+-cp3\d+-cp3\d+-\w+\.whl$")
        with zipfile.ZipFile(wheel) as held:
            names = held.namelist()
            record = held.read(next(n for n in names if n.endswith("/RECORD"))).decode().splitlines()
        self.assertEqual([line.split(",")[0] for line in record], names)
        self.assertEqual({n for n in names if n.startswith("etak/") and "/_core.cpython" not in n},
                         {f"etak/{n}" for n in ("__init__.py", "_core.pyi", "_pictures.so", "convert.py", "documents.py", "notebook.py", "py.typed")})


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
"""What pip asks for when it installs etak from a checkout or an sdist: a wheel of the component `python`, made by CMake
(PEP 517 and 427), and an sdist of the files that git tracks. The standard library is all that it needs.

Settings (`pip install . --config-settings=NAME=VALUE`):
  cmake-args   more arguments for cmake, with blanks between, such as -DETAK_BUILD_PICTURES=OFF
  build-dir    the folder to build in: one that is configured already is used as it is; without it build/pip
"""
import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"^project\(etak VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
METADATA = f"""Metadata-Version: 2.1
Name: etak
Version: {VERSION}
Summary: Measured optics into materials a renderer can trust
License: Apache-2.0
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: plot
Requires-Dist: matplotlib; extra == "plot"
Description-Content-Type: text/markdown

{(ROOT / "README.md").read_text()}"""


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_sdist(sdist_directory, config_settings=None):
    name = f"etak-{VERSION}"
    (Path(sdist_directory) / f"{name}.tar.gz").unlink(missing_ok=True)
    with tarfile.open(Path(sdist_directory) / f"{name}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as out:
        with tempfile.NamedTemporaryFile("w", suffix="PKG-INFO") as info:
            info.write(METADATA)
            info.flush()
            out.add(info.name, f"{name}/PKG-INFO")
        for each in _sources():
            out.add(ROOT / each, f"{name}/{each}", recursive=False)
    return f"{name}.tar.gz"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag += f"-{tag}-" + re.sub("[-.]", "_", sysconfig.get_platform())
    name = f"etak-{VERSION}-{tag}.whl"
    info = f"etak-{VERSION}.dist-info"
    files = {f"{info}/METADATA": METADATA.encode(), f"{info}/LICENSE": (ROOT / "LICENSE").read_bytes(),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: etak\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()}
    with tempfile.TemporaryDirectory() as prefix:
        package = _install(prefix, config_settings or {})
        for path in sorted(package.iterdir()):
            files[f"etak/{path.name}"] = path.read_bytes()
    record = f"{info}/RECORD"
    rows = [f"{path},sha256={_digest(data)},{len(data)}\n" for path, data in files.items()]
    files[record] = "".join([*rows, f"{record},,\n"]).encode()
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as out:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path)  # of 1980, so that the same files make the same bytes
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(entry, data)
    return name


def _install(prefix, settings):
    """The folder of the package, built and installed below `prefix`."""
    build = Path(settings.get("build-dir") or ROOT / "build/pip").resolve()
    cmake = os.environ.get("CMAKE", "cmake")
    more = shlex.split(settings.get("cmake-args", ""))
    if more or not (build / "CMakeCache.txt").exists():
        _run(cmake, "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DETAK_BUILD_PYTHON=ON",
             "-DETAK_BUILD_EDITOR=OFF", "-DETAK_BUILD_TESTS=OFF", "-DCMAKE_UNITY_BUILD=ON",
             "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", *(["-GNinja"] if shutil.which("ninja") else []),
             f"-DPython_EXECUTABLE={sys.executable}", *more)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
    _run(cmake, "--build", build, "--target", "etak-python", "--parallel", jobs)
    _run(cmake, "--install", build, "--component", "python", "--strip", "--prefix", prefix)
    return next(Path(prefix).rglob("etak/__init__.py")).parent


def _run(*command):
    done = subprocess.run([str(each) for each in command])
    if done.returncode != 0:
        raise SystemExit(f"etak: {command[0]} {command[1]} failed; resources/doc/install.md names the Debian packages that "
                         "the build needs")


def _sources():
    """The paths of an sdist: what git tracks; of an sdist itself all that it holds, but for build/."""
    if (ROOT / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout
        return sorted(os.fsdecode(each) for each in listed.split(b"\0") if each and (ROOT / os.fsdecode(each)).is_file())
    files = (path.relative_to(ROOT) for path in ROOT.rglob("*") if path.is_file())
    return sorted(str(each) for each in files
                  if each.parts[0] != "build" and "__pycache__" not in each.parts and str(each) != "PKG-INFO")


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()

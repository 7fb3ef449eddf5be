# SPDX-License-Identifier: Apache-2.0
"""Measured optics into materials that a renderer can trust.

>>> import etak
>>> gold = etak.f0("gold")
>>> gold.hex
'#ffe49c'
>>> gold.rgb.round(3)
array([1.043, 0.774, 0.335])

Wavelengths are in nanometres. Colours are linear, in sRGB where nothing else is asked for, and never clipped.
The keywords of these functions are the options of the command line, with _ for -, and mean the same. What cannot
be used raises `etak.Error`, a ValueError, whose text is that of the command line. Every function may be called
from several threads at once; they compute without the interpreter's lock.
"""

from __future__ import annotations

import os as _os
from typing import TYPE_CHECKING, Any, Callable, Optional, Union, overload

from . import _core
from ._core import (
    CheckedFile, Choice, Choices, Citation, Dataset, Error, F0, Finding, Library, Material, Packed, Report, Spread,
    __version__, library)

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

_core._start(_os.path.abspath(__path__[0]))

__all__ = [
    "CheckedFile", "Choice", "Choices", "Citation", "Dataset", "Error", "F0", "Finding", "Library", "Material",
    "Packed", "Report", "Spread", "__version__", "choose", "dataset", "f0", "fresnel", "fresnel_forms", "library",
    "pack", "pack_settings", "read", "validate"]

for _each in (CheckedFile, Choice, Choices, Citation, Dataset, F0, Finding, Library, Material, Packed, Report, Spread):
    _each.__module__ = "etak"
del _each

Path = Union[str, Any]  # anything with __fspath__, too
Number = Union[str, float]


@overload
def f0(
    material: Any, *, dataset: str = ..., axis_average: bool = ..., observer: Optional[str] = ...,
    illuminant: Optional[str] = ..., interpolation: Optional[str] = ..., method: Optional[str] = ...,
    integration_bound: Optional[Number] = ..., space: Optional[str] = ..., ocio: Optional[Path] = ...,
    outside: Optional[Number] = ..., allow_extrapolation: bool = ..., unit: Optional[str] = ...,
    columns: Optional[str] = ..., duplicates: Optional[str] = ..., library: Library = ...,
) -> F0: ...


@overload
def f0(
    *, n: Any = ..., k: Any = ..., wavelength: Any, reflectance: Any = ..., observer: Optional[str] = ...,
    illuminant: Optional[str] = ..., interpolation: Optional[str] = ..., method: Optional[str] = ...,
    integration_bound: Optional[Number] = ..., space: Optional[str] = ..., ocio: Optional[Path] = ...,
    outside: Optional[Number] = ..., allow_extrapolation: bool = ..., library: Library = ..., threads: int = ...,
) -> npt.NDArray[np.float64]: ...


def f0(
    material: Any = None, *, n: Any = None, k: Any = None, wavelength: Any = None, reflectance: Any = None,
    dataset: str = "", axis_average: bool = False, observer: Optional[str] = None, illuminant: Optional[str] = None,
    interpolation: Optional[str] = None, method: Optional[str] = None, integration_bound: Optional[Number] = None,
    space: Optional[str] = None, ocio: Optional[Path] = None, outside: Optional[Number] = None,
    allow_extrapolation: bool = False, unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, library: Library = library, threads: int = 0,
) -> Any:
    """Reflectance at normal incidence as a colour.

    Of a material, as an `etak.F0`:
      material       a name ("gold", "Au", "gold/johnson-1972"), the path of a page, table or material file, or a
                     Material or Dataset. A pathlib.Path is always a file
      dataset        its id or unique beginning, in place of the preferred one
      axis_average   crystals as random grains
      unit, columns, duplicates   how tables are read, as `etak f0 --help-all` tells

    Of arrays, as an array of float64 of shape (N, 3), or (3,) for a single spectrum:
      wavelength     M wavelengths in nm, ascending
      n, k           (N, M) or (M,); without k, k is 0
      reflectance    the same, in place of n and k
      threads        0: all cores

    Of both:
      illuminant     D65, D50, A or E              observer        1931-2deg or 1964-10deg
      interpolation  linear or pchip               method          1nm, exact, auto, 5nm, ...
      space          srgb, acescg, rec2020, display-p3, xyz, or one of an OpenColorIO config (`ocio`)
      outside        the medium in front: an index of refraction or a material

    Data that hold less than 0.95 of the luminous weight are refused unless allow_extrapolation is true.

    >>> etak.f0("gold", dataset="mcpeak", space="acescg")
    <etak.F0 gold/mcpeak-2015: #ffe59e, 0.9277 0.7965 0.4058 in acescg>
    >>> etak.f0("silver", illuminant="D66")
    Traceback (most recent call last):
    etak.Error: illuminant: D66; expected D65, D50, A or E
    >>> import numpy as np
    >>> w = np.linspace(380, 780, 5)
    >>> etak.f0(n=[[1.5] * 5, [2.0] * 5], wavelength=w).round(6)
    array([[0.04    , 0.04    , 0.04    ],
           [0.111111, 0.111111, 0.111111]])
    """
    settings = {
        "observer": observer, "illuminant": illuminant, "interpolation": interpolation, "method": method,
        "integration_bound": integration_bound, "space": space, "ocio": ocio, "outside": outside,
        "allow_extrapolation": allow_extrapolation, "unit": unit, "columns": columns, "duplicates": duplicates}
    if material is None:
        return _core.f0_of_rows(n, k, reflectance, wavelength, settings, library, threads)
    if n is not None or k is not None or reflectance is not None or wavelength is not None:
        raise Error("material: is given beside arrays; expected one of the two")
    return _core.f0(material, dataset, axis_average, settings, library)


def read(
    material: Any, *, dataset: str = "", unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, library: Library = library,
) -> Dataset:
    """The dataset that a name or a file stands for, as f0() takes it.

    >>> gold = etak.read("gold")
    >>> gold.n([500, 600]).round(3), round(gold.k(600), 3)
    (array([0.82 , 0.204]), 3.122)
    """
    return _core.read(material, dataset, {"unit": unit, "columns": columns, "duplicates": duplicates}, library)


def dataset(
    wavelength: Any, *, n: Any = None, k: Any = None, reflectance: Any = None, name: str = "given",
) -> Dataset:
    """A dataset of one's own numbers, which f0() and fresnel() take as they take those of the library.

    >>> glass = etak.dataset([380, 780], n=[1.52, 1.51], k=[0, 0], name="a glass")
    >>> etak.f0(glass).hex
    '#3a3a3a'
    """
    return _core.dataset(wavelength, n, k, reflectance, name)


def fresnel(
    material: Any, cos_theta: Any, *, form: str = "exact", dataset: str = "", observer: Optional[str] = None,
    illuminant: Optional[str] = None, outside: Optional[Number] = None, allow_extrapolation: bool = False,
    unit: Optional[str] = None, columns: Optional[str] = None, duplicates: Optional[str] = None,
    library: Library = library, threads: int = 0,
) -> npt.NDArray[np.float64]:
    """Reflectance over the angle of incidence: linear sRGB, unclipped, as an array of the shape of cos_theta and 3.

      material    as f0() takes it; its data need n
      cos_theta   cosines of incidence, 0 to 1; any shape
      form        "exact" (n and k of every nanometre), or one that shaders can have, with the numbers that fit this
                  material best; fresnel_forms() names them

    >>> etak.fresnel("gold", [1, 0.5, 0], form="schlick").round(3)
    array([[1.043, 0.774, 0.335],
           [1.041, 0.781, 0.355],
           [1.   , 1.   , 1.   ]])
    """
    settings = {
        "observer": observer, "illuminant": illuminant, "outside": outside, "allow_extrapolation": allow_extrapolation,
        "unit": unit, "columns": columns, "duplicates": duplicates}
    return _core.fresnel(material, cos_theta, form, dataset, settings, library, threads)


def fresnel_forms() -> "dict[str, str]":
    """The forms of fresnel(), each with its title.

    >>> etak.fresnel_forms()["f82"]
    'F82'
    """
    return _core.fresnel_forms()


def validate(
    paths: Any, *, role: Optional[str] = None, material: Optional[str] = None, surface: Optional[str] = None,
    transfer: Optional[str] = None, alpha: Optional[str] = None, profile: Optional[str] = None, only: Any = None,
    select: Any = None, extend_select: Any = None, ignore: Any = None, fail_on: Optional[str] = None,
    config: Optional[Path] = None, no_config: bool = False, baseline: Optional[Path] = None,
    today: Optional[str] = None, allow_empty: bool = False, cache: Optional[Path] = None,
    cache_size: Optional[Number] = None, library: Library = library,
    threads: int = 0, progress: Optional[Callable[[int, int], object]] = None,
) -> Report:
    """Finds impossible materials in textures, atlases, scenes and data.

      paths      a file or folder, or several
      role       diffuse, specular, f0, base-color or metal-rough, of all pictures; without it by their names
      only, select, extend_select, ignore   rules: ids, or prefixes such as "ETK1"
      fail_on    the least severity that fails: error, warning, info or never
      config     the configuration; without it the etak.toml of the first folder upwards, unless no_config is true
      cache      folder that keeps results, so that the same files are not checked again; cache_size: the most that it
                 may take, in bytes or as "500M"
      progress   called as progress(done, all)

    The report is a sequence of findings. What cannot be read is a finding as well, and makes it incomplete.

    >>> report = etak.validate("textures")
    >>> report.passed
    False
    >>> [(finding.rule, finding.limit) for finding in report if finding.severity == "error"]
    [('ETK101', '20 % to 45 %'), ('ETK402', 'codes 36 to 84')]
    """
    settings = {
        "role": role, "material": material, "surface": surface, "transfer": transfer, "alpha": alpha,
        "profile": profile, "only": only, "select": select, "extend_select": extend_select, "ignore": ignore,
        "fail_on": fail_on, "config": config, "no_config": no_config, "baseline": baseline, "today": today,
        "allow_empty": allow_empty, "cache": cache, "cache_size": cache_size}
    return _core.validate(paths, settings, library, threads, progress)


def pack(
    input: Path, output: Path, *, force: bool = False, update: bool = False, dry_run: bool = False,
    validate: bool = True, fail_on: Optional[str] = None, config: Optional[Path] = None, no_config: bool = False,
    memory: Optional[Number] = None, library: Library = library, threads: int = 0,
    progress: Optional[Callable[[int, int], object]] = None, **settings: Any,
) -> Packed:
    """Packs the materials of a scene, a manifest or a folder of pictures into one atlas.

      input      manifest or project (.json), glTF scene (.gltf, .glb), or folder of pictures
      output     the folder to write; all files appear at once, or none
      force      replace files that are of no earlier atlas
      update     do nothing where the result of the same input and settings is in place
      validate   check the pages; fail_on, config and no_config are those of validate()
      memory     the most that pages may take: bytes, or "512M"
      settings   those of `etak pack`: page=2048, islands=True, format="png,ktx2", ...; pack_settings() lists them

    >>> packed = etak.pack("materials.json", "atlas", page=1024, keep="all")
    >>> packed.materials, packed.report.passed
    (2, True)
    """
    run = {"force": force, "update": update, "dry_run": dry_run, "validate": validate, "memory": memory}
    check = {"fail_on": fail_on, "config": config, "no_config": no_config}
    return _core.pack(input, output, run, check, settings, library, threads, progress)


def pack_settings() -> "dict[str, str]":
    """What else pack() takes by keyword, each with its meaning.

    >>> print(etak.pack_settings()["page"])
    largest side of a page
    """
    return _core.pack_settings()


def choose(
    materials: Any, *, budget: float = 1, codes: bool = False, gloss: Optional[float] = None,
    roughness: Optional[float] = None, costs: Optional[Path] = None, library: Library = library, threads: int = 0,
    progress: Optional[Callable[[int, int], object]] = None,
) -> Choices:
    """The cheapest way to draw materials within a budget of error.

      materials   a material as f0() takes it, several, or the path of a scene
      budget      largest difference of F at any angle and of any pixel, in CIEDE2000, or in 8-bit codes where
                  codes is true
      gloss, roughness   of the sphere that is compared; without them by the material's class
      costs       a cost table of `etak choose --write-costs`

    >>> choice = etak.choose("gold", roughness=0.3)[0]
    >>> choice.fresnel, choice.met
    ('f82', True)
    """
    return _core.choose(materials, budget, codes, gloss, roughness, costs, library, threads, progress)

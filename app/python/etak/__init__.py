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
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, List, NamedTuple, Optional, Tuple, Union, overload

from . import _core
from ._core import Citation, Dataset, Error, F0, Library, Material, Spread, __version__, library

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from .documents import CheckedFile, Choice, Choices, Finding, Packed, Report

_core._start(_os.path.abspath(__path__[0]))

__all__ = [
    "Candidate", "CheckedFile", "Choice", "Choices", "Citation", "Dataset", "Error", "F0", "Finding", "Identified", "Library", "Material",
    "Near", "Packed", "Report", "Spread", "__version__", "choose", "curve", "dataset", "delta_e", "export", "f0",
    "fresnel", "fresnel_forms", "functions", "identify", "library", "nearest", "pack", "pack_settings", "plot", "read", "sources",
    "stack", "validate"]


def _documents() -> Any:
    # Imported when first needed: it would be a quarter of the time that `import etak` takes.
    from . import documents
    return documents


def __getattr__(name: str) -> Any:
    if name in ("CheckedFile", "Choice", "Choices", "Finding", "Packed", "Report"):
        return getattr(_documents(), name)
    if name == "convert":
        from importlib import import_module
        return import_module("etak.convert")
    raise AttributeError(f"module 'etak' has no attribute {name!r}")


def __dir__() -> "list[str]":
    # eval is no part of __all__: `from etak import *` would hide Python's own.
    return sorted([*__all__, "convert", "eval", "__all__", "__doc__", "__file__", "__name__", "__path__"])


for _each in (Citation, Dataset, F0, Library, Material, Spread):
    _each.__module__ = "etak"
del _each

from . import notebook as _notebook  # noqa: E402: the types have their names by now

for _each, _name, _method in (
        (Citation, "bibtex", _notebook.bibtex),
        (Dataset, "plot", _notebook.plot_dataset), (Dataset, "_repr_html_", _notebook.dataset_html),
        (Material, "plot", _notebook.plot_material), (Material, "_repr_html_", _notebook.material_html),
        (Library, "_repr_html_", _notebook.library_html)):
    setattr(_each, _name, _method)
del _each, _name, _method

Path = Union[str, Any]  # anything with __fspath__, too
Number = Union[str, float]
Table = Union[str, Tuple[Any, Any], None]  # a word, or (wavelength, values)


def _restored(kind: Any, version: str, state: "tuple[Any, ...]") -> Any:
    # Pickles call it. The bytes in them are those of one version.
    if version != __version__:
        raise Error(f"pickle: of etak {version}; expected etak {__version__}, or the call that made it")
    return kind._restore(*state)


class Near(NamedTuple):
    """A material that nearest() found, the hex colour of its F0, the distance, and that over the distance within which nine
    of ten new publications would lie (None where the material has no band)."""

    material: Material
    hex: str
    delta_e: float
    band_share: Optional[float]


class Candidate(NamedTuple):
    """A material that a colour could be: its probability, CIEDE2000 from its F0, and that over `band["de90"]`."""

    material: Material
    p: float
    delta_e: float
    band_share: float


class Identified(NamedTuple):
    """What identify() answers to a colour: "sure", "ambiguous" or "none", the most probable materials first, and the ids of
    those that cannot be told apart."""

    verdict: str
    candidates: List[Candidate]
    groups: List[List[str]]


@overload
def f0(  # type: ignore[misc]  # a list is no Any
    material: Union[List[Any], Tuple[Any, ...]], *, dataset: str = ..., axis_average: bool = ..., observer: Table = ...,
    illuminant: Table = ..., interpolation: Optional[str] = ..., method: Optional[str] = ...,
    integration_bound: Optional[Number] = ..., space: Optional[str] = ..., ocio: Optional[Path] = ...,
    outside: Optional[Number] = ..., aperture: Optional[float] = ..., scatter: Optional[float] = ...,
    coat: Optional[Number] = ..., allow_extrapolation: bool = ..., unit: Optional[str] = ...,
    columns: Optional[str] = ..., duplicates: Optional[str] = ..., material_class: Optional[str] = ...,
    origin: Optional[str] = ..., without: Any = ..., library: Library = ..., threads: int = ...,
) -> List[F0]: ...


@overload
def f0(
    material: Any, *, dataset: str = ..., axis_average: bool = ..., observer: Table = ...,
    illuminant: Table = ..., interpolation: Optional[str] = ..., method: Optional[str] = ...,
    integration_bound: Optional[Number] = ..., space: Optional[str] = ..., ocio: Optional[Path] = ...,
    outside: Optional[Number] = ..., aperture: Optional[float] = ..., scatter: Optional[float] = ...,
    coat: Optional[Number] = ..., allow_extrapolation: bool = ..., unit: Optional[str] = ...,
    columns: Optional[str] = ..., duplicates: Optional[str] = ..., material_class: Optional[str] = ...,
    origin: Optional[str] = ..., without: Any = ..., library: Library = ..., threads: int = ...,
) -> F0: ...


@overload
def f0(
    *, n: Any = ..., k: Any = ..., wavelength: Any, reflectance: Any = ..., observer: Table = ...,
    illuminant: Table = ..., interpolation: Optional[str] = ..., method: Optional[str] = ...,
    integration_bound: Optional[Number] = ..., space: Optional[str] = ..., ocio: Optional[Path] = ...,
    outside: Optional[Number] = ..., allow_extrapolation: bool = ..., unit: Optional[str] = ...,
    library: Library = ..., threads: int = ...,
) -> npt.NDArray[np.float64]: ...


def f0(
    material: Any = None, *, n: Any = None, k: Any = None, wavelength: Any = None, reflectance: Any = None,
    dataset: str = "", axis_average: bool = False, observer: Table = None, illuminant: Table = None,
    interpolation: Optional[str] = None, method: Optional[str] = None, integration_bound: Optional[Number] = None,
    space: Optional[str] = None, ocio: Optional[Path] = None, outside: Optional[Number] = None,
    aperture: Optional[float] = None, scatter: Optional[float] = None, coat: Optional[Number] = None,
    allow_extrapolation: bool = False, unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, material_class: Optional[str] = None, origin: Optional[str] = None,
    without: Any = None, library: Library = library, threads: int = 0,
) -> Any:
    """Reflectance at normal incidence as a colour.

    Of a material, as an `etak.F0`; of a list or tuple of materials, as a list of them:
      material       a name ("gold", "Au", "gold/johnson-1972"), the path of a page, table or material file, or a
                     Material or Dataset. A pathlib.Path is always a file
      dataset        its id or unique beginning, in place of the preferred one
      axis_average   crystals as random grains
      aperture, scatter   the mean over the cone of an objective, and the share of the light that scatter takes away
      coat           a clear layer over it: an index, or a clear material, maybe with a thickness ("water:2mm"); F0.coat
      unit, columns, duplicates   how tables are read, as `etak f0 --help-all` tells
      material_class, origin      what a file does not say of itself: --class and --origin
      without        datasets whose publications are left out, as if they were not known: "titanium/johnson-1974", or a list

    Of arrays, as an array of float64 of shape (N, 3), or (3,) for a single spectrum:
      wavelength     M wavelengths, ascending, in `unit`: nm where none is given, um, A or eV
      n, k           (N, M) or (M,); without k, k is 0; or n alone, complex: n + 1j k
      reflectance    the same, in place of n and k

    Of all:
      illuminant     D65, D50, A or E, or one's own: (wavelength, power), arrays (M,) of 380 to 780 nm at least
      observer       1931-2deg or 1964-10deg, or one's own: (wavelength, functions), arrays (M,) and (M, 3)
      interpolation  linear or pchip               method          1nm, exact, auto, 5nm, ...
      space          srgb, acescg, rec2020, display-p3, xyz, or one of an OpenColorIO config (`ocio`)
      outside        the medium in front: an index of refraction or a material
      threads        0: all cores

    Data that hold less than 0.95 of the luminous weight are refused unless allow_extrapolation is true.

    >>> etak.f0("gold", dataset="mcpeak", space="acescg")
    <etak.F0 gold/mcpeak-2015: #ffe59e, 0.9277 0.7965 0.4058 in acescg>
    >>> [each.hex for each in etak.f0(["gold", "silver"])]
    ['#ffe49c', '#fefdfc']
    >>> etak.f0("silver", illuminant="D66")
    Traceback (most recent call last):
    etak.Error: illuminant: D66; expected D65, D50, A, E or a file of wavelength and power
    >>> import numpy as np
    >>> w = np.linspace(380, 780, 5)
    >>> etak.f0(n=[[1.5] * 5, [2.0] * 5], wavelength=w).round(6)
    array([[0.04    , 0.04    , 0.04    ],
           [0.111111, 0.111111, 0.111111]])
    """
    given = locals()
    if material is None:
        for name in ("columns", "duplicates", "material_class", "origin", "aperture", "scatter", "coat", "without"):
            if given[name] is not None:
                raise Error(f"{name}: is given beside arrays; expected a material or a table in a file")
        return _core.f0_of_rows(given, library, threads)
    if n is not None or k is not None or reflectance is not None or wavelength is not None:
        raise Error("material: is given beside arrays; expected one of the two")
    several = isinstance(material, (list, tuple))
    out = _core.f0(list(material) if several else [material], dataset, axis_average, given, library, threads)
    return out if several else out[0]


def read(
    material: Any, *, dataset: str = "", unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, material_class: Optional[str] = None, origin: Optional[str] = None,
    library: Library = library,
) -> Dataset:
    """The dataset that a name or a file stands for, as f0() takes it.

    >>> gold = etak.read("gold")
    >>> gold.n([500, 600]).round(3), round(gold.k(600), 3)
    (array([0.82 , 0.204]), 3.122)
    """
    return _core.read(material, dataset, locals(), library)


def dataset(
    wavelength: Any, *, n: Any = None, k: Any = None, reflectance: Any = None, name: str = "given",
) -> Dataset:
    """A dataset of one's own numbers, which f0() and fresnel() take as they take those of the library. n may be complex.

    >>> glass = etak.dataset([380, 780], n=[1.52, 1.51], k=[0, 0], name="a glass")
    >>> etak.f0(glass).hex
    '#3a3a3a'
    """
    return _core.dataset(wavelength, n, k, reflectance, name)


def stack(layers: Iterable["tuple[Any, ...]"], base: str, *, library: Library = library) -> Dataset:
    """Flat layers on a base as a dataset, which f0() takes. Layers are (name, thickness in nm), the outermost first, or
    (name, thickness, coherent); where nothing is said they are coherent below 10 um.

    >>> blue = etak.stack([("anatase", 50)], "titanium")
    >>> etak.f0(blue).hex == etak.f0("anatase:50nm/titanium").hex
    True
    """
    text = ""
    for name, thickness, *coherent in layers:
        text += f"{name}:{float(thickness)!r}nm"
        text += "".join(":coherent" if each else ":incoherent" for each in coherent) + "/"
    return read(text + base, library=library)


def fresnel(
    material: Any, cos_theta: Any, *, form: str = "exact", dataset: str = "", observer: Table = None,
    illuminant: Table = None, outside: Optional[Number] = None, allow_extrapolation: bool = False,
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
    return _core.fresnel(material, cos_theta, locals(), library, threads)


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
    return _documents().report_of(_core.validate(paths, locals(), library, threads, progress), fail_on)


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
      settings   those of `etak pack`: page=2048, islands=True, textures="png,ktx2", ...; pack_settings() lists them

    >>> packed = etak.pack("materials.json", "atlas", page=1024, keep="all")
    >>> packed.materials, packed.report.passed
    (2, True)
    """
    return _documents().packed_of(_core.pack(locals(), settings, library, threads, progress), fail_on)


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
    return _documents().choices_of(_core.choose(materials, locals(), library, threads, progress))


def _asked_color(color: Any, linear: bool, library: Library) -> "tuple[Any, bool]":
    # A material or file is asked about by its unclipped F0.
    if isinstance(color, (Material, Dataset)) or hasattr(color, "__fspath__") or (
            isinstance(color, str) and not color.startswith("#")):
        color = f0(color, library=library)
    return (color.srgb, True) if isinstance(color, F0) else (color, linear)


def nearest(
    color: Any, *, linear: bool = False, count: int = 5, classes: Any = None, library: Library = library,
    threads: int = 0,
) -> "list[Near]":
    """The materials whose F0 is nearest to a colour by CIEDE2000, nearest first.

      color     "#rrggbb", three 8-bit codes, with linear=True three linear values, an answer of f0(), or what f0() takes
      classes   only of these classes; without it of all but surface, whose diffuse colours are no F0

    >>> [(each.material.id, round(each.delta_e, 1)) for each in etak.nearest("#ffe49c", count=1)]
    [('gold', 0.0)]
    """
    color, linear = _asked_color(color, linear, library)
    return [Near(*each) for each in _core.nearest(color, linear, count, classes, library, threads)]


def identify(
    color: Any = None, *, linear: bool = False, f82: Any = None, classes: Any = None,
    prior: Optional[Dict[str, float]] = None, without: Any = None, film: Optional[str] = None, oxide: Any = None,
    measured: Optional[Path] = None, stack: Optional[str] = None, library: Library = library, threads: int = 0,
) -> Any:
    """Which material a colour could be, as `Identified`; of a list of colours a list of them.

      color     as nearest() takes it
      f82       the reflectance at 82 degrees, in the form of color
      prior     how much more likely materials are than the others, whose weight is 1: {"gold": 10}
      without   datasets whose publications are left out: "gold/mcpeak-2015", or a list
      film      the metal under a film: then the answers are films with their thicknesses, dictionaries as the JSON of
                `etak identify` has them; oxide: those that are tried
      measured  in place of a colour: a table of wavelength and reflectance of a `stack` with one unknown thickness,
                "polystyrene:?nm/silicon"; the answer is a dictionary

    >>> answer = etak.identify("#ffe49c")
    >>> answer.verdict, answer.candidates[0].material.id
    ('ambiguous', 'gold')
    """
    import json

    given = locals()
    several = isinstance(color, list) and not all(isinstance(each, (int, float)) for each in color)
    asked = color if several else [] if color is None else [color]
    if (measured is None) == (not asked):
        raise Error("color: expected a colour, or measured with a stack, one of the two")
    pairs = [_asked_color(each, linear, library) for each in asked]
    given["linear"] = any(is_linear for _, is_linear in pairs)
    given["prior"] = prior and "id,weight\n" + "".join(f"{name},{weight}\n" for name, weight in prior.items())
    rows = json.loads(_core.identify([each for each, _ in pairs], given, library, threads))["results"]
    if measured is not None:
        return rows[0]
    if film is None:
        rows = [Identified(row["verdict"], [
            Candidate(library[each["id"]], each["p"], each["delta_e"], each["band_share"]) for each in row["candidates"]],
            row["groups"]) for row in rows]
    return rows if several else rows[0]


def delta_e(a: Any, b: Any) -> Any:
    """CIEDE2000 of two colours: hex texts, answers of f0(), or linear sRGB of shape (..., 3), which are broadcast.

    >>> round(etak.delta_e(etak.f0("gold"), "#ffe49c"), 2) < 3
    True
    """
    def linear(color: Any) -> Any:
        return _core.hex_color(color) if isinstance(color, str) else color.srgb if isinstance(color, F0) else color

    out = _core.delta_e(linear(a), linear(b))
    return out if out.ndim else float(out)


def export(
    materials: Any, to: str = "values", *, target: Any = None, gloss: Optional[float] = None,
    roughness: Optional[float] = None, diffuse: Any = None, opacity: float = 1, coat: Optional[Number] = None,
    fit: Optional[str] = None, gltf_form: Optional[str] = None, dataset: str = "", axis_average: bool = False, observer: Table = None,
    illuminant: Table = None, interpolation: Optional[str] = None, method: Optional[str] = None,
    integration_bound: Optional[Number] = None, space: Optional[str] = None, ocio: Optional[Path] = None,
    outside: Optional[Number] = None, allow_extrapolation: bool = False, unit: Optional[str] = None,
    columns: Optional[str] = None, duplicates: Optional[str] = None, material_class: Optional[str] = None,
    origin: Optional[str] = None, library: Library = library, threads: int = 0,
) -> Any:
    """Materials as MaterialX, glTF or the values of engines.

      materials   a material as f0() takes it, or a list or tuple of them
      to          "mtlx" or "gltf": a text; "glb": bytes; "values", or the id of one target: what `etak export --to
                  values --format json` writes, as a dictionary
      target      of "values": only these
      gloss, roughness, diffuse, opacity, coat, fit, gltf_form   as options of `etak export`; a colour may be a hex text
      axis_average, material_class, origin                 as of f0()

    What was assumed and changed is in the dictionary; of texts and bytes it is a warning each.

    >>> gold = etak.export("gold", "unreal", roughness=0.3)["materials"][0]
    >>> [field["text"] for field in gold["targets"][0]["fields"] if field["name"] == "Roughness"]
    ['0.3']
    """
    given = locals()
    import warnings

    several = list(materials) if isinstance(materials, (list, tuple)) else [materials]
    document, remarks = _core.export(several, to, given, library, threads)
    for each in remarks:
        warnings.warn(each, stacklevel=2)
    return document


def _curve(materials: Any, form: str, given: Dict[str, Any]) -> bytes:
    import warnings

    several = materials if isinstance(materials, (list, tuple)) else () if materials is None else (materials,)
    out, remarks = _core.curve(list(several), form, given, given["library"])
    for each in remarks:
        warnings.warn(each, stacklevel=3)
    return out


def curve(
    materials: Any = None, *, of: str = "F", model: Any = None, term: Any = None, light: float = 45,
    step: float = 0.5, channel: str = "luminance", set: Any = None, diffuse: Any = None,
    gloss: Optional[float] = None, roughness: Optional[float] = None, dataset: str = "", axis_average: bool = False,
    observer: Table = None, illuminant: Table = None, interpolation: Optional[str] = None,
    method: Optional[str] = None, integration_bound: Optional[Number] = None, outside: Optional[Number] = None,
    allow_extrapolation: bool = False, unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, material_class: Optional[str] = None, origin: Optional[str] = None,
    library: Library = library,
) -> "Dict[str, Any]":
    """Reflectance, terms and lobes as curves: what `etak curve --format json` writes, with the columns as arrays.

      materials   a material as f0() takes it, numbers such as "f0=0.04", or a list or tuple of them
      of          "F", "D", "G", "V", "lobe" or "R"
      model, term, set   one or several, as options of `etak curve`: set=["m=8", "m=100"] are two curves
      light, step        degrees        channel   "luminance", "red", "green", "blue" or "rgb"
      gloss, roughness, diffuse         of the surface; a colour may be a hex text

    What was assumed is a warning each.

    >>> schlick = etak.curve("f0=0.04", term="schlick", step=30)["curves"][0]
    >>> schlick["title"], schlick["x"], schlick["y"].round(4)
    ('f0=0.04, schlick', array([ 0., 30., 60., 90.]), array([0.04, 0.04, 0.07, 1.  ]))
    """
    import json

    import numpy

    out: Dict[str, Any] = json.loads(_curve(materials, "json", locals()))
    del out["schema"]
    for each in out["curves"]:
        each["x"], each["y"] = numpy.array(each["x"], "float64"), numpy.array(each["y"], "float64")
    return out


def plot(
    materials: Any, file: Path, *, of: str = "F", model: Any = None, term: Any = None, light: float = 45,
    step: float = 0.5, channel: str = "luminance", set: Any = None, diffuse: Any = None,
    gloss: Optional[float] = None, roughness: Optional[float] = None, dataset: str = "", axis_average: bool = False,
    observer: Table = None, illuminant: Table = None, interpolation: Optional[str] = None,
    method: Optional[str] = None, integration_bound: Optional[Number] = None, outside: Optional[Number] = None,
    allow_extrapolation: bool = False, unit: Optional[str] = None, columns: Optional[str] = None,
    duplicates: Optional[str] = None, material_class: Optional[str] = None, origin: Optional[str] = None,
    library: Library = library,
    scale: str = "linear", straight: bool = False, dark: bool = False, force: bool = False,
) -> None:
    """Writes the curves of curve() as a plot: .svg or .png. PNG needs the font DejaVu Sans.

      scale      of the radius of lobes: "linear" or "log"
      straight   lobes over a straight axis instead of around the normal
      dark       on a dark background        force   replace the file

    >>> etak.plot(["gold", "copper"], "metals.svg")
    """
    name = _os.fsdecode(file)
    form = _os.path.splitext(name)[1][1:].lower()
    if form not in ("svg", "png"):
        raise Error(f"file: {name}; expected an ending .svg or .png")
    _core.write_file(name, _curve(materials, form, locals()), force)


def eval(function: str, **inputs: Any) -> Any:
    """One of the formulas of `etak eval`, in double precision: a number, or an array where inputs are arrays.

      inputs   numbers, arrays that are broadcast, or words, by the names that functions() tells

    >>> round(etak.eval("schlick", f0=0.04, cos=0.5), 6)
    0.07
    """
    import numpy

    words = {name: value for name, value in inputs.items() if isinstance(value, str)}
    names = [name for name in inputs if name not in words]
    arrays = numpy.broadcast_arrays(*(inputs[name] for name in names)) if names else []
    out = _core.evaluated(function, words, dict(zip(names, arrays)))
    return out if out.ndim else float(out)


def functions() -> "list[Dict[str, Any]]":
    """The formulas of eval(), each with its inputs, their units and ranges, and its source.

    >>> [each["id"] for each in etak.functions()][:2]
    ['f0', 'absorptance0']
    """
    return _core.functions()


def sources() -> "list[Dict[str, Any]]":
    """The printed rows of Schueler, Hoffman and TU Graz, each with etak's value and the reason of a difference: what
    `etak sources --format json` lists.

    >>> [each["etak"] for each in etak.sources() if each["row"] == "Chromium"]
    [[0.549619991, 0.556021829, 0.554227039]]
    """
    return _core.sources()

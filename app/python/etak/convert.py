# SPDX-License-Identifier: Apache-2.0
"""Spectra from and to other packages: colour-science (`colour`) and Mitsuba 3 (`mitsuba`).

A package is imported by the functions that need it. Those of Mitsuba take and give dictionaries, which
mitsuba.load_dict() takes, and import nothing.
"""

from __future__ import annotations

from typing import Any, Dict, Optional

from . import Dataset, Error, dataset as _dataset, read as _read

__all__ = ["from_colour", "from_mitsuba", "to_colour", "to_mitsuba"]


def to_colour(material: Any, quantity: str = "n", **names: Any) -> Any:
    """A colour.SpectralDistribution of n, k or reflectance.

      material   as etak.f0() takes it; a formula is sampled at every nanometre of its range within 360 to 830 nm
      quantity   "n", "k" or "reflectance"
      names      for the distribution: name=...
    """
    from colour import SpectralDistribution  # type: ignore[import]

    of = _as_dataset(material)
    if quantity not in ("n", "k", "reflectance"):
        raise Error(f"quantity: {quantity}; expected n, k or reflectance")
    at = _wavelengths(of)
    first, last = (of.k_range or of.range) if quantity == "k" else of.range
    at = [w for w in at if first <= w <= last]
    values = getattr(of, quantity)(at)
    return SpectralDistribution(dict(zip(at, values)), name=names.pop("name", f"{of.label} {quantity}"), **names)


def from_colour(n: Any = None, k: Any = None, *, reflectance: Any = None, name: Optional[str] = None) -> Dataset:
    """A dataset of distributions of colour-science, which etak.f0() and etak.fresnel() take.

      n, k, reflectance   colour.SpectralDistribution; k has the wavelengths of n
    """
    first = n if n is not None else reflectance
    if first is None:
        raise Error("n: is not given; expected either n and k or reflectance")
    if k is not None and list(k.wavelengths) != list(first.wavelengths):
        raise Error("k: has other wavelengths than n; expected the same, such as those of k.align(n.shape)")
    values = {"n": n, "k": k, "reflectance": reflectance}
    return _dataset(
        first.wavelengths, name=name or str(first.name) or "given",
        **{key: sd.values for key, sd in values.items() if sd is not None})


def to_mitsuba(material: Any, *, roughness: Optional[float] = None) -> Dict[str, Any]:
    """A BSDF of Mitsuba 3, as a dictionary: a conductor of n and k, or a dielectric of n.

      material    as etak.f0() takes it; its data need n. Conductors and semiconductors are conductors, and so is what
                  has no class and gives k; the rest are dielectrics, with n at the sodium line, 589.3 nm
      roughness   perceptual, alpha = roughness^2 of a GGX lobe; without it the surface is smooth

    >>> from etak import convert
    >>> convert.to_mitsuba("gold", roughness=0.3)["alpha"]
    0.09
    >>> convert.to_mitsuba("water")["type"]
    'dielectric'
    """
    of = _as_dataset(material)
    rough = roughness is not None
    kind = of.material.optical_kind or ("conductor" if of.has_k else "dielectric")
    if kind in ("conductor", "semiconductor"):
        first, last = of.k_range or of.range
        at = [w for w in _wavelengths(of) if first <= w <= last]
        out: Dict[str, Any] = {
            "type": "roughconductor" if rough else "conductor", "eta": _spectrum(at, of.n(at)),
            "k": _spectrum(at, of.k(at))}
    else:
        out = {"type": "roughdielectric" if rough else "dielectric", "int_ior": float(of.n(589.3)), "ext_ior": 1.0}
    if rough:
        out["alpha"] = round(roughness * roughness, 12)  # type: ignore[operator]
        out["distribution"] = "ggx"
    return out


def from_mitsuba(bsdf: Dict[str, Any], *, name: str = "given") -> Dataset:
    """The dataset of a conductor of Mitsuba 3, given as a dictionary with spectra `eta` and `k`.

    >>> from etak import convert
    >>> gold = convert.from_mitsuba(convert.to_mitsuba("gold"), name="gold again")
    >>> etak.f0(gold).hex == etak.f0("gold").hex
    True
    """
    spectra = {}
    for key in ("eta", "k"):
        value = bsdf.get(key)
        pairs = value.get("value") if isinstance(value, dict) else None
        if not isinstance(pairs, (list, tuple)):
            raise Error(f"{key}: is no spectrum; expected a dictionary of type spectrum with (wavelength, value) pairs")
        spectra[key] = [(float(w), float(v)) for w, v in pairs]
    wavelength = [w for w, _ in spectra["eta"]]
    if wavelength != [w for w, _ in spectra["k"]]:
        raise Error("k: has other wavelengths than eta; expected the same")
    return _dataset(
        wavelength, n=[v for _, v in spectra["eta"]], k=[v for _, v in spectra["k"]], name=name)


def _as_dataset(material: Any) -> Dataset:
    return material if isinstance(material, Dataset) else _read(material)


def _wavelengths(of: Dataset) -> "list[float]":
    if of.wavelength is not None:
        return [float(w) for w in of.wavelength]
    first, last = of.range
    return [float(w) for w in range(360, 831) if first <= w <= last]


def _spectrum(at: "list[float]", values: Any) -> Dict[str, Any]:
    return {"type": "spectrum", "value": [(w, float(v)) for w, v in zip(at, values)]}

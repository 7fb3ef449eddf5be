# SPDX-License-Identifier: Apache-2.0
"""What validate(), pack() and choose() found: dataclasses over the JSON that the program writes. Each attribute names the
member of the JSON that it shows, and what it means. `import etak` has the types under its own name."""

from __future__ import annotations

import dataclasses as _dataclasses
import json as _json
import os as _os
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Optional, Tuple, Type, TypeVar, final

from . import _core

__all__ = ["CheckedFile", "Choice", "Choices", "Finding", "Packed", "Report", "Value"]

_Kind = TypeVar("_Kind", bound="Value")
_FORMS = ("text", "json", "sarif", "junit", "github", "csv")


def _same(value: Any) -> Any:
    return value


def _text(value: Any) -> str:
    # A text that is no UTF-8, such as the name of a file, is an array of its bytes.
    return value if isinstance(value, str) else _os.fsdecode(bytes(value))


def _texts(values: Any) -> List[str]:
    return list(map(_text, values))


def _form(forms: Any, name: str) -> str:
    return str(forms(name) if callable(forms) else forms[name])


def _said(member: str, meaning: str, form: Optional[Callable[[Any], Any]] = None) -> Any:
    """An attribute.

      member   of the JSON; empty: all of it
      form     makes the attribute's value of the member's; None: it is the same
    """
    return _dataclasses.field(metadata={"member": member, "meaning": meaning, "form": form})


class Value(SimpleNamespace):
    """A value that nothing changes: only functions of etak make it, and equal ones say the same."""

    _attributes: Dict[str, Tuple[str, Callable[[Any], Any]]] = {}

    def __new__(cls, *_: Any, **__: Any) -> Value:
        raise TypeError(f"etak.{cls.__name__}: only the functions of etak make it")

    def __init_subclass__(cls) -> None:
        if cls.__mro__[1] is not Value:
            raise TypeError(f"type 'etak.{cls.__mro__[1].__name__}' is not an acceptable base type")
        cls.__module__ = "etak"
        _dataclasses.dataclass(init=False, repr=False, eq=False)(cls)  # frozen, each takes 2 ms of `import etak`
        for each in _dataclasses.fields(cls):
            usual = _text if each.type == "str" else _same
            cls._attributes = {
                **cls._attributes, each.name: (each.metadata["member"], each.metadata["form"] or usual)}
            if not each.name.startswith("_"):
                cls.__doc__ = f"{cls.__doc__}\n  {each.name:<15}{each.metadata['meaning']}"

    @classmethod
    def _restore(cls: Type[_Kind], said: Any) -> _Kind:
        """The value that an object of JSON describes."""
        if not isinstance(said, dict):
            raise _core.Error("pickle: of another form; expected that of a pickle of this type")
        out = SimpleNamespace.__new__(cls)
        out.__dict__["_said"] = said
        return out

    if not TYPE_CHECKING:  # to which a misspelt attribute is a mistake

        def __getattr__(self, name: str) -> Any:
            """An attribute, made when it is asked for, because reports are large."""
            if name not in self._attributes:
                raise AttributeError(f"etak.{type(self).__name__} has no attribute {name}")
            member, form = self._attributes[name]
            said = self.__dict__["_said"]
            return form(said.get(member) if member else said)

    def _state(self) -> Any:
        """What a pickle holds."""
        return self.__dict__["_said"]

    def _key(self) -> Any:
        """What makes a difference to another value."""
        return self.__dict__["_said"]

    def __reduce__(self) -> Any:
        from . import _restored

        return _restored, (type(self), _core.__version__, (self._state(),))

    def __deepcopy__(self, _: Any = None) -> Value:
        return self

    __copy__ = __deepcopy__

    def __setattr__(self, name: str, *_: Any) -> None:
        raise AttributeError(f"etak.{type(self).__name__}: nothing changes its {name}")

    __delattr__ = __setattr__

    def __eq__(self, other: object) -> bool:
        return self is other or (type(self) is type(other) and bool(self._key() == other._key()))  # type: ignore

    def __hash__(self) -> int:  # type: ignore[override]  # a SimpleNamespace can be changed
        return hash(repr(self._key()))


@final
class Finding(Value):
    """A defect that a rule has found."""

    rule: str = _said("id", '"ETK101".')
    slug: str = _said("slug", '"f0-forbidden-zone".')
    severity: str = _said("severity", '"info", "warning" or "error".')
    path: str = _said("file", "The file, as the caller named it.")
    place: str = _said("place", "File, tile and box, or the JSON pointer, as one text.")
    tile: str = _said("tile", "Of an atlas; else empty.")
    material: str = _said("material", "Where it is named.")
    pointer: str = _said("pointer", "JSON pointer, for materials and scenes.")
    box: Optional[Tuple[int, int, int, int]] = _said(
        "bbox", "(x, y, width, height) in texels, or None.", lambda box: box and tuple(box))
    uv: Optional[List[float]] = _said("uv", "[left, top, right, bottom], or None.", lambda uv: uv and list(uv))
    area: int = _said("areaPx", "In texels.")
    area_share: float = _said("areaShare", "Of the tile.", float)
    linear: Optional[List[float]] = _said(
        "value", "The linear colour that was found, or None.",
        lambda found: found and found["linear"] and list(map(float, found["linear"])))  # infinity and NaN are words
    byte: Optional[List[int]] = _said(
        "value", "Its codes, or None.", lambda found: found and found["byte"] and list(found["byte"]))
    luminance: Optional[float] = _said(
        "value", "Of it, or None.", lambda found: None if not found or found["Y"] is None else float(found["Y"]))
    value: str = _said("found", 'What was found: "F0 0.22".')
    limit: str = _said("limit", 'What it is held against: "20-45 %".')
    nearest: List[Tuple[str, str, float]] = _said(
        "nearest", "Materials that come near: (id, dataset, distance in codes).",
        lambda rows: [(each["name"], each["dataset"], float(each["bytes"])) for each in rows])
    message: str = _said("message", "One sentence: value, place, area.")
    cause: str = _said("cause", "A possible cause; empty: not known.")
    advice: str = _said("fix", "What mends it.")
    source: str = _said("source", "Of the rule.")
    suppressed: bool = _said("suppressed", "By an [[allow]] entry of etak.toml.")
    suppression: str = _said("suppression", "The reason that it gives.")
    known: bool = _said("baseline", "From the baseline.")
    _sentence: str = _said("sentence", "Message and cause on one line.")

    @property
    def explanation(self) -> str:
        """What the rule is about, at length."""
        return _core.explanation(self.rule)

    @property
    def counts(self) -> bool:
        """Neither suppressed nor known."""
        return not (self.suppressed or self.known)

    def __str__(self) -> str:
        return f"{self.severity} {self.rule} {self.place}: {self._sentence}"

    def __repr__(self) -> str:
        return _core.repr_line("Finding", str(self))


@final
class CheckedFile(Value):
    """A checked file, or a pair or set of files that belong together."""

    path: str = _said("path", "As the caller named it.")
    companions: List[str] = _said("companions", "Other files of the set.", _texts)
    size: Tuple[int, int] = _said(
        "", "In texels; (0, 0) for what is no picture.", lambda file: (file["width"], file["height"]))
    surfaces: List[Tuple[str, str, Optional[Tuple[str, float]]]] = _said(
        "surfaces", "Of a material document: (name, model, (id, dE2000) of the nearest measured material or None).",
        lambda rows: [(each["name"], each["model"], each["nearest"] and (
            each["nearest"]["id"], float(each["nearest"]["delta_e"]))) for each in rows or []])
    roles: Dict[str, str] = _said(
        "roles", "What each file was taken for.", lambda rows: {_text(each["file"]): each["role"] for each in rows})
    counts: Dict[str, int] = _said("stats", "Exact counts of texels.", lambda stats: dict(stats["counts"]))
    readable: bool = _said("unreadable", "Whether it could be read.", lambda unreadable: not unreadable)
    findings: List[Finding] = _said("findings", "In the order of rules.", lambda rows: list(map(Finding._restore, rows)))

    def __repr__(self) -> str:
        return _core.repr_line("CheckedFile", self.path)


@final
class Report(Value):
    """What the validator found: a sequence of findings, which are read when first asked for."""

    passed: bool = _said("passed", "Nothing at or above fail_on, and all was checked.")
    incomplete: bool = _said("incomplete", "Something could not be checked.")
    errors: int = _said("errors", "Their number.")
    warnings: int = _said("warnings", "Their number.")
    infos: int = _said("infos", "Their number.")
    profile: str = _said("profile", "That was used.")
    transfer: str = _said("transfer", "The curve of the codes.")
    unknown: List[str] = _said("notRecognised", "Pictures whose names tell no role.", _texts)
    verdict: str = _said("verdict", "One line.")
    _forms: Any = _said("forms", "A function that writes the report in a form, or the forms by their names.")

    @property
    def files(self) -> List[CheckedFile]:
        """What was checked."""
        return list(self._read("_files"))

    @property
    def findings(self) -> List[Finding]:
        """All of them, in the order of files."""
        return list(self._read("_findings"))

    def _read(self, what: str) -> List[Any]:
        if what not in self.__dict__:
            files = list(map(CheckedFile._restore, _json.loads(_form(self._forms, "files"))))
            self.__dict__.update(_files=files, _findings=[each for file in files for each in file.findings])
        read: List[Any] = self.__dict__[what]
        return read

    def form(self, format: str) -> str:
        """As text, json, sarif, junit, github or csv."""
        if format not in _FORMS:
            raise _core.Error(f"format: {format}; expected text, json, sarif, junit, github or csv")
        return _form(self._forms, format)

    def _state(self) -> Dict[str, Any]:
        return {**super()._state(), "forms": {name: _form(self._forms, name) for name in (*_FORMS, "files")}}

    def _key(self) -> Any:
        return {**super()._key(), "forms": _form(self._forms, "files")}

    def __len__(self) -> int:
        return len(self._read("_findings"))

    def __iter__(self) -> Iterator[Finding]:
        return iter(self._read("_findings"))

    def __getitem__(self, index: int) -> Finding:
        return self._read("_findings")[index]  # type: ignore[no-any-return]

    def __str__(self) -> str:
        return self.form("text").rstrip("\n")

    def __repr__(self) -> str:
        return _core.repr_line("Report", self.verdict)


@final
class Packed(Value):
    """What pack() did."""

    input: str = _said("input", "As the caller named it.")
    output: str = _said("output", "The folder.")
    files: List[str] = _said("files", "That were written, in the folder.", list)
    remarks: List[str] = _said("remarks", "What should be known of the result.", list)
    up_to_date: bool = _said("up_to_date", "It was in place already.")
    dry_run: bool = _said("dry_run", "Nothing was written.")
    materials: int = _said("materials", "Their number.")
    regions: int = _said("regions", "Their number.")
    report: Optional[Report] = _said("report", "What the validator found on the pages; None: they were not checked.")
    _layout: str = _said("layout", "As a text.")
    _json: str = _said("json", "The report of the packer.")
    _text: str = _said("text", "The same for people.")

    @property
    def layout(self) -> Dict[str, Any]:
        """What layout.json holds."""
        return dict(_json.loads(self._layout))

    @property
    def pages(self) -> List[Tuple[int, int]]:
        """(width, height) of each."""
        return [(each["width"], each["height"]) for each in self.layout["pages"]]

    def json(self) -> str:
        """The report of the packer."""
        return self._json

    def __str__(self) -> str:
        return self._text.rstrip("\n")

    def __repr__(self) -> str:
        return _core.repr_line("Packed", f"{self.output}: {self.materials} materials, {len(self.pages)} pages")


@final
class Choice(Value):
    """The cheapest way to draw a material within a budget of error."""

    material: str = _said("material", "Its name.")
    library: str = _said("library", '"gold/ID" where its spectrum is known; else empty.')
    met: bool = _said("met", "False: nothing stays within the budget, and the closest was taken.")
    fresnel: str = _said("fresnel", "The form of Fresnel reflectance.")
    visibility: str = _said("visibility", "The term of visibility.")
    method: str = _said("integration", "Integration of F0; empty: there is no spectrum.")
    filter: str = _said("filter", "Of the texture.")
    model: str = _said("model", "As etak render and etak shader take it.")
    model_values: List[float] = _said("values", "Its parameters.", lambda values: list(map(float, values)))
    alpha: float = _said("roughness", "Width of the lobe.", lambda roughness: max(1e-4, float(roughness)**2))
    textured: bool = _said("textured", "Whether it has a texture of more than one colour.")
    defines: List[str] = _said("defines", "Of the specialised shader.", list)
    error: float = _said(
        "", "The largest of all choices together, in the unit of the budget.",
        lambda said: float(max(said["fresnel_error"], said["picture_error"], said["integration_error"])))
    unit: str = _said("unit", 'Of errors: "ΔE2000" or "codes".')
    fresnel_error: float = _said("fresnel_error", "The largest over all angles.", float)
    picture_error: float = _said("picture_error", "Of the worst pixel.", float)
    everything_ns: float = _said("everything_ns", "Cost of one evaluation with everything.", float)
    chosen_ns: float = _said("chosen_ns", "Cost of one evaluation as chosen.", float)

    def __repr__(self) -> str:
        return _core.repr_line("Choice", f"{self.material}: {self.model}")


@final
class Choices(Value):
    """What choose() found: a sequence, one for each material."""

    remarks: List[str] = _said("remarks", "What should be known of it.", list)
    scene: str = _said("scene", "Empty: materials of the library.")
    _choices: List[Choice] = _said("choices", "They themselves.", lambda rows: list(map(Choice._restore, rows)))
    _json: str = _said("json", "They as a document.")
    _text: str = _said("text", "The same for people.")

    def json(self) -> str:
        """What pack(choice=...) and etak shader --choice take, as a file."""
        return self._json

    def __len__(self) -> int:
        return len(self._choices)

    def __iter__(self) -> Iterator[Choice]:
        return iter(self._choices)

    def __getitem__(self, index: int) -> Choice:
        return self._choices[index]

    def __str__(self) -> str:
        return self._text.rstrip("\n")

    def __repr__(self) -> str:
        return f"<etak.Choices of {len(self)}>"


def report_of(forms: Callable[[str], str], fail_on: Optional[str]) -> Report:
    """The report that a function of _core writes in any form. Findings fail nothing where `fail_on` is "never"."""
    head = _json.loads(forms("head"))
    said = {**head["settings"], **head["summary"], **head, "verdict": forms("verdict"), "forms": forms}
    said["passed"] = not said["incomplete"] and (said["passed"] or fail_on == "never")
    return Report._restore(said)


def packed_of(told: Dict[str, Any], fail_on: Optional[str]) -> Packed:
    """What _core.pack() told."""
    report = report_of(told["forms"], fail_on) if "forms" in told else None
    return Packed._restore({**_json.loads(told["json"]), **told, "forms": None, "report": report})


def choices_of(told: Dict[str, Any]) -> Choices:
    """What _core.choose() told."""
    document = _json.loads(told["json"])
    rows = zip(document["choices"], told["materials"])
    choices = [{**each, "material": name, "unit": document["unit"]} for each, name in rows]
    return Choices._restore({**told, "choices": choices})

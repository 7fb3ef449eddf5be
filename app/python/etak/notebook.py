# SPDX-License-Identifier: Apache-2.0
"""What materials, datasets and citations show in a notebook: plots by matplotlib, which the first plot imports, HTML, and
BibTeX. `import etak` makes them methods of the types."""

from __future__ import annotations

import re as _re
from typing import Any

from ._core import Citation, Dataset, Error, Library, Material, f0 as _f0, library as _library

__all__ = ["bibtex", "dataset_html", "library_html", "material_html", "plot_dataset", "plot_material"]


def bibtex(self: Citation, key: str = "") -> str:
    """The entry of a BibTeX file.

      key   of the entry; without it the first author's last name, the year and the first word of the title

    >>> print(etak.library["gold"].preferred.citation.bibtex().splitlines()[0])
    @article{olmon2012optical,
    """
    def tex(text: str) -> str:
        slash = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
        return _re.sub(r"[\\~^&%$#_{}]", lambda m: slash.get(m[0], "\\" + m[0]), text)

    c = self
    if not key:
        first = c.authors[0].split()[-1] if c.authors and c.authors[0].split() else "anonymous"
        words = [each for each in c.title.split() if len(each) > 3]
        key = _re.sub("[^a-z0-9]", "", f"{first}{c.year or ''}{words[0] if words else ''}".lower())
    fields = {
        "author": " and ".join(map(tex, c.authors)), "title": "{" + tex(c.title) + "}" if c.title else "",
        "journal" if c.doi else "howpublished": tex(c.published_in), "year": str(c.year or ""), "doi": c.doi, "url": c.url,
        "note": tex(", ".join(filter(None, [c.via, c.licence])))}
    rows = [f"  {name} = {{{value}}}" for name, value in fields.items() if value]
    return f"@{'article' if c.doi else 'misc'}{{{key},\n" + ",\n".join(rows) + "\n}\n"


def plot_dataset(self: Dataset, axis: Any = None, **style: Any) -> Any:
    """Draws n and k, or the reflectance, over the wavelength, 300 to 1000 nm where there are data. Returns the axes.

      axis    axes of matplotlib; without it those that pyplot has now
      style   for the lines, as Axes.plot() takes it
    """
    quantities = ["n"] * self.has_n + ["k"] * self.has_k or ["reflectance"]
    axis = _axes(axis)
    for each in quantities:
        first, last = (self.k_range or self.range) if each == "k" else self.range
        at = _grid(first, last)
        line = {"label": each if len(quantities) > 1 else self.label, **style}
        axis.plot(at, getattr(self, each)(at), **line)
    axis.set(xlabel="wavelength, nm", ylabel=" and ".join(quantities), title=self.label)
    axis.legend()
    return axis


def plot_material(self: Material, axis: Any = None, **style: Any) -> Any:
    """Draws the reflectance at normal incidence of every dataset, in the colour that it gives. Returns the axes.

      axis    axes of matplotlib; without it those that pyplot has now
      style   for the lines, as Axes.plot() takes it
    """
    axis = _axes(axis)
    for each in self:
        at = _grid(*each.range)
        if each.has_n:
            n, k = each.n(at), each.k(at, extrapolate=True) if each.has_k else 0
            values = ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)
        else:
            values = each.reflectance(at)
        color = {} if _hex(each) is None else {"color": _hex(each)}
        axis.plot(at, values, **{"label": each.id, **color, **style})
    axis.set(xlabel="wavelength, nm", ylabel="reflectance", title=self.name)
    axis.legend(fontsize="x-small")
    return axis


def dataset_html(self: Dataset) -> str:
    """A row with the colour of F0, for notebooks."""
    return _table(["", "dataset", "data", "nm", "source"], [_row(self, self.label)])


def material_html(self: Material) -> str:
    """A table of the datasets with their colours, for notebooks."""
    head = f"<b>{_escape(self.name)}</b> {_escape(self.material_class)}"
    return head + _table(["", "dataset", "data", "nm", "source"], [_row(each, each.id) for each in self])


def library_html(self: Library) -> str:
    """A table of the first 300 materials with their colours, for notebooks."""
    ids = self.keys()
    rows = []
    for each in map(self.__getitem__, ids[:300]):
        rows.append([_swatch(_hex(each)), each.id, _escape(each.name), each.material_class, str(len(each))])
    return f"{len(ids)} materials" + _table(["", "id", "name", "class", "datasets"], rows)


def _escape(text: str) -> str:
    import html  # seldom needed, and slow to import

    return html.escape(text)


def _axes(axis: Any) -> Any:
    if axis is not None:
        return axis
    import matplotlib.pyplot  # type: ignore[import]

    return matplotlib.pyplot.gca()


def _grid(first: float, last: float) -> Any:
    import numpy

    low, high = max(first, 300.0), min(last, 1000.0)
    return numpy.linspace(low, high, 701) if low < high else numpy.linspace(first, last, 701)


def _hex(material: Any) -> Any:
    try:
        return _f0([material], "", False, {}, _library, 1)[0].hex
    except Error:
        return None


def _row(dataset: Dataset, name: str) -> "list[str]":
    first, last = dataset.range
    return [_swatch(_hex(dataset)), _escape(name), _escape(f"{dataset.kind} {dataset.sample}"),
            f"{first:g}&ndash;{last:g}", _escape(str(dataset.citation))]


def _swatch(color: Any) -> str:
    fill = f";background:{color}" if color else ""
    return f'<div title="{color or "no F0"}" style="width:2em;height:1em{fill}"></div>'


def _table(head: "list[str]", rows: "list[list[str]]") -> str:
    def line(cells: "list[str]", tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" for cell in cells) + "</tr>"

    return "<table>" + line(head, "th") + "".join(line(each, "td") for each in rows) + "</table>"

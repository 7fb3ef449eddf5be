# SPDX-License-Identifier: Apache-2.0
"""Writes _core.pyi, the types of the compiled part of etak, from the signatures that pybind11 gives its functions.

  python3 stubs.py FOLDER FILE    FOLDER holds the package etak
"""
import inspect
import re
import sys
import types
from pathlib import Path

HEAD = """# SPDX-License-Identifier: Apache-2.0
# The types of the compiled part of etak, written by app/python/stubs.py. etak/__init__.py documents what users call.
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple, Union, final

import numpy as np
import numpy.typing as npt

__version__: str
library: Library

class Error(ValueError): ...
"""
# The name that pybind11 gives a type leads to the name that stands in a stub.
NAMES = ((r"\betak\._core\.", ""), (r"numpy\.ndarray\[numpy\.float64\]", "npt.NDArray[np.float64]"), (r"\bobject\b", "Any"),
         (r"\bdict\b", "Dict[str, Any]"), (r"\blist\b", "List[Any]"), (r"\btuple\b", "Tuple[Any, ...]"),
         (r"-> function", "-> Callable[..., Any]"), (r"= [^,)]*", "= ..."), (r"\*args\b", "*args: Any"))
SPECIAL = ("__init__", "__len__", "__iter__", "__contains__", "__getitem__", "_repr_html_")


def signature(function, first=r"arg0: \w+"):
    """"(self, wavelength: Any) -> Any".

      first   what stands for self
    """
    if isinstance(function, types.FunctionType):  # of notebook.py
        text = str(inspect.signature(function)).replace("'", "")
    else:
        text = re.search(r"\(.*\) -> .*", function.__doc__)[0]
    for pattern, name in NAMES:
        text = re.sub(pattern, name, text)
    if re.search(r"etak::|std::|handle", text):
        raise SystemExit(f"stubs.py: {function}: {text}: a type that Python does not know")
    return re.sub(rf"^\((?:{first}|self: \w+)", "(self", text)


def members(kind):
    for name, value in vars(kind).items():
        if isinstance(value, property):
            yield f"    @property\n    def {name}{signature(value.fget)}: ..."
        elif callable(value) and not isinstance(value, types.WrapperDescriptorType) and (
                name in SPECIAL or not name.startswith("_")):
            yield f"    def {name}{signature(value)}: ..."


def main(folder, file):
    sys.path.insert(0, folder)
    sys.dont_write_bytecode = True
    from etak import _core

    out = [HEAD]
    for name, value in vars(_core).items():
        if inspect.isclass(value) and value is not _core.Error:
            out.append("\n".join(["@final", f"class {name}:", *members(value), ""]))
    for name, value in vars(_core).items():
        if isinstance(value, types.BuiltinFunctionType):
            out.append(f"def {name}{signature(value, 'self')}: ...")
    Path(file).write_text("\n".join(out) + "\n")


main(*sys.argv[1:])

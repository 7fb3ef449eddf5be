#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""pages.py FILE: prints a page of this folder as doxygen reads it, for ./dev docs.

The pages are written for readers of plain Markdown. For doxygen,
  - headings have the names by which links lead to them: `films.md#coats` becomes `films--coats`,
  - code with an apostrophe has two backticks,
  - <etak-material> elements are passed through as they are.
"""
import pathlib
import re
import sys


def label(page, heading):
    return f"{page}--" + re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")


def paged(path):
    page, out, fenced = path.stem if path.parent.name != "verbs" else f"verbs-{path.stem}", [], False
    for line in path.read_text(encoding="utf-8").split("\n"):
        fenced ^= line.startswith("```")
        if not fenced and not line.startswith("    "):
            if heading := re.match(r"##+ (.+)", line):
                line += f" {{#{label(page, heading[1])}}}"
            line = re.sub(r"\]\((?:\.\./)?([\w/]*?)(?:\.md)?#([\w-]+)\)", lambda to: f"](@ref {to[1] or page}--{to[2]})", line)
            line = re.sub(r"`([^`]*)`", lambda code: f"`{code[0]}`" if "'" in code[1] else code[0], line)
            line = re.sub(r"</?etak-material.*?>", r"@htmlonly\g<0>@endhtmlonly", line)
        out.append(line)
    return "\n".join(out)


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    print(paged(pathlib.Path(sys.argv[1])), end="")

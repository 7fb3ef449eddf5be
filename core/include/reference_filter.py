#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""reference_filter.py SOURCE TARGET HEADER...: copies the headers, which are paths below SOURCE, to the same paths below
TARGET, with their comments in the form that doxygen reads.

The headers are written to be read as they are. For the reference,
  - the manual at the top of a header for users becomes the text of its page,
  - comments before a declaration and behind a member belong to it, with two slashes as with three,
  - rows such as "  wavelength   nanometres in vacuum" become a table,
  - signs that doxygen would take as commands or tags are escaped.
"""
import pathlib
import re
import sys

ROW = re.compile(r"^ {2,}(\S+(?: \S+)*) {2,}(\S.*)$")
MORE_OF_ROW = re.compile(r"^ {6,}(\S.*)$")
COMMENT = re.compile(r"^\s*//(/?)(<?)( ?)(.*)$")
BEHIND = re.compile(r"^(.*\S)  +// (.*)$")
STRING = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'')
SCOPE = re.compile(r"\b(?:namespace|struct|class|union|enum|extern)\b[^()]*$")


def escape(text):
    """Text for doxygen; what stands between backticks is left as it is."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        part = parts[i].replace("\\", "\\\\").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        parts[i] = re.sub(r"([@#*~|])", r"\\\1", part)
    return "".join(parts)


def documented(lines):
    """The lines of one comment, without slashes, as lines for doxygen."""
    out, rows = [], []

    def end_rows():
        if rows:
            out.append("<table>" + "".join(f"<tr><td>{name}</td><td>{text}</td></tr>" for name, text in rows) + "</table>")
            rows.clear()

    fenced = False
    for i, line in enumerate(lines):
        if line.strip().startswith("```"):
            fenced = not fenced
            end_rows()
            out.append(line.strip())
        elif fenced:
            out.append(line)
        elif match := ROW.match(line):
            rows.append([escape(match[1]), escape(match[2])])
        elif rows and (match := MORE_OF_ROW.match(line)):
            rows[-1][1] += " " + escape(match[1])
        else:
            end_rows()
            heading = i + 1 < len(lines) and ROW.match(lines[i + 1]) and i > 0 and not lines[i - 1].strip()
            out.append(f"<b>{escape(line.strip())}</b>" if heading else escape(line.strip()))
    end_rows()
    return out


class Scopes:
    """Tells whether a line stands in the body of a function, where comments are no documentation."""

    def __init__(self):
        self.stack, self.statement = [], ""

    def in_body(self):
        return "body" in self.stack

    def read(self, code):
        if code.lstrip().startswith("#"):
            return
        for sign in STRING.sub('""', code):
            if sign == "{":
                self.stack.append("scope" if SCOPE.search(self.statement) else "body")
                self.statement = ""
            elif sign == "}":
                self.stack.pop()
                self.statement = ""
            elif sign == ";":
                self.statement = ""
            else:
                self.statement += sign
        self.statement += " "


def filtered(source):
    lines = source.split("\n")
    out, scopes, i = [], Scopes(), 0
    manual_possible = True  # the manual of a header stands before its first include
    while i < len(lines):
        line = lines[i]
        comment = COMMENT.match(line)
        if comment and not scopes.in_body() and "SPDX" not in line:
            block = []
            while i < len(lines) and (more := COMMENT.match(lines[i])):
                block.append((more[3] + more[4])[1:] if more[3] else more[4])
                i += 1
            behind = i < len(lines) and not lines[i].strip()  # an empty line: the comment is of no declaration
            if manual_possible and not comment[1]:
                out += ["/// @file"] + ["/// " + text for text in documented(block)]
            elif behind and not comment[1]:
                out += ["// " + text for text in block]
            else:
                out += ["/// " + text for text in documented(block)]
            manual_possible = False
            continue
        i += 1
        behind = BEHIND.match(line)
        code = behind[1] if behind else line
        if comment:
            out.append(line)
            continue
        if line.startswith("#include") or line.startswith("namespace"):
            manual_possible = False
        of_member = not scopes.in_body()
        scopes.read(code)
        if behind and of_member and not scopes.in_body() and not code.lstrip().startswith(("#", "}", "namespace")):
            text, column = [behind[2]], behind.start(2) - 3
            while i < len(lines) and lines[i].startswith(" " * column + "// "):
                text.append(lines[i].strip()[3:])
                i += 1
            out.append(f"{code}  ///< {escape(' '.join(text))}")
        else:
            out.append(code if behind else line)
    return "\n".join(out)


if __name__ == "__main__":
    source, target = map(pathlib.Path, sys.argv[1:3])
    for header in sys.argv[3:]:
        (target / header).parent.mkdir(parents=True, exist_ok=True)
        (target / header).write_text(filtered((source / header).read_text(encoding="utf-8")), encoding="utf-8")

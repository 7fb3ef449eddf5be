# SPDX-License-Identifier: Apache-2.0
"""Sends hostile names through every verb and every form of output: names.py materials | files | options | pictures.

Each name holds characters that a terminal, the log of a build, a spreadsheet or a browser would interpret.
The names are used as file names, material names, JSON keys, ids of datasets and values of options. The output
of etak must show them in a harmless form; JSON must hold them unchanged.
"""
import csv
import io
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import xml.dom.minidom
import zlib

SCRIPT = "<script>alert(1)</script>"
TAIL = ("\x1b]0;t\x07\x1b[31m\x9b1m\x85\u202e\u2066\u2028\x7f\n::error file=x::y\r\n  ##[error]z\t" + SCRIPT +
        "\"'`|%0A*/ --> \\")
# Each name begins with characters that a cell or a line must not begin with.
NAMES = ["=1+1" + TAIL, "::error file=x::" + TAIL, "@a, b" + TAIL, "\t+c;d" + TAIL]
FILES = [name.replace("/", "") for name in NAMES]
ASKED = ["\x1b[31m\n::error file=x::y", "::error::\u202e", "##[error]\x9bx"]

ACTIVE = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]")
failures = []
commands = 0


def complain(what, args, found):
    failures.append("%s: etak %s\n    %s" % (what, " ".join(ascii(a) for a in args), ascii(found)[:300]))


def check_text(args, stream, text):
    """Finds control characters, and lines or words that a build service takes for a command."""
    for found in ACTIVE.findall(text):
        complain(stream + " holds U+%04X" % ord(found), args, text)
        break
    for line in text.split("\n"):
        own = args[0] == "validate" and "github" in args and re.match(
            r"::(error|warning|notice) file=[^:,]*,title=ETK\d+ [a-z0-9-]+::", line)
        if line.lstrip().startswith("::") and not own:
            complain(stream + " has a line that is a command", args, line)
        if "##[" in line:
            complain(stream + " has a command in a line", args, line)


def check_csv(args, text):
    rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    for row in rows:
        if len(row) != len(rows[0]):
            complain("CSV row of %d cells, not %d" % (len(row), len(rows[0])), args, row)
        for cell in row:
            try:
                float(cell)
            except ValueError:
                if len(cell) > 1 and cell[0] in "=+-@\t\r":
                    complain("CSV cell is a formula", args, cell)


def strings(value):
    if isinstance(value, dict):
        for key, each in value.items():
            yield key
            yield from strings(each)
    elif isinstance(value, list):
        for each in value:
            yield from strings(each)
    elif isinstance(value, str):
        yield value


def check_json(args, text, true):
    held = [s for document in text for s in strings(json.loads(document))]
    if true is not None and not any(true in s for s in held):
        complain("JSON does not hold the name " + ascii(true), args, "\n".join(text))


def check_page(args, text):
    if "<script>alert" in text or re.search("(href|src)=\"(javascript|data:text)", text):
        complain("page runs a script", args, text[text.find("alert") - 200:])


def check(args, form, text, true=None):
    if form == "utf8":
        return
    if form == "csv":  # of the validator its rows end as RFC 4180 has it
        text = text.replace("\r\n", "\n")
    check_text(args, form, text)
    if form == "csv":
        check_csv(args, text)
    elif form == "json":
        check_json(args, [text], true)
    elif form == "jsonl":
        check_json(args, text.splitlines(), true)
    elif form == "html":
        check_page(args, text)
    elif form == "xml":
        xml.dom.minidom.parseString(text.encode())
        check_page(args, text)
    elif form == "glsl":
        for line in text.split("\n"):
            if line.startswith("//") and (line.endswith("\\") or "error" in line):
                complain("GLSL comment does not end with its line", args, line)


def etak(*args, form="text", true=None, stdin=None, exits=(0, 1, 2), env=None):
    """Runs etak, and checks what it says. Gives standard output."""
    global commands
    commands += 1
    args = [a if isinstance(a, str) else str(a) for a in args]
    done = subprocess.run(["etak"] + [os.fsencode(a) for a in args], input=stdin if stdin is not None else b"",
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60,
                          env={**os.environ, **(env or {})}, check=False)
    if done.returncode not in exits:
        complain("exit status %d, expected %s" % (done.returncode, exits), args, done.stderr)
    for stream, data in (("stderr", done.stderr), (form, done.stdout)):
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError:
            complain(stream + " is no UTF-8", args, data)
            continue
        if stream == "stderr":
            check_text(args, stream, text)
        elif done.returncode == 0 or (text and form not in ("json", "jsonl", "xml")):
            try:
                check(args, form, text, true)
            except (ValueError, csv.Error, xml.parsers.expat.ExpatError) as why:
                complain(form + " does not parse (%s)" % why, args, text)
    return done.stdout


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(path, texel):
    rows = b"".join(b"\0" + bytes(texel) * 8 for _ in range(8))
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 6, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write(path, text):
    with open(path, "w", encoding="utf-8", newline="") as out:
        out.write(text if isinstance(text, str) else json.dumps(text))


def material(name, number):
    rows = [[380, 0.2, 3.1], [500, 0.3, 3.2], [600, 0.25, 3.3], [780, 0.2, 3.4]]
    return {"schema": "etak-material/1", "id": "hostile_%d" % number, "name": name,
            "aliases": ["alias %d " % number + name], "class": "metal", "preferred": "a-1999",
            "preferred_reason": name, "datasets": [
                {"id": "a-1999", "quantity": "n,k", "origin": "measured", "sample": name, "note": name,
                 "axis": "ordinary", "citation": {"authors": [name], "title": name, "published_in": name, "year": 1999,
                                                  "url": "javascript:alert(1)", "licence": name, "via": name},
                 "unit": "nm", "valid_range": [380, 780], "columns": ["wavelength", "n", "k"], "rows": rows}]}


PAGE = """REFERENCES: "%s"
COMMENTS: "%s"
DATA:
  - type: tabulated nk
    data: |
        0.38 1.5 3
        0.5 1.6 3
        0.78 1.7 4
"""


def make_inputs():
    os.mkdir("library")
    os.mkdir("tables")
    os.mkdir("broken")
    os.mkdir("pages")
    for i, (name, file) in enumerate(zip(NAMES, FILES)):
        write("library/%d.json" % i, material(name, i))
        write("tables/" + file + ".csv", "nm,n,k\n380,0.2,3\n500,0.3,3.1\n780,0.2,3.2\n")
        write("pages/" + file + ".yml", PAGE % (SCRIPT, "a"))
        write("broken/" + file + ".json", {name: 1})
        write("broken/" + file + ".csv", name)
        write("broken/" + file + ".yml", name)
    whole = material(NAMES[0], 9)
    for where, change in (("key", {NAMES[0]: 1}), ("id", {"id": NAMES[1]}), ("class", {"class": NAMES[2]}),
                          ("preferred", {"preferred": NAMES[0]}), ("datasets", {"datasets": [{NAMES[0]: 1}]})):
        write("broken/" + where + ".json", {**whole, **change})
    os.mkdir("bytes")
    with open(b"bytes/\xff\xfe\x9b.csv", "wb") as out:
        out.write(b"\xff\xfe\x9b=1")


def materials():
    shared = ["--library", "library", "-j", "1"]
    for i, name in enumerate(NAMES):
        one = "library/%d.json" % i
        for verb in (["show"], ["f0"], ["import"], ["choose"], ["f0", "--stats"], ["render", "-o", "%d.png" % i],
                     ["render", "--reference", "-o", "r%d.png" % i, "--size", "8"]):
            etak(*verb, one, form="text" if verb[0] != "import" else "json")
        etak("show", one, env={"COLUMNS": "40"})
        etak("show", one, "--format", "json", form="json", true=name)
        etak("f0", one, "--format", "json", form="json", true=name)
        etak("import", one, form="json", true=name)
        etak("import", "tables/" + FILES[i] + ".csv", "--id", "x", "--name", name, "--class", "metal", form="json",
             true=name)
        etak("import", "pages/" + FILES[i] + ".yml", "--id", "x", form="json")
        for form in ("table", "text", "csv"):
            etak("export", one, "--to", "values", "--format", form, form="csv" if form == "csv" else "text")
        etak("export", one, "--to", "values", "--format", "json", form="json", true=name)
        etak("export", one, "--to", "gltf", form="json", true=name)
        etak("export", one, "--to", "mtlx", form="xml")
        for target in ("unreal", "glsl", "blender", "filament", "openpbr"):
            etak("export", one, "--to", target, "--format", "text")
        etak("choose", one, "--format", "json", form="json")
        etak("shader", one, form="glsl")
        etak("shader", one, "--format", "json", form="json")
        etak("list", "alias %d " % i + name, *shared[:2])
        for form in ("csv", "json", "jsonl", "markdown", "table"):
            etak("list", "alias %d " % i + name, name, *shared[:2], "--format", form, exits=(0, 1),
                 form={"markdown": "text", "table": "text"}.get(form, form), true=name)
    for form in ("table", "csv", "json", "jsonl"):
        kind = "text" if form == "table" else form
        etak("list", *shared, "--format", form, form=kind, true=NAMES[0])
        etak("list", *shared, "--search", "hostile", "--format", form, form=kind, true=NAMES[2])
        etak("f0", "--all", *shared, "--format", form, form=kind, true=NAMES[1] if kind[:4] == "json" else None)
        if form != "jsonl":
            etak("nearest", "#d8d8d8", "-n", "10000", *shared, "--format", form, form=kind, true=NAMES[1])
    etak("f0", "library", "--format", "html", form="html")
    etak("export", "--all", "--to", "values", "--target", "hex", *shared, form="text")
    write("names.lst", "\0".join(NAMES) + "\0")
    for form in ("table", "csv", "json", "markdown"):
        etak("list", "--names-from", "names.lst", "--format", form,
             form={"csv": "csv", "json": "json"}.get(form, "text"), true=NAMES[0])


def files():
    for folder in ("tables", "pages", "broken", "bytes"):
        for form in ("table", "csv", "json", "jsonl", "html"):
            true = FILES[0] if folder in ("tables", "pages") else None
            etak("f0", folder, "--format", form, "-j", "1", form="text" if form == "table" else form, true=true)
            etak("f0", folder, "--format", form, "-j", "2", "-q", form="text" if form == "table" else form)
        for verb in ("f0", "show", "import", "choose", "shader"):
            for file in sorted(os.listdir(os.fsencode(folder))):
                etak(verb, folder + "/" + os.fsdecode(file), form="utf8" if verb == "import" else "text")
        for file in sorted(os.listdir(os.fsencode(folder))):
            path = folder + "/" + os.fsdecode(file)
            etak("f0", "gold", "--library", path)
            etak("export", path, "--to", "mtlx", form="xml")
            etak("f0", path, "--format", "json", form="json")
            etak("render", path, "-o", "x.png")
        etak("f0", "gold", "--library", folder)
        etak("list", "--names-from", folder + "/" + os.fsdecode(sorted(os.listdir(os.fsencode(folder)))[0]))
    listed = "\0".join("tables/" + f + ".csv" for f in FILES) + "\0missing\n::error::\0"
    for form in ("table", "csv", "json"):
        etak("f0", "--files-from", "-", "--format", form, stdin=listed.encode(),
             form="text" if form == "table" else form)
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    out.writerow(["id", "function", "inputs"])
    for name in NAMES:
        out.writerow([name, "fresnel_schlick", "f0=0.04;cos=1"])
        out.writerow([name, name, name])
    write("rows.csv", text.getvalue())
    etak("eval", "--csv", "rows.csv", form="csv")


def options():
    verbs = {"f0": ["gold"], "list": [], "show": ["gold"], "nearest": ["#fff"], "eval": [], "export": ["gold"],
             "import": ["-"], "shader": ["gold"], "render": ["gold"], "pack": [], "validate": [], "choose": ["gold"],
             "report": [], "stability": [], "models": [], "explain": ["ETK101"], "help": []}
    values = ["--format", "-o", "--library", "--class", "--model", "--space", "--ocio", "--dataset", "--family",
              "--target", "--to", "--illuminant", "--observer", "--lights", "--environment", "--size", "--choice",
              "--layout", "--defines", "--material", "--config", "--baseline", "--cache", "--mask", "--role", "--set",
              "--roughness", "--fit", "--search", "--zone", "--only", "--skip", "--profile", "--previous", "--batch",
              "--gutter", "--memory", "--keep", "--space-of", "--page-report", "--page-link", "--names-from",
              "--files-from", "--today", "--costs", "--budget", "--view", "--display", "--unit", "--id", "--name"]
    for verb, rest in verbs.items():
        etak(verb, "--help")
        for name in ASKED:
            etak(verb, name)
            etak(verb, "--" + name, *rest)
            etak(verb, *rest, name)
            etak(name, verb)
    helps = {verb: etak(verb, "--help").decode() for verb in verbs}
    for verb, rest in verbs.items():
        for option in values:
            if verb == "report" and option != "--family":  # a whole report takes its time
                continue
            if option + " " not in helps[verb] and option + "," not in helps[verb]:
                continue
            etak(verb, *rest, option, ASKED[0], form="utf8" if verb in ("import", "shader") else "text")
            for made in ASKED:
                if os.path.isdir(made):
                    shutil.rmtree(made)
                elif os.path.exists(made):
                    os.remove(made)
    etak("f0", "gold/" + ASKED[0])
    etak("f0", "gold", ASKED[0], "--format", "csv", form="csv")
    etak("validate", "--files-from", "-", stdin=b"\x1b[31m\0x\n::error::\0")
    etak("f0", "gold", env={"ETAK_LIBRARY": ASKED[0]})
    etak("f0", "gold", "-o", "new.csv", env={"ETAK_FORCE": ASKED[0]})
    etak("f0", "gold", "--space", "x", env={"OCIO": ASKED[0]})


def pictures():
    os.mkdir("scene")
    scene = {"asset": {"version": "2.0"}, "materials": [], "textures": [], "images": []}
    packed = {"materials": []}
    for i, (name, file) in enumerate(zip(NAMES, FILES)):
        png("scene/" + file + "_diff.png", (200, 200, 200, 255))
        png("scene/" + file + "_spec.png", (129 + i, 129, 129, 90))
        packed["materials"].append({"name": name, "diffuse": file + "_diff.png", "specular": file + "_spec.png"})
        uri = "".join("%%%02X" % b for b in (file + "_diff.png").encode())
        scene["images"].append({"uri": uri, "name": name})
        scene["textures"].append({"source": i})
        scene["materials"].append({"name": name, "pbrMetallicRoughness": {"baseColorTexture": {"index": i}}})
    write("scene/pack.json", packed)
    write("scene/a.gltf", scene)
    write("scene/bad.gltf", {**scene, "extensionsRequired": [NAMES[0]]})
    write("scene/worse.gltf", {**scene, "images": [{"uri": "missing" + NAMES[1]}]})
    if b"was built without" in subprocess.run(["etak", "validate", "scene", "--no-config"], stdout=subprocess.PIPE,
                                              stderr=subprocess.STDOUT, check=False).stdout:
        return "built without pictures"
    for target in ("scene", "scene/a.gltf", "scene/bad.gltf", "scene/worse.gltf", "scene/pack.json", "library", "broken"):
        for form in ("text", "json", "sarif", "junit", "github", "csv", "html"):
            kind = {"sarif": "json", "junit": "xml", "github": "text"}.get(form, form)
            etak("validate", target, "--no-config", "--exit-zero", "--format", form, form=kind, exits=(0, 1, 2),
                 true=FILES[0] if form == "json" and target == "scene" else None)
    etak("validate", "scene", "--no-config", "--write-baseline", "known.json", "--mask", "masks", "--stats")
    etak("validate", "scene", "--no-config", "--baseline", "known.json", "--format", "json", form="json",
         true="\n::error file=x::y")
    for i, name in enumerate(NAMES):
        write("etak%d.toml" % i, "[rules]\n%s = \"off\"\n" % json.dumps(name))
        etak("validate", "scene", "--config", "etak%d.toml" % i)
    for i, target in enumerate(("scene/pack.json", "scene/a.gltf", "scene/bad.gltf", "scene/worse.gltf")):
        for form in ("text", "json"):
            out = "out%d%s%s" % (i, form, FILES[0])
            etak("pack", target, "--out", out, "--report", form, "--page-report", out + ".html", "--stats",
                 "--page-link", "a<b>=\"><script>alert(1)</script>", form=form)
            etak("pack", target, "--out", out, "--report", form, "-u", form=form)
            if os.path.exists(out + ".html"):
                with open(out + ".html", encoding="utf-8") as page:
                    check(["pack", "--page-report"], "html", page.read())
            if os.path.exists(out + "/layout.json"):
                with open(out + "/layout.json", encoding="utf-8") as layout:
                    check_json(["pack", target], [layout.read()], NAMES[0] if i == 0 else None)
                for name in NAMES + ASKED:
                    etak("shader", "--layout", out + "/layout.json", "--material", name, form="glsl")
                etak("shader", "--layout", out + "/layout.json", form="glsl")
    etak("choose", "scene/a.gltf")
    etak("choose", "scene/a.gltf", "--format", "json", form="json")
    write("jobs.json", {"jobs": [{"input": "scene/pack.json", "out": "job" + FILES[0]},
                                 {"input": "missing" + NAMES[0], "out": "job2" + FILES[1]}]})
    etak("pack", "--batch", "jobs.json")
    etak("pack", "--batch", "jobs.json", "--progress", "json", "--report", "none")
    write("rects.txt", NAMES[0])
    etak("pack", "--rects", "--in", "rects.txt", "-o", "placed.txt")


parts = {"materials": (materials, 150), "files": (files, 200), "options": (options, 250), "pictures": (pictures, 60)}
part, least = parts[sys.argv[1]]
make_inputs()
if part() is None and commands < least:
    failures.append("only %d commands ran" % commands)
for each in failures[:40]:
    print(each)
print("%d failures" % len(failures))

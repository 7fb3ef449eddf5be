# SPDX-License-Identifier: Apache-2.0
"""check.py ETAK SOURCE: what etak writes, and what it is built from, follows its own schemas.

Every material file, the JSON of every verb (for the whole library where the verb takes materials), and what import
writes. Exits with 77 (skipped) where Python has no jsonschema.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

etak, source = sys.argv[1:3]


def schema(name):
    with open(f"{source}/resources/schema/{name}.schema.json", encoding="utf-8") as file:
        document = json.load(file)
    Draft202012Validator.check_schema(document)
    return Draft202012Validator(document)


def check(validator, document, what):
    for error in validator.iter_errors(document):
        sys.exit(f"{what}#/{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}")


def run(*arguments):
    return subprocess.run([etak, *arguments], check=True, capture_output=True, text=True).stdout


material, f0 = schema("material"), schema("f0")
files = sorted(glob.glob(f"{source}/materials/**/*.json", recursive=True))
assert len(files) >= 401, len(files)
checked = {}
for path in files:
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    check(material, document, path)
    checked[document["id"]] = document

for path in glob.glob(f"{source}/resources/series/*.json"):
    with open(path, encoding="utf-8") as file:
        check(material, json.load(file), path)

for options in ([], ["--space", "xyz", "--illuminant", "A"], ["--method", "exact", "--outside", "water"],
                ["--method", "point-650-550-450", "--space", "acescg"]):
    document = json.loads(run("f0", "--all", "--format", "json", *options))
    assert len(document["results"]) == len(files)
    check(f0, document, f"f0 {options}")
for line in run("f0", "--all", "--format", "jsonl").splitlines():
    check(f0, json.loads(line), "f0 --format jsonl")

check(schema("sources"), json.loads(run("sources", "--format", "json")), "sources")
with open(f"{source}/resources/unmeasured.json", encoding="utf-8") as file:
    check(schema("unmeasured"), json.load(file), "unmeasured.json")
done = subprocess.run([etak, "list", "steel", "TiN", "dna", "milk", "glod", "qwertzuiop", "--format", "json"],
                      capture_output=True, text=True)
assert done.returncode == 1, done.stderr
check(schema("names"), json.loads(done.stdout), "list of names")
check(f0, json.loads(run("f0", "steel", "gold/*", "--format", "json")), "f0 of an alias with a note")

with tempfile.TemporaryDirectory() as folder:
    page, out = os.path.join(folder, "page.yml"), os.path.join(folder, "out.json")
    with open(page, "w", encoding="utf-8") as file:
        file.write("REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
                   "    data: |\n        0.8 1.5 -0.1\n        0.3 1.6 0.2\n        0.3 1.6 0.2\n")
    run("import", page, "-o", out)
    with open(out, encoding="utf-8") as file:
        check(material, json.load(file), "import")
ids = [entry["id"] for entry in json.loads(run("list", "--format", "json"))["materials"]]
show = schema("show")
for name in ids:
    document = json.loads(run("show", name, "--format", "json"))
    check(show, document, f"show {name}")
    if document["material"] != checked[name]:
        check(material, document["material"], f"show {name}, material")
    check(f0, document["f0"], f"show {name}, f0")

calls = {
    "list": [[], ["--class", "metal"], ["--zone", "inside"]],
    "nearest": [["#ffe49c"], ["0.5,0.5,0.5", "--linear"], ["gold"]],
    "config": [[]],
    "models": [[]],
    "shader": [["gold"], ["pmma", "--diffuse", "0.5,0.1,0.1"], ["water", "--model", "abc-schlick", "--es"],
               ["silicon", "--model", "phong", "--lights", "0", "--hemispheres"]],
}
export = ["--to", "values"]
calls["export"] = [["--all", *export], ["gold", "diamond", *export, "--fit", "preserve-hue", "--target", "unreal,gltf"],
                   ["pmma", *export, "--diffuse", "0.9,0.5,0.1", "--gloss", "0", "--opacity", "0.5"]]
for verb, variants in calls.items():
    validator = schema(verb)
    for options in variants:
        check(validator, json.loads(run(verb, *options, "--format", "json")), f"{verb} {options}")
for options in ([], ["--channel", "rgb", "--term", "schlick"], ["--of", "D", "--term", "ggx"], ["--of", "lobe"], ["--of", "R"]):
    check(schema("curve"), json.loads(run("curve", "gold", "water", *options, "--format", "json")), f"curve {options}")
check(schema("eval"), json.loads(run("eval", "f0", "n=1.5", "k=0", "--format", "json")), "eval f0")
# The table of rules has a schema, and tools that read it get every rule.
rules = schema("rules")
table = json.loads(run("validate", "--list-rules", "--format", "json"))
check(rules, table, "validate --list-rules")
every = json.loads(run("explain", "ETK", "--format", "json"))
check(rules, every, "explain ETK")
assert every == table
check(rules, json.loads(run("explain", "ETK101", "--format", "json")), "explain ETK101")
check(schema("functions"), json.loads(run("eval", "--list", "--format", "json")), "eval --list")

# What a run did with its cache is a file of its own, of both verbs that have one.
with tempfile.TemporaryDirectory() as folder:
    cache = ["--cache", os.path.join(folder, "cache")]
    manifest = os.path.join(folder, "m.json")
    with open(manifest, "w", encoding="utf-8") as file:
        file.write('{"materials": [{"name": "a", "specular": "gold", "gloss": 0.5}]}')
    for i, options in enumerate([["validate", manifest, "--allow-empty"],
                                 ["pack", manifest, "-o", os.path.join(folder, "atlas"), "--no-config"]]):
        use = os.path.join(folder, f"use{i}.json")
        run(*options, *cache, "--cache-report", use)
        with open(use, encoding="utf-8") as file:
            check(schema("cache"), json.load(file), f"--cache-report of {options[0]}")

if os.path.exists(os.path.join(os.path.dirname(etak), "libetak-pictures.so")):
    render = schema("render")
    with tempfile.TemporaryDirectory() as folder:
        for options in (["gold"], ["pmma", "--diffuse", "0.5,0.1,0.1"], ["iron", "--model", "phong"],
                        ["gold", "--reference", "--spp", "4"], ["water", "--env", "studio"]):
            picture = os.path.join(folder, "out.png")
            text = run("render", *options, "--size", "16x16", "--format", "json", "-o", picture, "--force")
            check(render, json.loads(text), f"render {options}")

with tempfile.TemporaryDirectory() as folder:
    # A project as etak-editor saves it; that etak pack takes it is looked at below.
    project = {"schema": "etak-project/1", "materials": [
        {"name": "gold", "measured": {"material": "gold", "outside": "water"}, "gloss": 0.7},
        {"name": "red", "diffuse": [0.5, 0.1, 0.1], "specular": [0.04, 0.04, 0.04], "model": "ggx-f82"}],
        "view": {"compare": {"on": True, "pinned": {"name": "copper", "measured": {"material": "copper"}}},
                 "wedge": {"on": True, "parameter": "gloss", "steps": 5}}}
    check(schema("project"), project, "project")

check(schema("stability"), json.loads(run("stability", "--format", "json")), "stability")

# The rest runs in other programs, where the libraries for them were found when etak was built.
def run_where_built(*arguments):
    done = subprocess.run([etak, *arguments], capture_output=True, text=True)
    if done.returncode == 2 and ("is missing" in done.stderr or "was built without" in done.stderr):
        print(f"left out: {done.stderr.strip()}")
        return None
    assert done.returncode in (0, 1), (arguments, done.stderr)
    return done.stdout


# Every line of progress follows its schema.
done = subprocess.run([etak, "f0", "--all", "--format", "csv", "--progress", "json"], check=True, capture_output=True,
                      text=True)
lines = [json.loads(line) for line in done.stderr.splitlines() if line.startswith("{")]
assert lines and lines[-1]["ended"] and lines[-1]["done"] == lines[-1]["total"], lines
for line in lines:
    check(schema("progress"), line, "f0 --progress json")

text = run_where_built("choose", "gold", "water", "--format", "json")
if text is not None:
    check(schema("choose"), json.loads(text), "choose")
with tempfile.TemporaryDirectory() as folder:
    out = os.path.join(folder, "report")
    if run_where_built("report", "--family", "transfer", "-o", out) is not None:
        with open(os.path.join(out, "report.json"), encoding="utf-8") as file:
            check(schema("error-time"), json.load(file), "report")
    manifest, atlas = os.path.join(folder, "manifest.json"), os.path.join(folder, "atlas")
    with open(manifest, "w", encoding="utf-8") as file:
        json.dump({"schema": "etak-atlas-manifest/1", "materials": [
            {"name": "gold", "specular": "gold", "gloss": 0.7},
            {"name": "red", "diffuse": [0.5, 0.1, 0.1], "specular": 0.04, "gloss": 0.5}]}, file)
    with open(manifest, encoding="utf-8") as file:
        check(schema("atlas-manifest"), json.load(file), "atlas manifest")
    for masked in ("tests/cli/pack_mask/manifest.json", "tests/fuzz/corpus/manifest/mask.json"):
        with open(os.path.join(source, masked), encoding="utf-8") as file:
            check(schema("atlas-manifest"), json.load(file), masked)
    project_file = os.path.join(folder, "project.json")
    with open(project_file, "w", encoding="utf-8") as file:
        json.dump(project, file)
    run_where_built("pack", project_file, "--out", os.path.join(folder, "project-atlas"), "--report", "json")
    text = run_where_built("pack", manifest, "--out", atlas, "--report", "json")
    if text is not None:
        report = json.loads(text)
        check(schema("pack-report"), report, "pack")
        if "validation" in report:
            check(schema("validation"), report["validation"], "pack, validation")
        plan = os.path.join(folder, "plan")
        jobs, batch = os.path.join(folder, "jobs.json"), os.path.join(folder, "batch.json")
        with open(jobs, "w", encoding="utf-8") as file:
            json.dump({"jobs": [{"input": "manifest.json", "out": "batch-1"}, {"input": "none.json", "out": "x"}]}, file)
        for planned in (["validate", folder], ["pack", "--batch", jobs]):
            run("plan", "--tasks", "3", "--format", "json", "-o", plan, "--force", "--", *planned)
            with open(os.path.join(plan, "plan.json"), encoding="utf-8") as file:
                check(schema("plan"), json.load(file), "plan")
        for shard in ([], ["--shard", "1/2"]):
            subprocess.run([etak, "pack", "--batch", jobs, "--batch-report", batch, "--report", "none", "-q", *shard],
                           capture_output=True, check=False)
            with open(batch, encoding="utf-8") as file:
                check(schema("pack-batch"), json.load(file), "pack --batch-report")
        text = run_where_built("choose", manifest, "--format", "json")
        if text is not None:
            check(schema("choose"), json.loads(text), "choose of a scene")
        with open(os.path.join(atlas, "layout.json"), encoding="utf-8") as file:
            check(schema("atlas-layout"), json.load(file), "atlas layout")
        for shard in ([], ["--shard", "1/1"]):
            text = run_where_built("validate", atlas, "--format", "json", *shard)
            if text is not None:
                check(schema("validation"), json.loads(text), "validate")
        # F0 0.04 encoded twice, which is repaired, and a copied companion.
        draw = [sys.executable, f"{source}/tests/cli/png.py", "a_diff.png=90-130,80-110,70-90,255", "a_spec.png=128,128,128,90-130"]
        pairs = os.path.join(folder, "pairs")
        os.mkdir(pairs)
        subprocess.run(draw, check=True, cwd=pairs)
        text = run_where_built("validate", pairs, "--no-config", "--exit-zero", "--fix", os.path.join(folder, "fixed"),
                               "--format", "json")
        if text is not None:
            fixed = json.loads(text)
            check(schema("validation"), fixed, "validate --fix")
            assert len(fixed["repairs"]["files"]) == 2 and fixed["repairs"]["left"], text
        names = os.path.join(folder, "names")
        os.mkdir(names)
        for name in ("T_Wall_BC.1001.png", "T_Wall_RMA.1001.png", "Wall_4K-PNG_NormalDX.png",
                     "Wall_4K-PNG_Opacity.png", "band.png", "notes.txt"):
            open(os.path.join(names, name), "w", encoding="utf-8").close()
        text = run_where_built("validate", atlas, names, "--list-files", "--format", "json")
        if text is not None:
            listed = json.loads(text)
            check(schema("files"), listed, "validate --list-files")
            assert {"checked", "not checked by a rule", "not recognised"} <= {f["state"] for f in listed["files"]}, text

print(f"{len(files)} materials and etak's JSON follow their schemas")

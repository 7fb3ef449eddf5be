# SPDX-License-Identifier: Apache-2.0
"""check.py ETAK SOURCE: what etak writes, and what it is built from, follows its own schemas.

Every material file, etak's JSON and JSON Lines for the whole library (a refused material and other spaces among it),
and what import writes. Exits with 77 (skipped) where Python has no jsonschema.
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
files = sorted(glob.glob(f"{source}/materials/*/*.json"))
assert len(files) >= 175, len(files)
for path in files:
    with open(path, encoding="utf-8") as file:
        check(material, json.load(file), path)

for options in ([], ["--space", "xyz", "--illuminant", "A"], ["--method", "exact", "--outside", "water"],
                ["--method", "point-650-550-450", "--space", "acescg"]):
    document = json.loads(run("f0", "--all", "--format", "json", *options))
    assert len(document["results"]) == len(files)
    check(f0, document, f"f0 {options}")
for line in run("f0", "--all", "--format", "jsonl").splitlines():
    check(f0, json.loads(line), "f0 --format jsonl")

with tempfile.TemporaryDirectory() as folder:
    page, out = os.path.join(folder, "page.yml"), os.path.join(folder, "out.json")
    with open(page, "w", encoding="utf-8") as file:
        file.write("REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
                   "    data: |\n        0.8 1.5 -0.1\n        0.3 1.6 0.2\n        0.3 1.6 0.2\n")
    run("import", page, "-o", out)
    with open(out, encoding="utf-8") as file:
        check(material, json.load(file), "import")
print(f"{len(files)} materials and etak's JSON follow their schemas")

# SPDX-License-Identifier: Apache-2.0
"""Files changed at random through every verb that reads, and command lines changed at random.

Whatever the file says: no crash, no hang, status 0, 1 or 2, a word for 2, and a file of -o that is the old one or a
whole new one."""
import json
import re
import shutil

from inputs import mutate, png, png_checksums, write_manifest
from tally import content, run

OLD = b"the old file\n"
BATCH = 96


def seeds_of(corpus, *doors):
    return [path.read_bytes() for door in doors for path in sorted((corpus / door).iterdir())]


def changed_files(soak, tally, deadline):
    """Batches of changed files, each through the verb that reads their kind."""
    random, corpus, etak = soak.random("files"), soak.corpus, soak.etak
    work = soak.folder("files")
    pictures = [png(16, 16, channels, random) for channels in (1, 3, 4, 4)]
    pictures += [data[1:] for data in seeds_of(corpus, "png")]
    # kind: seeds, the ending of a file's name, files a run takes, and the command for their names
    json_out = ["--force", "-o", "out.json"]
    kinds = {
        "material": (seeds_of(corpus, "material"), ".json", BATCH,
                     lambda n: ["f0", *n, "--format", "json", *json_out]),
        "page": (seeds_of(corpus, "rii_page"), ".yml", BATCH,
                 lambda n: ["f0", *n, "--format", "json", *json_out]),
        "table": (seeds_of(corpus, "table"), ".csv", BATCH, lambda n: ["f0", *n, "--unit", "nm", *json_out]),
        "import": (seeds_of(corpus, "rii_page", "table"), ".yml", 1, lambda n: ["import", *n, *json_out]),
        "export": (seeds_of(corpus, "material"), ".json", 1,
                   lambda n: ["export", *n, "--to", "gltf", *json_out]),
        "csv": (seeds_of(corpus, "eval_csv"), ".csv", 1,
                lambda n: ["eval", "--csv", *n, "--force", "-o", "out.csv"]),
        "rects": ([b"10 20\n3 4\n5 6\n", b"# few\n1 1\n700 2\n"], ".txt", 1,
                  lambda n: ["pack", "--rects", "--in", *n, "--effort", "2", "-o", "out.txt"]),
        "texture": (pictures, "_specular_gloss.png", BATCH,
                    lambda n: ["validate", ".", "--no-config", "--exit-zero", "--format", "json", *json_out]),
        "picture": (pictures, "_diffuse_alpha.png", BATCH,
                    lambda n: ["validate", ".", "--no-config", "--exit-zero", "--format", "sarif", *json_out]),
        "validate": (seeds_of(corpus, "material"), ".json", BATCH,
                     lambda n: ["validate", ".", "--no-config", "--exit-zero", "--format", "json", *json_out]),
        "config": (seeds_of(corpus, "toml"), ".toml", 1,
                   lambda n: ["validate", "../good", "--config", *n, "--exit-zero", "--format", "json",
                              *json_out]),
        "baseline": (seeds_of(corpus, "baseline"), ".json", 1,
                     lambda n: ["validate", "../good", "--no-config", "--baseline", *n, "--exit-zero",
                                "--format", "json", *json_out]),
        "scene": (seeds_of(corpus, "gltf"), ".gltf", 1,
                  lambda n: ["pack", *n, "--out", "out", "--no-validate", "--report", "none"]),
        "manifest": (seeds_of(corpus, "manifest"), ".json", 1,
                     lambda n: ["pack", *n, "--out", "out", "--no-validate", "--report", "none"]),
        "batch": (seeds_of(corpus, "batch"), ".json", 1,
                  lambda n: ["pack", "--batch", *n, "--no-validate", "--report", "none"]),
        "layout": (seeds_of(corpus, "layout"), ".json", 1,
                   lambda n: ["shader", "--layout", *n, "--material", "a", "--force", "-o", "out.txt"]),
        "choice": ([b'{"schema": "etak-choose/2", "choices": [{"material": "a", "met": true}]}'], ".json", 1,
                   lambda n: ["shader", "--choice", *n, "--material", "a", "--force", "-o", "out.txt"]),
        "lights": ([b'{"schema": "etak-lights/1", "lights": []}'], ".json", 1,
                   lambda n: ["shader", "gold", "--lights", *n, "--force", "-o", "out.txt"]),
        "costs": (seeds_of(corpus, "costs"), ".json", 1,
                  lambda n: ["choose", "gold", "--costs", *n, "--force", "-o", "out.txt"]),
    }
    good = soak.folder("files") / ".." / "good"
    write_manifest(good, random, 16, 1)
    # Programs that pack and check take many times as long to start: they get fewer runs of one file.
    slow = {"config", "baseline", "costs", "batch", "scene", "manifest"}
    names = [name for name in kinds for _ in range(1 if name in slow else 5)]
    done = 0
    while not soak.over(deadline):
        kind = random.choice(names)
        seeds, ending, count, command = kinds[kind]
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        files = []
        for i in range(count):
            data = mutate(random.choice(seeds), random, seeds)
            if ending.endswith(".png") and random.random() < 0.6:
                data = png_checksums(data)
            name = f"f{i}{ending}"
            (work / name).write_bytes(data)
            files.append(name)
        args = command(files)
        out = next((a for a in args if a.startswith("out.")), None)
        if out:
            (work / out).write_bytes(OLD)
        result = run([etak, *args], cwd=work, env=soak.environment)
        done += count
        after = content(work / out) if out else None
        good_end = tally.judge(result, files=work, told=after is not None and b"ETK001" in after)
        if out and good_end:
            whole = after is not None and (after == OLD or not out.endswith(".json") or is_json(after))
            told = args[0] == "validate"  # the report is written whatever it says
            if not whole or (result.status == 2 and count == 1 and not told and after != OLD):
                tally.fault("mixed", f"{out} is neither the old file nor a whole new one", result, work)
        tally.no_leftovers(work, result)
    tally.note = f"{done:,} files"


def is_json(data):
    try:
        json.loads(data)
        return True
    except ValueError:
        return False


# Verbs without those that measure for minutes, and options that wait or measure.
VERBS = ["f0", "list", "show", "nearest", "import", "export", "eval", "models", "curve", "pack", "render", "shader",
         "stability", "choose", "validate", "explain", "help"]
LONG = {"--watch", "--measure", "--write-costs", "--full", "--reference", "--all", "--sheet", "--stdin-format"}
# Where a large number is an honest order for much work.
SMALL = {"--size", "--spp", "--frames", "--effort", "--light-samples", "--page", "--jobs", "--threads",
         "--count"}
VALUES = ["0", "1", "-1", "0.5", "1e999", "nan", "inf", "99999999999999999999", "gold", "", " ", "x" * 300,
          "a.json", "t.csv", "p.yml", "m.json", "s.gltf", "in", "none", "..", ".", "-", "--", "json", "auto", "D65",
          "srgb", "#ff00", "#ffe29b", "1,2", "0.1,0.2,0.3", "\u202e", "\x1b[31m", "\n", "a=b", "=1", "*", "{name}",
          "ETK1", "/dev/null", "png", "gltf", "nm", b"\xff\xfe", "1:2", "pages:64", "f82", "ggx-f82", "schlick",
          "water"]


def command_lines(soak, tally, deadline):
    """Options of each verb's own help with values at random, in a folder with a few good files."""
    random, etak, corpus = soak.random("lines"), soak.etak, soak.corpus
    work, good = soak.folder("lines"), soak.folder("lines-good")
    for name, source in (("a.json", "material/nk.json"), ("t.csv", "table/nk.csv"), ("p.yml", "rii_page/nk.yml"),
                         ("s.gltf", "gltf/square.gltf"), ("m.json", "manifest/least.json")):
        good.mkdir(exist_ok=True)
        shutil.copy(corpus / source, good / name)
    write_manifest(good / "in", random, 8, 1)
    helps = {verb: run([etak, verb, "--help"]).out for verb in VERBS}
    options = {verb: sorted(set(re.findall(r"--[a-z0-9][a-z0-9-]*", text)) - LONG)
               for verb, text in helps.items()}
    words = sorted({word for each in options.values() for word in each})
    while not soak.over(deadline):
        shutil.rmtree(work, ignore_errors=True)
        shutil.copytree(good, work)
        verb = random.choice(VERBS)
        line = [verb] if random.random() < 0.97 else []
        for _ in range(random.randint(0, 6)):
            option = random.choice(options[verb] if random.random() < 0.9 else words)
            value = random.choice(VALUES)
            if option in SMALL:
                value = random.choice(["1", "2", "7", "0", "-3", "x"])
            if option in ("-o", "--output", "--out"):
                value = random.choice(["o.json", "o.png", "o", "in", "a.json", "/dev/full", "no/o.csv"])
            line += random.choice([[option, value], [option], [value], [os_join(option, value)]])
        result = run([etak, *line], cwd=work, env=soak.environment)
        # 3 is how bare rectangles say that a mode is not offered.
        reported = verb == "validate" and any(option in line for option in ("-o", "--output"))
        tally.judge(result, (0, 1, 2, 3) if "--rects" in line else (0, 1, 2), work, told=reported)
        tally.no_leftovers(work, result)


def os_join(option, value):
    return option.encode() + b"=" + value if isinstance(value, bytes) else f"{option}={value}"

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""random_scenes.py ETAK COUNT [--seed N] [--keep FOLDER] [-v]: packs COUNT random scenes in every form, and compares
each with its source: what etak calls exact, and each material by what is told of its conversion. By default no scene may
take more than its source, on a GPU or the disk. Where there is the Khronos validator, it must have no error or warning for
what is written that it has not for the source. A text is printed for each fault; ends with 1 where there is one."""
import argparse
import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from evaluate import Scene, compare
from generate import write_scene

FORMS = ("specular-ior", "specular-glossiness", "metal-rough", "smallest")
# Codes. What is exact differs by a code at texel centres, and by a little more that comes from UVs and vertex colours
# that are floats; between them the rounding of a bright code counts for more in the dark.
AT_CENTRES, ANYWHERE = 1.1, 1.7
# Textures that are not converted differ by the UVs' rounding alone.
AS_THEY_ARE = {"base colour", "normal", "occlusion", "emissive"}
AS_IT_IS = 0.6


class Totals:
    def __init__(self):
        self.scenes = self.packs = self.exact = self.texels = 0

    def __str__(self):
        return (f"{self.scenes:,} scenes, {self.packs:,} packs, of which {self.exact:,} exact: {self.texels:,} texels "
                "compared")


def options_of(seed, form):
    rng = random.Random(f"{seed} {form}")
    out = ["--gltf-form", form, "--goal", rng.choice(("auto", "gpu", "disk", "both"))]
    if rng.random() < 0.5:
        out += ["--keep", "islands"]
    if rng.random() < 0.2:
        out.append("--all-scenes")
    if rng.random() < 0.3:
        out += ["--gutter", str(rng.choice((1, 2, 4)))]  # without one, neighbours are mixed at the borders of regions
    return out


def told_costs(remarks):
    """By material: the codes by which its conversion is told to differ at most."""
    out = {}
    for remark in remarks:
        name, _, text = remark.partition(": as diffuse and F0 it is not quite what it was")
        if text:
            out[name] = max(map(float, re.findall(r"up to ([0-9.]+) codes", text)))
    return out


def faults_of(differences, told):
    """What differs by more than exactness allows, or more than was told, a sentence for each material."""
    out = []
    for name, difference in differences.items():
        worst = []
        for values, is_centre in ((difference.at_centres, True), (difference.anywhere, False)):
            for what, codes in values.items():
                if what == "diffuse light" and not is_centre:
                    continue  # a product of both, which no pair of textures holds between texels
                if what in AS_THEY_ARE:
                    limit = AS_IT_IS
                elif name in told and not is_centre:
                    continue  # what is told is of centres and of places half way between them
                else:
                    limit = told.get(name, 0) + (AT_CENTRES if is_centre else ANYWHERE)
                if codes > limit:
                    worst.append((codes, what, is_centre))
        if worst:
            codes, what, is_centre = max(worst)
            out.append(f"material {name}: {what} {codes:.1f} codes off, told {told.get(name, 0)}, "
                       f"{'at a texel centre' if is_centre else 'between texels'}, {difference.where[what]}")
    return out


def check_form(etak, source, seed, form, folder, totals, env=None):
    """Packs in one form; returns what is wrong, and the command."""
    out = folder / f"out_{form}"
    command = [str(etak), "pack", str(source), "-o", str(out), "--report", "json", "--no-validate", "-j", "1",
               *options_of(seed, form)]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60, env=env)
    totals.packs += 1
    if result.returncode != 0:
        return [f"status {result.returncode}: {result.stderr.strip()}"], command
    report = json.loads(result.stdout)
    written = next(each for each in report["forms"] if each["written"])
    totals.exact += written["exact"]
    if form == "smallest" and report["goal"] == "auto":
        scene, source_totals = report["totals"]["scene"], report["totals"]["input"]["all"]
        more = [what for what in ("gpu", "disk") if scene[what] > source_totals[what]]
        if more:
            return [f"{', '.join(more)}: {scene} of {source_totals}"], command
    # Materials that are solved for metal-rough form differ, and that is all that is told.
    if not written["exact"] and written["form"] == "metal-rough":
        return [], command
    told = {} if written["exact"] or written["form"] == "metal-rough" else told_costs(report["remarks"])
    differences = compare(Scene(source), Scene(out / "scene.gltf"), seed)
    totals.texels += sum(each.texels for each in differences.values())
    return faults_of(differences, told), command


def check_scene(etak, seed, folder, totals, env=None):
    """Makes and packs one scene; yields what is wrong, and the command."""
    source = write_scene(seed, folder)
    totals.scenes += 1
    for form in FORMS:
        try:
            faults, command = check_form(etak, source, seed, form, folder, totals, env)
        except Exception as broken:  # a written scene that cannot be read is a find as well
            faults, command = [f"{type(broken).__name__}: {broken}"], [form]
        for fault in faults:
            yield f"scene {seed}, {form}: {fault}", command


def judge(folders):
    """Yields errors and warnings of the Khronos validator that written scenes have and their sources have not."""
    files = [str(each) for folder in folders for each in [folder / "scene.gltf", *sorted(folder.glob("out_*/scene.gltf"))]]
    result = subprocess.run(["node", str(Path(__file__).with_name("judge.js")), *files], capture_output=True, text=True)
    if result.returncode == 77:
        print("no gltf-validator (NODE_PATH): what is written is not validated")
        return
    messages = json.loads(result.stdout)

    def codes(file):
        return {message.split()[0] for message in messages[str(file)]}

    for file in map(Path, files):
        source = file.parent.parent / "scene.gltf"
        if file.parent.name.startswith("out_") and (new := codes(file) - codes(source)):
            first = next(message for message in messages[str(file)] if message.split()[0] in new)
            yield f"scene {source.parent.name}, {file.parent.name}: {first}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("etak", type=Path)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; each further one has the next number")
    parser.add_argument("--keep", type=Path, help="scenes that differ are kept here")
    parser.add_argument("-v", "--verbose", action="store_true")
    args = parser.parse_args()
    totals, faults, folders = Totals(), [], []
    with tempfile.TemporaryDirectory() as name:
        for seed in range(args.seed, args.seed + args.count):
            folders.append(Path(name) / str(seed))
            folders[-1].mkdir()
            found = list(check_scene(args.etak, seed, folders[-1], totals))
            for text, command in found:
                print(text + ("\n  " + " ".join(command) if args.verbose else ""), flush=True)
            faults += [text for text, command in found]
            if found and args.keep:
                shutil.copytree(folders[-1], args.keep / str(seed), dirs_exist_ok=True)
        if shutil.which("node"):
            for text in judge(folders):
                print(text)
                faults.append(text)
    print(f"{totals}, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

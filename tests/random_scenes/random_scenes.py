#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""random_scenes.py ETAK COUNT [--seed N] [--keep FOLDER] [-v]: packs COUNT random scenes in every form, and compares
each that etak calls exact with its source. A text is printed for each that differs by more; ends with 1 where one does."""
import argparse
import json
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from evaluate import Scene, compare
from generate import write_scene

FORMS = ("specular-ior", "specular-glossiness", "metal-rough", "smallest")
# Codes. What is exact differs by the rounding of a pair's codes at texel centres, where further rounding comes from UVs
# that are floats; between them also by less than a code for what a sampler mixes.
AT_CENTRES, ANYWHERE = 1.0, 1.7
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
    out = ["--gltf-form", form, "--goal", rng.choice(("gpu", "gpu", "disk", "both"))]
    if rng.random() < 0.5:
        out.append("--islands")
    if rng.random() < 0.2:
        out.append("--all-scenes")
    if rng.random() < 0.3:
        out += ["--gutter", str(rng.choice((1, 2, 4)))]  # without one, neighbours are mixed at the borders of regions
    return out


def faults_of(differences):
    """What differs by more than exactness allows, a sentence for each material."""
    out = []
    for name, difference in differences.items():
        worst = []
        for values, is_centre in ((difference.at_centres, True), (difference.anywhere, False)):
            for what, codes in values.items():
                if what == "diffuse light" and not is_centre:
                    continue  # a product of both, which no pair of textures holds between texels
                limit = AS_IT_IS if what in AS_THEY_ARE else AT_CENTRES if is_centre else ANYWHERE
                if codes > limit:
                    worst.append((codes, what, is_centre))
        if worst:
            codes, what, is_centre = max(worst)
            out.append(f"material {name}: {what} {codes:.1f} codes off "
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
    if not next(each for each in report["forms"] if each["written"])["exact"]:
        return [], command
    totals.exact += 1
    differences = compare(Scene(source), Scene(out / "scene.gltf"), seed)
    totals.texels += sum(each.texels for each in differences.values())
    return faults_of(differences), command


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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("etak", type=Path)
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; each further one has the next number")
    parser.add_argument("--keep", type=Path, help="scenes that differ are kept here")
    parser.add_argument("-v", "--verbose", action="store_true")
    args = parser.parse_args()
    totals, faults = Totals(), 0
    for seed in range(args.seed, args.seed + args.count):
        with tempfile.TemporaryDirectory() as name:
            found = list(check_scene(args.etak, seed, Path(name), totals))
            for text, command in found:
                print(text)
                if args.verbose:
                    print("  " + " ".join(command))
            faults += len(found)
            if found and args.keep:
                shutil.copytree(name, args.keep / str(seed), dirs_exist_ok=True)
    print(f"{totals}, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

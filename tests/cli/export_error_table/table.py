# SPDX-License-Identifier: Apache-2.0
"""table.py EXPORT LIST: prints for each target and group of classes the mean and the largest dE2000 over the angles
(and the material that has it), from `etak export --all --format json` and `etak list --format json`."""
import json
import sys

groups = {"metal": ["metal", "alloy", "conductor"], "semiconductor": ["semiconductor"],
          "glass, gem, crystal, mineral, salt": ["glass", "gem", "mineral", "crystal", "salt"],
          "liquid, plastic, others": ["liquid", "plastic", "organic", "solid"]}
exported = json.load(open(sys.argv[1], encoding="utf-8"))
classes = {row["id"]: row["class"] for row in json.load(open(sys.argv[2], encoding="utf-8"))["materials"]}
cells = {}
for material in exported["materials"]:
    if any("film" in target for target in material["targets"]):
        continue
    group = next((name for name, members in groups.items() if classes[material["id"]] in members), None)
    for target in material["targets"]:
        if group is None or target["error"] is None:
            continue
        error = target["error"]
        cells.setdefault(target["id"], {}).setdefault(group, []).append((error["max"], error["mean"], material["id"]))
print("| target | " + " | ".join(groups) + " |")
print("|---" * (len(groups) + 1) + "|")
for target in exported["materials"][0]["targets"]:
    if target["id"] not in cells:
        continue
    row = []
    for group in groups:
        errors = cells[target["id"]].get(group)
        if errors is None:
            row.append("spectra")
            continue
        largest, _, name = max(errors)
        row.append(f"{sum(e[1] for e in errors) / len(errors):.1f}; {largest:.1f} ({name})")
    print("| " + target["id"] + " | " + " | ".join(row) + " |")

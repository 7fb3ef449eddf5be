#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `etak report --quick` twice and compares the verdicts of the two runs.

  report_twice.py ETAK [--load N] [--out DIR]

--load N keeps N processes busy beside the runs: with numbers in the caches, and with memory. Prints a table: seconds of
each run, rows that are not settled, and how many verdicts agree, counted over all timed rows and over those that both
runs settled. Exit status 1 where fewer than 98 % agree, more than 10 % are not settled, or a run took 60 s or longer.
It is a measurement and no test: it depends on what else the machine does.
"""
import argparse
import csv
import multiprocessing
import os
import subprocess
import sys
import tempfile
import time


def busy(kind):
    memory = bytearray(64 << 20)
    value = 1.0
    while True:
        if kind % 2:
            memory[:] = memory[1:] + memory[:1]
        else:
            for _ in range(100000):
                value = value * 1.0000001 % 7


def verdicts(folder):
    with open(os.path.join(folder, "report.csv"), encoding="utf-8") as file:
        rows = {(r["family"], r["table"], r["row"]): r["verdict"] for r in csv.DictReader(file)}
    return {key: verdict for key, verdict in rows.items() if verdict != "not timed"}


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("etak")
    arguments.add_argument("--load", type=int, default=2)
    arguments.add_argument("--out")
    options = arguments.parse_args()
    out = options.out or tempfile.mkdtemp()
    os.makedirs(out, exist_ok=True)
    others = [multiprocessing.Process(target=busy, args=(i,), daemon=True) for i in range(options.load)]
    for each in others:
        each.start()
    runs, seconds = [], []
    for name in ("one", "two"):
        start = time.monotonic()
        folder = os.path.join(out, name)
        subprocess.run([options.etak, "report", "--quick", "-q", "--force", "-o", folder], check=True)
        seconds.append(time.monotonic() - start)
        runs.append(verdicts(folder))
    for each in others:
        each.terminate()

    one, two = runs
    assert one.keys() == two.keys()
    equal = [key for key in one if one[key] == two[key]]
    settled = [key for key in one if "not settled" not in (one[key], two[key])]
    equal_settled = [key for key in settled if one[key] == two[key]]
    unsettled = [sum(v == "not settled" for v in run.values()) for run in runs]
    print(f"{options.load} busy processes beside, load {os.getloadavg()[0]:.1f}")
    print("| | first run | second run |\n|---|---|---|")
    print(f"| seconds | {seconds[0]:.1f} | {seconds[1]:.1f} |")
    print(f"| timed rows | {len(one)} | {len(two)} |")
    print(f"| not settled | {unsettled[0]} ({100 * unsettled[0] / len(one):.1f} %) | "
          f"{unsettled[1]} ({100 * unsettled[1] / len(two):.1f} %) |")
    print(f"| equal verdicts, all rows | {len(equal)} ({100 * len(equal) / len(one):.1f} %) | |")
    print(f"| equal verdicts, rows settled in both | {len(equal_settled)} of {len(settled)} "
          f"({100 * len(equal_settled) / max(1, len(settled)):.1f} %) | |")
    for key in one:
        if one[key] != two[key]:
            print("  differs:", "/".join(key), "|", one[key], "|", two[key])
    good = (len(equal_settled) >= 0.98 * len(settled) and max(unsettled) <= 0.1 * len(one) and max(seconds) < 60)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""soak.py BUILD MINUTES [--only NAME,...] [--seed N]: all that looks for what breaks etak, and one table of it.

BUILD holds release, fuzz and tsan; the last two may be missing, and their rows are then left out or say so. The fuzz
targets run beside the harnesses, which come one after the other; both for MINUTES. What is found stays in BUILD/soak
with the input that made it. Ends with 1 where any count but that of runs is not 0."""
import argparse
import os
import random
import shutil
import signal
import sys
import threading
import time
import traceback
from pathlib import Path

import files
import fuzzers
import injections
import interrupts
import others
import race_hunt
import scenes
from tally import Tally, table

# Name, harness, share of the lane's time. Those that only look at few, long runs come last and may overrun.
HARNESSES = [
    ("changed files", files.changed_files, 26),
    ("command lines", files.command_lines, 10),
    ("KILL", interrupts.kills, 14),
    ("INT TERM HUP", interrupts.signals, 10),
    ("injected failures", injections.injected_failures, 24),
    ("limits and XFSZ", interrupts.limits, 8),
    ("racing writers", interrupts.racing_writers, 7),
    ("shrinking files", interrupts.shrinking_files, 5),
    ("watch", interrupts.watch, 5),
    ("clock jumps", others.clock_jumps, 3),
    ("threads", race_hunt.threads, 5),
    ("editor's threads", race_hunt.editor, 4),
    ("random scenes", scenes.random_scenes, 8),
    ("many files", others.many_files, 4),
]


class Soak:
    """Where things are, and how long there is."""

    def __init__(self, build, seed, loud):
        self.build, self.seed, self.loud = build, seed, loud
        self.etak = build / "release" / "bin" / "etak"
        self.fuzz_folder, self.tsan_folder = build / "fuzz" / "bin", build / "tsan" / "bin"
        self.corpus = Path(__file__).resolve().parent.parent / "fuzz" / "corpus"
        self.finds, self.work = build / "soak", build / "soak" / "work"
        kept = ("PATH", "HOME", "LANG", "TMPDIR")
        self.environment = {name: os.environ[name] for name in kept if name in os.environ}
        # Not the settings of the user who runs this.
        self.environment["XDG_CONFIG_HOME"] = str(self.work / "config")

    def random(self, name):
        return random.Random(f"{self.seed} {name}")

    def folder(self, name):
        return self.work / name

    @staticmethod
    def over(deadline):
        return time.monotonic() >= deadline


def run_harnesses(soak, chosen, minutes, tallies):
    """One after the other, each until its share of the lane is over."""
    begin, whole = time.monotonic(), sum(share for _, _, share in chosen)
    until = begin
    for name, harness, share in chosen:
        tally = Tally(name, soak.finds)
        tallies.append(tally)
        until += minutes * 60 * share / whole
        started = time.monotonic()
        try:
            harness(soak, tally, max(until, started + 1))
        except (Exception, SystemExit):
            # A harness that breaks has not shown that etak does not.
            tally.fault("exits", f"the harness itself broke\n{traceback.format_exc()}")
        if soak.loud:
            print(f"  {name}: {tally.runs:,} in {time.monotonic() - started:.0f} s {tally.note}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("minutes", type=float)
    parser.add_argument("--only", default="", help="harnesses by name, and \"fuzz\"")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-v", "--verbose", action="store_true")
    args = parser.parse_args()
    only = [name.strip() for name in args.only.split(",") if name.strip()]
    unknown = set(only) - {"fuzz"} - {name for name, _, _ in HARNESSES}
    if unknown or args.minutes <= 0:
        parser.error(f"no such harness: {', '.join(sorted(unknown))}" if unknown else "MINUTES above 0")
    # nohup makes a program deaf to HUP, and a script's "&" to INT; what is tested would inherit that.
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    soak = Soak(args.build.resolve(), args.seed, args.verbose)
    shutil.rmtree(soak.work, ignore_errors=True)
    shutil.rmtree(soak.work.parent, ignore_errors=True) if not only else None
    soak.work.mkdir(parents=True)
    soak.finds.mkdir(exist_ok=True)
    chosen = [each for each in HARNESSES if not only or each[0] in only]
    fuzzed, tested = [], []
    lanes = [threading.Thread(target=run_harnesses, args=(soak, chosen, args.minutes, tested))]
    if (not only or "fuzz" in only) and soak.fuzz_folder.exists():
        deadline = time.monotonic() + args.minutes * 60
        lanes.append(threading.Thread(target=lambda: fuzzed.extend(fuzzers.fuzzers(soak, deadline))))
    for lane in lanes:
        lane.start()
    for lane in lanes:
        lane.join()
    tallies = fuzzed + tested
    executions = sum(tally.runs for tally in fuzzed)
    text = table(tallies) + f"\n{executions:,} executions of fuzz targets, " \
                            f"{sum(tally.runs for tally in tested):,} runs of programs\n"
    (soak.finds / "table.txt").write_text(text)
    print(text, end="")
    clean = all(tally.clean for tally in tallies)
    if not clean:
        print(f"what was found is in {soak.finds}", file=sys.stderr)
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())

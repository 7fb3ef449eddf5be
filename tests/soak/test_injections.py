#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_injections.py ETAK: a sample of the failures that ./dev soak injects, and programs that do not stand them."""
import os
import random
import sys
import tempfile
import unittest
from pathlib import Path

import injections
from tally import Tally, leftovers

SAMPLE = 24
BROKEN = "#!/bin/sh\ncase $1 in half) printf new >out;; silent) printf new 2>&- >out.part && mv out.part out || exit 2;; esac\n"


class Injections(unittest.TestCase):
    etak = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = Path(self.folder.name)
        self.tally = Tally("test", self.here / "finds")
        self.injector = injections.Injector(self.etak, injections.build_library(self.here), self.here, dict(os.environ))

    def tearDown(self):
        self.folder.cleanup()

    def prepared(self, name):
        job = next(each for each in injections.jobs() if each.name == name)
        self.injector.prepare(job, lambda folder: injections.make_inputs(random.Random("inputs"), folder))
        return job

    def expect_stood(self, job, points):
        for point in points:
            self.injector.try_point(self.tally, job, *point)
        finds = "\n".join(each.read_text() for each in sorted((self.here / "finds").glob("*/what.txt")))
        self.assertTrue(self.tally.clean, finds)

    def sample(self, job):
        calls, allocations = injections.points(job, random.Random("points"))
        return [points[i * len(points) // SAMPLE] for points in (calls, allocations) for i in range(SAMPLE)]

    def test_an_atlas_is_the_old_or_the_new_whatever_call_fails(self):
        job = self.prepared("replaced atlas")
        self.expect_stood(job, self.sample(job))

    def test_a_file_is_the_old_or_the_new_whatever_call_fails(self):
        job = self.prepared("replaced file")
        self.expect_stood(job, self.sample(job))

    def test_memory_that_lacks_before_main_is_told_in_one_line(self):
        self.expect_stood(self.prepared("new file"), [("memory", mode, n) for mode in ("once", "on") for n in (1, 2, 5, 9, 40)])

    def test_memory_that_lacks_for_good_is_told_in_one_line(self):
        for name in ("new repairs", "new atlas"):
            job = self.prepared(name)
            self.expect_stood(job, [("memory", "on", job.allocations * i // 20) for i in range(1, 20)])

    def test_a_repair_that_cannot_be_checked_is_an_error_and_not_refused(self):
        job = self.prepared("replaced repairs")
        reads = [i + 1 for i, kind in enumerate(job.calls) if kind == "i"]
        self.expect_stood(job, [("calls", "once", n) for n in reads])

    def test_what_a_kill_left_goes_where_the_atlas_is_in_place(self):
        job = self.prepared("new atlas")
        for more in (["--cache", "cache"], ["-u"]):
            job.command = [*job.command, *more]
            for _ in range(2):
                (job.folder / ".atlas.etak-Ab12Cd").mkdir(exist_ok=True)
                self.assertEqual(self.injector.run(job)[0].status, 0)
                self.assertEqual(leftovers(job.folder), [])

    def test_a_program_that_stands_no_failure_is_counted(self):
        broken = self.here / "broken"
        broken.write_text(BROKEN)
        broken.chmod(0o755)
        self.injector.etak = broken
        for word, what, column in (("half", ("calls", "kill"), "mixed"), ("silent", ("calls", "once"), "exits")):
            job = injections.Job(word, [word], "out")
            self.injector.prepare(job, lambda folder: None)
            write = job.calls.index("w") + 1
            self.assertEqual(self.injector.try_point(self.tally, job, *what, write), "kill" if word == "half" else "write")
            self.assertGreater(self.tally.counts[column], 0)


if __name__ == "__main__":
    if not sys.platform.startswith("linux") or injections.compiler() is None:
        print("no C compiler, or no Linux")
        sys.exit(77)
    Injections.etak = Path(sys.argv.pop(1)).resolve()
    sys.exit(unittest.main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The soak's counts can fail: programs that crash, hang, end wrongly or leave something behind are counted so."""
import sys
import tempfile
import unittest
from pathlib import Path

import inputs
from tally import Tally, content, run, table


class Counts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = Path(self.folder.name)
        self.tally = Tally("test", self.here / "finds")

    def tearDown(self):
        self.folder.cleanup()

    def counts_after(self, script, allowed=(0, 1, 2), limit=10.0):
        result = run(["sh", "-c", script], cwd=self.here, limit=limit)
        good = self.tally.judge(result, allowed)
        self.assertEqual(good, self.tally.clean)
        return {name: count for name, count in self.tally.counts.items() if count}

    def test_good_ends_count_as_runs_alone(self):
        for script in ("exit 0", "echo told >&2; exit 1", "echo told >&2; exit 2"):
            self.assertEqual(self.counts_after(script), {})
        self.assertEqual(self.tally.runs, 3)

    def test_a_signal_is_a_crash_unless_it_was_sent(self):
        self.assertEqual(self.counts_after("kill -TERM $$", (143,)), {})
        self.assertEqual(self.counts_after("kill -SEGV $$"), {"crashes": 1})

    def test_a_sanitizers_report_is_a_crash_whatever_the_status(self):
        self.assertEqual(self.counts_after("echo 'WARNING: ThreadSanitizer: data race' >&2"), {"crashes": 1})

    def test_a_run_over_the_limit_hangs(self):
        self.assertEqual(self.counts_after("exec sleep 20", limit=0.2), {"hangs": 1})

    def test_other_statuses_and_silent_failures_are_wrong_exits(self):
        self.assertEqual(self.counts_after("exit 3"), {"exits": 1})
        self.assertEqual(self.counts_after("exit 2"), {"exits": 2})

    def test_temporaries_are_leftovers_and_no_content(self):
        for name in (".a.json.etak-Ab12Cd", "a.json.tmp-Ab12Cd", "a.json"):
            (self.here / name).write_text("x")
        self.tally.no_leftovers(self.here)
        self.assertEqual(self.tally.counts["leftovers"], 1)
        self.assertEqual(list(content(self.here)), ["a.json", "finds/test-1/what.txt"])

    def test_the_table_has_a_row_and_the_find_is_kept(self):
        self.counts_after("exit 3")
        self.assertRegex(table([self.tally]), r"\ntest +1 +0 +0 +0 +1 +0$")
        self.assertIn("status: 3", (self.here / "finds" / "test-1" / "what.txt").read_text())

    def test_changed_files_depend_on_the_seed_alone(self):
        from random import Random
        picture = inputs.png(4, 4, 4, Random(1))
        self.assertEqual(inputs.png_checksums(picture), picture)
        changed = [inputs.mutate(picture, Random(7), [b"abc"]) for _ in range(2)]
        self.assertEqual(changed[0], changed[1])
        self.assertNotEqual(changed[0], picture)


if __name__ == "__main__":
    sys.exit(unittest.main())

# SPDX-License-Identifier: Apache-2.0
"""Random scenes: what `etak pack` calls exact looks as its source does, by the count of tests/random_scenes."""
import shutil
import sys
from pathlib import Path

from tally import Result

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "random_scenes"))
from random_scenes import Totals, check_scene  # noqa: E402


def random_scenes(soak, tally, deadline):
    """Scenes of seeds that no other run with this number has."""
    totals, work, seed = Totals(), soak.folder("scenes"), soak.seed * 1_000_000
    while not soak.over(deadline):
        seed += 1
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        for text, command in check_scene(soak.etak, seed, work, totals, soak.environment):
            tally.fault("mixed", text, Result(command, 0, "", text, 0), work)
    tally.runs, tally.note = totals.packs, str(totals)

# SPDX-License-Identifier: Apache-2.0
"""Builds with the thread sanitizer: pack, validate and f0 on eight threads, and the editor's workers."""
from pathlib import Path

from tally import run


def threads(soak, tally, deadline):
    """threads.sh again and again."""
    if not (soak.tsan_folder / "etak").exists():
        tally.note = "skipped: no build with the thread sanitizer"
        return
    first = True
    while first or not soak.over(deadline):
        first = False
        result = run([Path(__file__).parent / "threads.sh", soak.tsan_folder], limit=600, env=soak.environment)
        if result.status == 66:
            tally.runs += 1
            tally.fault("crashes", "a race", result)
        else:
            tally.judge(result, (0,))


# Tests of tests/gui whose work goes to threads: loading and checking of textures, packing, watching, CPU pictures.
EDITOR = ("editor_files", "editor_faults", "editor_library", "editor_widgets", "viewport_cpu")


def editor(soak, tally, deadline):
    """The tests of the editor's workers, without a window."""
    program = soak.tsan_folder / "etak-gui-tests"
    if not program.exists():
        tally.note = "skipped: the editor is not built with the thread sanitizer"
        return
    here = Path(__file__).parent
    env = dict(soak.environment, QT_QPA_PLATFORM="offscreen", ETAK_TEST_SANITIZED="1",
               TSAN_OPTIONS=f"suppressions={here}/races.supp halt_on_error=1 exitcode=66 print_suppressions=0 "
                            f"ignore_noninstrumented_modules=1 die_after_fork=0")
    for turn, name in enumerate(EDITOR):
        if turn > 0 and soak.over(deadline):
            tally.note = f"{turn} of {len(EDITOR)} tests: the time was up"
            break
        result = run([program, name], limit=1800, env=env)
        tally.runs += 1
        if result.status == 66:
            tally.fault("crashes", f"a race in {name}", result)
        elif result.status != 0:
            tally.fault("exits", f"{name}: status {result.status}", result)

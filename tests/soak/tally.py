# SPDX-License-Identifier: Apache-2.0
"""What every harness of the soak shares: running a program under a limit, counting what went wrong, and keeping the
input that made it."""
import os
import re
import shutil
import subprocess
import threading
import time
from pathlib import Path

# A run that says nothing for so long counts as hung.
HANG_SECONDS = 10.0
# Names that etak gives to what is not finished, and its older ones.
LEFTOVER = re.compile(r"(^\..*\.etak-[A-Za-z0-9]{6,}$)|(\.tmp-[A-Za-z0-9]{6}$)")
SANITIZER = re.compile(r"(Address|Thread|Leak|UndefinedBehavior)Sanitizer|runtime error:|terminate called|Assertion")


class Result:
    """How a run ended: `status` as the shell counts it, 128 + N for signal N; None for one that hung."""

    def __init__(self, command, status, out, err, seconds):
        self.command, self.status, self.out, self.err, self.seconds = command, status, out, err, seconds

    @property
    def hung(self):
        return self.status is None


def shell_status(returncode):
    return 128 - returncode if returncode < 0 else returncode


def run(command, cwd=None, limit=HANG_SECONDS, stdin=subprocess.DEVNULL, env=None, before=None):
    """Runs `command` to its end or for `limit` seconds; then it is killed.
    before  called in the child before the program starts, for limits"""
    begin = time.monotonic()
    child = subprocess.Popen(command, cwd=cwd, stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=env,
                             preexec_fn=before)
    try:
        out, err = child.communicate(timeout=limit)
        status = shell_status(child.returncode)
    except subprocess.TimeoutExpired:
        child.kill()
        out, err = child.communicate()
        status = None
    return Result(command, status, out.decode("utf-8", "replace"), err.decode("utf-8", "replace"),
                  time.monotonic() - begin)


def leftovers(folder):
    """Paths below `folder` of what a run began and did not finish."""
    found = []
    for here, folders, files in os.walk(folder):
        found += [os.path.join(here, name) for name in folders + files if LEFTOVER.search(name)]
        folders[:] = [name for name in folders if not LEFTOVER.search(name)]
    return found


def content(path):
    """The bytes of a file, or of a folder by name; nothing that is a leftover. None where there is nothing."""
    path = Path(path)
    if path.is_dir():
        return {str(each.relative_to(path)): each.read_bytes() for each in sorted(path.rglob("*"))
                if each.is_file() and not any(map(LEFTOVER.search, each.relative_to(path).parts))}
    return path.read_bytes() if path.exists() else None


class Tally:
    """The row of one harness, and its finds: build/soak/NAME-N holds the command, what it said and its files."""

    columns = ("crashes", "hangs", "mixed", "exits", "leftovers")

    def __init__(self, name, finds):
        self.name, self.finds = name, Path(finds)
        self.runs = 0
        self.counts = dict.fromkeys(self.columns, 0)
        self.note = ""
        self.lock = threading.Lock()

    def fault(self, column, why, result=None, files=None):
        """Counts a fault, and keeps the first few of a harness."""
        with self.lock:
            self.counts[column] += 1
            number = sum(self.counts.values())
        if number > 20:
            return
        folder = self.finds / f"{self.name.replace(' ', '-')}-{number}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        lines = [f"{column}: {why}"]
        if result is not None:
            command = " ".join(subprocess.list2cmdline([os.fsdecode(part)]) for part in result.command)
            lines += [f"command: {command}", f"status: {result.status}", f"seconds: {result.seconds:.2f}",
                      "--- stderr", result.err[:8000], "--- stdout", result.out[:2000]]
        (folder / "what.txt").write_text("\n".join(lines) + "\n", errors="surrogateescape")
        if files is not None and Path(files).exists():
            shutil.copytree(files, folder / "files", symlinks=True, ignore_dangling_symlinks=True,
                            dirs_exist_ok=True)

    def judge(self, result, allowed=(0, 1, 2), files=None, told=False):
        """Counts the run, and what of its end is wrong. True where nothing is.
        told  whether a report that went to a file says why the status is 2; else the run has to say it"""
        with self.lock:
            self.runs += 1
        if result.hung:
            self.fault("hangs", f"no end after {result.seconds:.0f} s", result, files)
        elif SANITIZER.search(result.err) or "internal error" in result.err:
            self.fault("crashes", "internal error", result, files)
        elif result.status >= 128 and result.status not in allowed:
            self.fault("crashes", f"ended by signal {result.status - 128}", result, files)
        elif result.status not in allowed:
            self.fault("exits", f"status {result.status}, expected one of {sorted(allowed)}", result, files)
        elif result.status == 2 and not told and not (result.err + result.out).strip():
            self.fault("exits", "status 2 without a word", result, files)
        else:
            return True
        return False

    def no_leftovers(self, folder, result=None):
        found = leftovers(folder)
        if found:
            self.fault("leftovers", ", ".join(found[:5]), result)
            for path in found:
                shutil.rmtree(path, ignore_errors=True) if os.path.isdir(path) else os.unlink(path)

    @property
    def clean(self):
        return not any(self.counts.values())


def table(tallies):
    head = ("harness", "runs", "crashes", "hangs > 10 s", "mixed outputs", "wrong exits", "leftovers", "")
    rows = [head] + [(t.name, f"{t.runs:,}", *(str(t.counts[c]) for c in Tally.columns), t.note) for t in tallies]
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    return "\n".join("  ".join(cell.ljust(width) if i in (0, 7) else cell.rjust(width)
                               for i, (cell, width) in enumerate(zip(row, widths))).rstrip() for row in rows)

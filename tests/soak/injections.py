# SPDX-License-Identifier: Apache-2.0
"""One call of a run fails, or the run is killed there: each call that opens, reads, writes, flushes, names or removes a
file in turn, and allocations.

A run whose call fails either does without it and ends as ever, or says why in one line and ends with 2; what it writes is
the old or the new, byte for byte. After a kill it is so too, and the next run to the same target leaves nothing behind."""
import collections
import os
import shutil
import struct
import subprocess
from pathlib import Path

from inputs import png_of, write_manifest
from tally import content, leftovers, run

HEAD = struct.Struct("=III")  # struct seen of inject.c
KINDS = {"o": "open", "i": "read", "w": "write", "s": "fsync", "c": "chmod", "e": "close", "m": "mkdir", "l": "link",
         "r": "rename", "u": "remove", "t": "truncate"}
KILLED = 137
# Of a run's allocations so many are tried each, and of the others a sample of so many.
FIRST_ALLOCATIONS, SAMPLED_ALLOCATIONS = 2000, 500


def compiler():
    """Of C; None where there is none."""
    return shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")


def build_library(folder):
    """Compiles inject.c into `folder`; its path."""
    library = Path(folder) / "inject.so"
    subprocess.run([compiler(), "-shared", "-fPIC", "-O2", "-o", library, Path(__file__).with_name("inject.c"), "-ldl"],
                   check=True)
    return library


class Job:
    """A run whose calls fail. `path` is what it writes; `before` the commands that make what lay there.
    beside  what it changes too and may leave as it likes: the folder of a cache
    tree    whether the files of `path` are put in place one by one, so that some may be old and some new after a kill, and
            where no call succeeds any more that would put the old ones back"""

    def __init__(self, name, command, path, before=(), beside=None, tree=False):
        self.name, self.command, self.before = name, command, before
        self.path, self.beside, self.tree = path, beside, tree
        self.calls, self.allocations = "", 0

    def is_whole(self, now, mode):
        if not self.tree or mode == "once":
            return now in (self.old, self.new)
        old, new = self.old or {}, self.new or {}
        return all((now or {}).get(name) in (old.get(name), new.get(name)) for name in {*old, *new, *(now or {})})


class Injector:
    """Runs jobs in folders of their own below `work`, with calls that fail."""

    def __init__(self, etak, library, work, environment):
        self.etak, self.library, self.work, self.environment = etak, library, Path(work), environment
        self.seen = self.work / "seen"

    def run(self, job, what="none", mode="once", n=0):
        """The result, and how many calls failed, the kinds of all calls, and how many allocations there were."""
        self.seen.write_bytes(bytes(HEAD.size + 16384))
        env = dict(self.environment, LD_PRELOAD=str(self.library), INJECT=f"{what} {mode} {n} {self.seen}")
        result = run([self.etak, *job.command], cwd=job.folder, limit=60, env=env)
        result.command = [f"INJECT={what} {mode} {n}", *result.command]
        data = self.seen.read_bytes()
        calls, allocations, failed = HEAD.unpack_from(data)
        return result, failed, data[HEAD.size:HEAD.size + min(calls, 16384)].decode("ascii"), allocations

    def prepare(self, job, make_inputs):
        """Makes the inputs and what lies at the target; runs the job as ever to know what it writes, says and calls."""
        job.folder, job.kept = self.work / job.name, self.work / f"{job.name} before"
        job.folder.mkdir(parents=True)
        make_inputs(job.folder)
        for command in job.before:
            done = run([self.etak, *command], cwd=job.folder, limit=60, env=self.environment)
            if done.status != 0:
                raise SystemExit(f"soak: {job.name} cannot be prepared: {done.err}")
        job.kept.mkdir()
        self.copy(job, job.folder, job.kept)
        job.old = content(job.folder / job.path)
        job.clean, _, job.calls, job.allocations = self.run(job)
        job.new = content(job.folder / job.path)
        if job.clean.status != 0 or not job.calls:
            raise SystemExit(f"soak: {job.name} does not run: {job.clean.err}")
        self.restore(job)

    @staticmethod
    def copy(job, source, target):
        for name in filter(None, (job.path, job.beside)):
            if (source / name).is_dir():
                shutil.copytree(source / name, target / name)
            elif (source / name).exists():
                shutil.copy2(source / name, target / name)

    def restore(self, job):
        """What lay at the target lies there again, and nothing else that the run may have left."""
        names = [name for name in (job.path, job.beside) if name]
        if all(content(job.folder / name) == content(job.kept / name) for name in names) and not leftovers(job.folder):
            return
        for name in names:
            there = job.folder / name
            shutil.rmtree(there, ignore_errors=True) if there.is_dir() else there.unlink(missing_ok=True)
        self.copy(job, job.kept, job.folder)

    def try_point(self, tally, job, what, mode, n):
        """One run; what is hit, as a word of KINDS, "allocation" or "kill", or None where the run made no such call."""
        result, failed, calls, _ = self.run(job, what, mode, n)
        if mode == "kill":
            if result.status != KILLED:
                return None
            tally.judge(result, (KILLED,), job.folder)
        elif failed == 0:
            return None
        else:
            self.judge(tally, job, result)
        now = content(job.folder / job.path)
        if not job.is_whole(now, mode):
            tally.fault("mixed", f"{job.name}: {job.path} is neither the old nor the new", result, job.folder)
        if now != job.old or leftovers(job.folder):
            self.run_again(tally, job, result)
        self.restore(job)
        return "kill" if mode == "kill" else "allocation" if what == "memory" else KINDS[calls[n - 1]]

    def judge(self, tally, job, result):
        reported = "ETK001" in result.out or "ETK902" in result.out
        if not tally.judge(result, (0, 2), job.folder, told=reported):
            return
        now = content(job.folder / job.path)
        if result.status == 0:
            if now != job.new or result.out != job.clean.out:
                tally.fault("mixed", f"{job.name}: status 0, and not what a run writes and says", result, job.folder)
        elif not reported and (len(result.err.splitlines()) != 1 or not result.err.startswith("etak: ")):
            tally.fault("exits", f"{job.name}: not one line that says why", result, job.folder)

    def run_again(self, tally, job, first):
        """The next run to the same target, of which nothing is left but what it writes."""
        again = run([self.etak, *job.command], cwd=job.folder, limit=60, env=self.environment)
        if tally.judge(again, (0,), job.folder):
            if content(job.folder / job.path) != job.new or again.out != job.clean.out:
                tally.fault("mixed", f"{job.name}: the run after this one differs", first, job.folder)
        tally.no_leftovers(job.folder, first)


def jobs():
    quiet = ["--report", "none", "--no-validate", "-q", "-j", "1"]
    pack_a, pack_b = (["pack", f"{each}/manifest.json", "--out", "atlas", *quiet] for each in "ab")
    f0_a, f0_b = (["f0", each, "--format", "json", "--force", "-q", "-o", "f0.json"] for each in ("gold", "iron"))
    fix = ["validate", "set", "--no-config", "--only", "ETK101,ETK402", "--exit-zero", "-q", "-j", "1"]
    repair = [*fix, "--fix", "fixed", "--force"]
    one_material = [*fix, "--material", "glass", "--fix", "fixed", "--force"]
    cached = ["validate", "a", "--no-config", "--exit-zero", "--format", "json", "-q", "-j", "1", "--cache", "cache"]
    kept_a, kept_b = ([*each, "--cache", "cache"] for each in (pack_a, pack_b))
    return [Job("new atlas", pack_a, "atlas"), Job("replaced atlas", pack_b, "atlas", [pack_a]),
            Job("checked atlas", ["pack", "b/manifest.json", "--out", "atlas", "--fail-on", "never", "-q", "-j", "1"], "atlas"),
            Job("new file", f0_a, "f0.json"), Job("replaced file", f0_b, "f0.json", [f0_a]),
            Job("new repairs", repair, "fixed", tree=True),
            Job("replaced repairs", repair, "fixed", [one_material], tree=True),
            Job("new results in a cache", cached, "none", beside="cache"),
            Job("results from a cache", cached, "none", [cached], beside="cache"),
            Job("new atlas in a cache", kept_b, "atlas", [kept_a], beside="cache"),
            Job("atlas from a cache", kept_b, "atlas", [kept_b, kept_a], beside="cache")]


def make_inputs(random, folder):
    """Two manifests, and a set whose F0 of .04 was encoded to sRGB twice, which --fix repairs."""
    for each in "ab":
        write_manifest(folder / each, random, 16, 1)
    (folder / "set").mkdir()
    diffuse = bytes(random.randrange(80, 140) for _ in range(16 * 16 * 3))
    specular = b"".join(bytes((128, 128, 128, random.randrange(100, 140))) for _ in range(16 * 16))
    (folder / "set" / "crate_diff.png").write_bytes(png_of(16, 16, 3, diffuse))
    (folder / "set" / "crate_spec.png").write_bytes(png_of(16, 16, 4, specular))


def points(job, random):
    """All calls, failing once, from then on, and as the place of a kill; then allocations. What a kill between two reads
    leaves is the same as that before them."""
    calls = [("calls", mode, n) for n, kind in enumerate(job.calls, 1)
             for mode in (("once",) if kind == "i" else ("once", "on", "kill"))]
    rest = range(FIRST_ALLOCATIONS + 1, job.allocations + 1)
    numbers = [*range(1, min(FIRST_ALLOCATIONS, job.allocations) + 1),
               *random.sample(rest, min(SAMPLED_ALLOCATIONS, len(rest)))]
    return calls, [("memory", random.choice(("once", "once", "once", "on")), n) for n in numbers]


def injected_failures(soak, tally, deadline):
    """All calls of every job, then its allocations in an order by chance, as many as there is time for."""
    random = soak.random("injections")
    work = soak.folder("injections")
    work.mkdir(parents=True)
    injector = Injector(soak.etak, build_library(work), work, soak.environment)
    calls, allocations = [], []
    for job in jobs():
        injector.prepare(job, lambda folder: make_inputs(soak.random("injected inputs"), folder))
        of_calls, of_memory = points(job, random)
        calls += [(job, *point) for point in of_calls]
        allocations += [(job, *point) for point in of_memory]
    random.shuffle(calls)
    random.shuffle(allocations)
    hit = collections.Counter()
    for job, what, mode, n in calls + allocations:
        if soak.over(deadline):
            break
        kind = injector.try_point(tally, job, what, mode, n)
        if kind:
            hit[kind] += 1
    tally.note = f"{sum(hit.values()):,} of {len(calls) + len(allocations):,}: " + \
        ", ".join(f"{count:,} {kind}" for kind, count in hit.most_common())

# SPDX-License-Identifier: Apache-2.0
"""Runs that are ended from outside: killed, interrupted, out of resources, overtaken by others, or robbed of an input.

What they were writing is the old set or the new one, never a mixture. INT, TERM, HUP and a file-size limit leave
nothing behind; what a kill leaves is gone once the next run to the same target has ended."""
import functools
import os
import resource
import shutil
import signal
import subprocess
import threading
import time

from inputs import png, write_manifest
from tally import content, leftovers, run, shell_status, Result

GRACE_SECONDS = 1.0


def tells_what_was_not_checked(page):
    """Whether it is a whole page of the validator about files that it could not open or hold."""
    return (isinstance(page, bytes) and page.rstrip().endswith(b"</html>") and
            (b"ETK001" in page or b"ETK902" in page))


class Target:
    """Something that etak writes: two commands that write different content to `path`, and what that content is."""

    def __init__(self, soak, name, path, first, second):
        self.name, self.path, self.commands = name, path, (first, second)
        self.contents, self.trouble, self.seconds = [], None, 0.0
        for command in self.commands:
            result = run([soak.etak, *command], cwd=path.parent, limit=60, env=soak.environment)
            if result.status != 0:
                raise SystemExit(f"soak: {name} does not run: {result.err}")
            self.contents.append(content(path))
            self.seconds = max(self.seconds, result.seconds)

    def check(self, tally, result):
        """Whether it holds one of the two; put right where it does not. A run that lacked files or memory may also have
        written a whole page that says so."""
        now = content(self.path)
        if now in self.contents or now == self.trouble:
            return True
        if result.status == 2 and tells_what_was_not_checked(now):
            self.trouble = now
            return True
        tally.fault("mixed", f"{self.name} is neither the old nor the new", result, self.path.parent)
        return False


def targets(soak, name):
    random, work = soak.random(name), soak.folder(name)
    work.mkdir(parents=True, exist_ok=True)
    write_manifest(work / "a", random, 160)
    write_manifest(work / "b", random, 160)
    quiet = ["--report", "none", "--no-validate", "-q"]
    pack = [["pack", f"{each}/manifest.json", "--out", "atlas", *quiet] for each in "ab"]
    table = [["f0", "--all", "--format", each, "--force", "-q", "-o", "f0.out"] for each in ("json", "csv")]
    ball = [["render", each, "--size", "96", "--device", "cpu", "--force", "-q", "-o", "ball.png"]
            for each in ("gold", "copper")]
    page = [["validate", each, "--no-config", "--exit-zero", "--format", "html", "--force", "-q", "-o", "page.html"]
            for each in "ab"]
    export = [["export", "--all", "--to", "values", "--format", each, "--force", "-q", "-o", "values.out"]
              for each in ("json", "csv")]
    return [Target(soak, "pack", work / "atlas", *pack), Target(soak, "f0", work / "f0.out", *table),
            Target(soak, "render", work / "ball.png", *ball), Target(soak, "validate", work / "page.html", *page),
            Target(soak, "export", work / "values.out", *export)]


def interrupted(soak, command, folder, number, wait, before=None):
    """Runs `command` and sends it signal `number` after `wait` seconds. The result, whose seconds are those that the
    program lived on, and when the signal was sent; None where the program had ended before."""
    child = subprocess.Popen([soak.etak, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, env=soak.environment, preexec_fn=before)
    try:
        out, err = child.communicate(timeout=wait)
        sent = None
    except subprocess.TimeoutExpired:
        child.send_signal(number)
        sent = time.monotonic()
        try:
            out, err = child.communicate(timeout=10)
        except subprocess.TimeoutExpired:
            child.kill()
            out, err = child.communicate()
            return Result([soak.etak, *command], None, "", err.decode("utf-8", "replace"), 10), sent
    seconds = time.monotonic() - sent if sent else 0.0
    return Result([soak.etak, *command], shell_status(child.returncode), out.decode("utf-8", "replace"),
                  err.decode("utf-8", "replace"), seconds), sent


def kills(soak, tally, deadline):
    """KILL at any moment of a run; then a run to the same target, after which nothing is left."""
    random = soak.random("kills")
    known = targets(soak, "kills")
    caught = 0
    while not soak.over(deadline):
        target = random.choice(known)
        command = random.choice(target.commands)
        for _ in range(3):
            result, sent = interrupted(soak, command, target.path.parent, signal.SIGKILL,
                                       random.uniform(0.002, target.seconds))
            caught += sent is not None
            tally.judge(result, (0, 137))
            target.check(tally, result)
        after = run([soak.etak, *command], cwd=target.path.parent, limit=60, env=soak.environment)
        tally.judge(after, (0,))
        target.check(tally, after)
        tally.no_leftovers(target.path.parent, after)
    tally.note = f"{caught} killed"


def signals(soak, tally, deadline):
    """INT, TERM and HUP: the status that the shell expects, within a second, and nothing left."""
    random = soak.random("signals")
    known = targets(soak, "signals")
    caught, slow = 0, 0.0
    while not soak.over(deadline):
        target = random.choice(known)
        number = random.choice((signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
        result, sent = interrupted(soak, random.choice(target.commands), target.path.parent, number,
                                   random.uniform(0.002, target.seconds))
        caught += sent is not None
        slow = max(slow, result.seconds)
        if tally.judge(result, (0, 128 + number)) and sent and result.seconds > GRACE_SECONDS:
            tally.fault("exits", f"lived on for {result.seconds:.1f} s after signal {number}", result)
        target.check(tally, result)
        tally.no_leftovers(target.path.parent, result)
    tally.note = f"{caught} caught, the slowest after {slow:.2f} s"


def limits(soak, tally, deadline):
    """Too little of something: file size (XFSZ), memory, open files, processes, a full disk."""
    random = soak.random("limits")
    known = targets(soak, "limits")

    def setter(kind, most):
        return lambda: resource.setrlimit(kind, (most, most))

    def few_processes(most):
        # The limit does not bind root, so that root's soak runs as nobody here.
        resource.setrlimit(resource.RLIMIT_NPROC, (most, most))
        if os.getuid() == 0:
            os.setgid(65534)
            os.setuid(65534)

    for here, _, _ in os.walk(known[0].path.parent):
        os.chmod(here, 0o777)

    while not soak.over(deadline):
        target = random.choice(known)
        command = list(random.choice(target.commands))
        kind = random.choice(("size", "memory", "files", "processes", "disk"))
        before, allowed, most = None, (0, 2), None
        if kind == "size":
            # Its content may be smaller than the limit.
            most = random.choice((0, 100, 4096, 20000, 200000))
            before, allowed = setter(resource.RLIMIT_FSIZE, most), (0, 2, 153)
        elif kind == "memory":
            most = random.randint(30, 900) << 20
            before = setter(resource.RLIMIT_AS, most)
        elif kind == "files":
            most = random.randint(4, 40)
            before = setter(resource.RLIMIT_NOFILE, most)
        elif kind == "processes":
            most = random.randint(0, 8)
            before = functools.partial(few_processes, most)
            command += ["-j", "8"] if target.name in ("pack", "f0", "validate", "render") else []
        elif target.path.name in command:
            command[command.index(target.path.name)] = "/dev/full"
        result = run([soak.etak, *command], cwd=target.path.parent, env=soak.environment, before=before)
        result.command = [f"({kind}: {most})", *result.command]
        if result.status == 127 and "shared librar" in result.err:
            continue  # the loader had too little, and etak was not asked
        tally.judge(result, allowed)
        target.check(tally, result)
        tally.no_leftovers(target.path.parent, result)


def racing_writers(soak, tally, deadline):
    """Four at a time to one target, of two inputs; a reader looks at the target all the while."""
    random = soak.random("writers")
    known = [t for t in targets(soak, "writers") if t.name in ("pack", "f0", "export")]
    reads = 0
    while not soak.over(deadline):
        target = random.choice(known)
        ends = []

        def write(command):
            ends.append(run([soak.etak, *command], cwd=target.path.parent, limit=60, env=soak.environment))

        writers = [threading.Thread(target=write, args=(target.commands[i % 2],)) for i in range(4)]
        for each in writers:
            each.start()
        while any(each.is_alive() for each in writers):
            if target.path.is_file():
                reads += 1
                if content(target.path) not in target.contents:
                    tally.fault("mixed", f"a reader of {target.name} saw a part", None)
            time.sleep(0.002)
        for each in writers:
            each.join()
        for result in ends:
            tally.judge(result, (0, 2))
        if not any(result.status == 0 for result in ends):
            tally.fault("exits", "none of four writers ended well", ends[0])
        target.check(tally, ends[0])
        tally.no_leftovers(target.path.parent, ends[0])
    tally.note = f"{tally.runs} writers, {reads:,} reads of a file"


def shrinking_files(soak, tally, deadline):
    """A picture of 6 MB that is cut and written again while it is read, as an exporter does."""
    random = soak.random("shrinking")
    work = soak.folder("shrinking")
    write_manifest(work, random, 1200, 1)
    path = work / "m0_specular.png"
    whole = png(1200, 1200, 4, random, level=0)
    stop = threading.Event()

    def shrink():
        while not stop.is_set():
            with open(path, "r+b") as file:
                file.truncate(random.choice((0, 100, 4096, len(whole) // 2)))
                time.sleep(random.uniform(0, 0.01))
                file.seek(0)
                file.write(whole)
            time.sleep(random.uniform(0, 0.08))

    path.write_bytes(whole)
    thread = threading.Thread(target=shrink)
    thread.start()
    commands = [["validate", ".", "--no-config", "--exit-zero", "-q"],
                ["validate", "m0_specular.png", "--role", "specular", "--no-config", "--exit-zero", "-q"],
                ["pack", "manifest.json", "--out", "../shrinking-atlas", "--report", "none", "--no-validate", "-q"]]
    try:
        while not soak.over(deadline):
            result = run([soak.etak, *random.choice(commands)], cwd=work, env=soak.environment)
            if tally.judge(result) and result.status == 2 and "m0_specular.png" not in result.err + result.out:
                tally.fault("exits", "status 2 does not name the file", result)
            tally.no_leftovers(work.parent, result)
    finally:
        stop.set()
        thread.join()


def watch(soak, tally, deadline):
    """pack --watch while its manifest changes, breaks and is half written; a signal ends it."""
    random = soak.random("watch")
    work = soak.folder("watch")
    source, atlas = work / "in" / "manifest.json", work / "atlas"

    def write(code, whole=True):
        text = '{"materials": [{"name": "a", "specular": "#%02x0000", "gloss": 0.5}]}' % code
        source.write_text(text if whole else text[:random.randrange(len(text))])

    while not soak.over(deadline):
        shutil.rmtree(work, ignore_errors=True)
        source.parent.mkdir(parents=True)
        write(1)
        command = [soak.etak, "pack", "in/manifest.json", "--out", "atlas", "--watch", "--report", "none", "-q"]
        begin = time.monotonic()
        child = subprocess.Popen(command, cwd=work, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, env=soak.environment)
        for _ in range(random.randint(1, 6)):
            write(random.randrange(256), random.random() < 0.6)
            time.sleep(random.uniform(0, 0.3))
        code = random.randrange(2, 256)
        write(code)
        seen, until = False, time.monotonic() + 10
        while not seen and time.monotonic() < until and child.poll() is None:
            layout = atlas / "layout.json"
            seen = layout.exists() and f'"specular_r": {code},' in layout.read_text()
            time.sleep(0.02)
        number = random.choice((signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
        child.send_signal(number)
        try:
            err = child.communicate(timeout=10)[1]
            status = shell_status(child.returncode)
        except subprocess.TimeoutExpired:
            child.kill()
            err, status = child.communicate()[1], None
        result = Result(command, status, "", err.decode("utf-8", "replace"), time.monotonic() - begin)
        if tally.judge(result, (128 + number,)) and not seen:
            tally.fault("mixed", "the last manifest was not packed within 10 s", result, work)
        if leftovers(work):
            tally.no_leftovers(work, result)

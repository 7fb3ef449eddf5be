# SPDX-License-Identifier: Apache-2.0
"""A clock that jumps, and folders and lists of 100,000 files."""
import os
import resource
import shutil
import threading
import time
from pathlib import Path

from inputs import png, write_manifest
from tally import content, run

MANY = 100_000
# A run over so many files may take its time; it must not stop.
MANY_SECONDS = 300
MANY_KIB = 2 << 20


def clock_jumps(soak, tally, deadline):
    """Every form that is written comes out byte for byte the same whatever the clock and the time zone say."""
    library = next((each for each in ("/usr/lib/x86_64-linux-gnu/faketime/libfaketimeMT.so.1",
                                      "/usr/lib/aarch64-linux-gnu/faketime/libfaketimeMT.so.1",
                                      "/usr/lib/faketime/libfaketimeMT.so.1") if os.path.exists(each)), None)
    if library is None:
        tally.note = "skipped: no faketime"
        return
    random, work = soak.random("clock"), soak.folder("clock")
    write_manifest(work / "in", random, 48)
    now = soak.folder("clock-now")
    env = dict(soak.environment, LD_PRELOAD=library, FAKETIME_TIMESTAMP_FILE=str(now), FAKETIME_NO_CACHE="1",
               FAKETIME_DONT_FAKE_MONOTONIC="1", NO_FAKE_STAT="1")
    pack = ["pack", "in/manifest.json", "--out", "out", "--report", "none", "--no-validate", "-q"]
    commands = [(pack + ["--format", each], "out") for each in ("png", "ktx2,dds", "png,tiff", "png,exr")]
    commands += [(["render", "gold", "--size", "32", "--device", "cpu", "-q", "-o", each], each)
                 for each in ("b.png", "b.exr")]
    commands += [(["f0", "--all", "--format", each, "-q", "-o", "f"], "f") for each in ("html", "json")]
    commands += [(["validate", "in", "--no-config", "--exit-zero", "-q", "--format", each, "-o", "v"], "v")
                 for each in ("html", "sarif", "junit", "json")]
    right = {}
    stop = threading.Event()

    def jump():
        while not stop.is_set():
            new = now.with_suffix(".new")
            new.write_text(random.choice(("@1970-01-02 00:00:00", "@2038-01-19 03:14:07", "-20y", "+3h",
                                          "@2099-12-31 23:59:59 x1000", "@2001-09-09 01:46:40")) + "\n")
            new.replace(now)
            time.sleep(random.uniform(0, 0.05))

    thread = threading.Thread(target=jump)
    thread.start()
    try:
        while not soak.over(deadline):
            command, out = random.choice(commands)
            key = tuple(command)
            zone = random.choice(("UTC", "Asia/Kathmandu", "Pacific/Apia", "America/St_Johns"))
            plain = key not in right
            shutil.rmtree(work / out, ignore_errors=True) if (work / out).is_dir() else (work / out).unlink(True)
            result = run([soak.etak, *command], cwd=work, limit=30,
                         env=soak.environment if plain else dict(env, TZ=zone))
            if not tally.judge(result, (0,)):
                continue
            made = content(work / out)
            if plain:
                right[key] = made
            elif made != right[key]:
                names = [n for n in made if made[n] != right[key].get(n)] if isinstance(made, dict) else [out]
                tally.fault("mixed", f"{' '.join(command)} depends on the clock: {names}", result, work)
            tally.no_leftovers(work, result)
    finally:
        stop.set()
        thread.join()


def many_files(soak, tally, deadline):
    """100,000 pictures in a folder, names of a list, and names of nothing."""
    random, work = soak.random("many"), soak.folder("many")
    shutil.rmtree(work, ignore_errors=True)
    folder = work / "textures"
    folder.mkdir(parents=True)
    # Hard links, of which a file system grants some ten thousand to a file.
    sources = []
    for i in range(10):
        sources.append(work / f"source{i}.png")
        sources[-1].write_bytes(png(4, 4, 4, random))
    for i in range(MANY):
        os.link(sources[i % 10], folder / f"m{i:06}_specular_gloss.png")
    material = work / "m.json"
    shutil.copy(soak.corpus / "material" / "nk.json", material)
    (work / "list").write_text(f"{material}\n" * MANY)
    (work / "nothing").write_text("".join(f"none/m{i}.json\n" for i in range(MANY)))
    commands = [["validate", "textures", "--no-config", "--exit-zero", "--format", "json", "--force", "-q",
                 "-o", "v.json"],
                ["f0", "--files-from", "list", "--format", "csv", "--force", "-q", "-o", "f.csv"],
                ["f0", "--files-from", "nothing", "--format", "csv", "--force", "-q", "-o", "n.csv"],
                ["validate", "--files-from", "nothing", "--no-config", "-q"]]
    slowest = 0.0
    for turn, command in enumerate(commands):
        if turn > 0 and soak.over(deadline):
            break
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        result = run([soak.etak, *command], cwd=work, limit=MANY_SECONDS, env=soak.environment)
        # Of all children so far: says something only where this one is the largest.
        after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        slowest = max(slowest, result.seconds)
        tally.judge(result, (0, 1, 2))
        if after > MANY_KIB and before <= MANY_KIB:
            tally.fault("exits", f"took {after >> 10} MiB of memory", result)
        tally.no_leftovers(work, result)
    tally.note = f"{MANY:,} files a run, the longest {slowest:.0f} s"
    shutil.rmtree(work)

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""pre_commit.py ETAK [PAIRS]: what etak takes as a hook of pre-commit, in a repository of many pairs.

Makes a repository of PAIRS pairs of textures (10,000), 100 in a folder, and one with all of them in one folder, commits
them, changes one pair and stages it. Then runs

    pre-commit run         as `git commit` would, with the hook of this source tree
    git commit --dry-run   what git itself takes to see what there is to commit
    etak                   the very command, arguments and folder that pre-commit has started it with, by itself
    reading the pair       the two files, read in a process that does nothing else but start and end

each several times, one after the other, and prints the least and the median of each in milliseconds. Needs git and
pre-commit.
"""
import os
import random
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import time
import zlib

etak = os.path.abspath(sys.argv[1])
pairs = int(sys.argv[2]) if len(sys.argv) > 2 else 10000
source = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
work = tempfile.mkdtemp(prefix="etak-pre-commit-")
chance = random.Random(22)
noise = bytes(chance.randrange(90, 180) for _ in range(1 << 18))


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(texel):
    """A picture of 32 x 32 texels, 4 kB."""
    rows = b"".join(b"\0" + b"".join(texel() for _ in range(32)) for _ in range(32))
    head = struct.pack(">IIBBBBB", 32, 32, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 0)) + chunk(b"IEND", b"")


def write_pair(stem):
    def colour():
        at = chance.randrange(len(noise) - 3)
        return noise[at : at + 3] + b"\xff"

    def mirror():
        grey = 52 + chance.randrange(8)
        return bytes([grey, grey, grey, 100 + chance.randrange(32)])

    for ending, texel in (("diff", colour), ("spec", mirror)):
        with open(f"{stem}_{ending}.png", "wb") as file:
            file.write(png(texel))


def run(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options)


def timed(command, times, **options):
    """The least and the median of so many runs, in milliseconds."""
    out = []
    for _ in range(times):
        begin = time.perf_counter()
        subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, **options)
        out.append(1000 * (time.perf_counter() - begin))
    return min(out), statistics.median(out)


def measure(title, folder_of):
    repository = os.path.join(work, title.replace(" ", "_"))
    os.mkdir(repository)
    run("git", "init", "-q", cwd=repository)
    for name, value in (("user.name", "a"), ("user.email", "a@b"), ("commit.gpgsign", "false")):
        run("git", "config", name, value, cwd=repository)
    for i in range(pairs):
        folder = os.path.join(repository, folder_of(i))
        os.makedirs(folder, exist_ok=True)
        write_pair(os.path.join(folder, f"m{i:05d}"))
    # The hook as the file of this tree declares it, from a repository of its own.
    hooks = os.path.join(work, "hooks")
    if not os.path.isdir(hooks):
        os.mkdir(hooks)
        shutil.copy(os.path.join(source, ".pre-commit-hooks.yaml"), hooks)
        run("git", "init", "-q", cwd=hooks)
        run("git", "add", "-A", cwd=hooks)
        run("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "hooks", cwd=hooks)
    revision = run("git", "rev-parse", "HEAD", cwd=hooks).stdout.strip()
    with open(os.path.join(repository, ".pre-commit-config.yaml"), "w", encoding="utf-8") as file:
        file.write(f"repos:\n  - repo: {hooks}\n    rev: {revision}\n    hooks: [{{id: etak-validate}}]\n")
    run("git", "add", "-A", cwd=repository)
    run("git", "commit", "-qm", "all pairs", cwd=repository)
    write_pair(os.path.join(repository, folder_of(pairs // 2), f"m{pairs // 2:05d}"))
    run("git", "add", "-A", cwd=repository)

    # A program of etak's name that notes how it was called, for the command by itself.
    called = os.path.join(work, "called")
    bin_folder = os.path.join(work, "bin")
    os.makedirs(bin_folder, exist_ok=True)
    with open(os.path.join(bin_folder, "etak"), "w", encoding="utf-8") as file:
        file.write(f'#!/bin/sh\n{{ pwd; printf "%s\\n" "$@"; }} >{called}\nexec {etak} "$@"\n')
    os.chmod(os.path.join(bin_folder, "etak"), 0o755)
    environment = dict(os.environ, PRE_COMMIT_HOME=os.path.join(work, "home"))
    noting = dict(environment, PATH=bin_folder + os.pathsep + environment["PATH"])
    run("pre-commit", "run", cwd=repository, env=noting)
    with open(called, encoding="utf-8") as file:
        folder, *arguments = file.read().splitlines()
    plain = dict(environment, PATH=os.path.dirname(etak) + os.pathsep + environment["PATH"])

    files = [argument for argument in arguments if argument.endswith(".png")]
    rows = {
        "pre-commit run, etak in it": timed(["pre-commit", "run"], 5, cwd=repository, env=plain),
        "git commit --dry-run": timed(["git", "commit", "--dry-run", "-qm", "x"], 5, cwd=repository),
        "etak by itself": timed([etak, *arguments], 30, cwd=folder),
        "reading the pair (cat)": timed(["cat", *files], 30, cwd=folder),
    }
    print(f"{title}: {pairs} pairs, 1 changed; etak {' '.join(arguments)}")
    for name, (least, median) in rows.items():
        print(f"  {name:30s} least {least:8.1f} ms, median {median:8.1f} ms")
    beyond = rows["etak by itself"][0] - rows["reading the pair (cat)"][0]
    print(f"  etak beyond reading            {beyond:14.1f} ms")


try:
    measure("100 pairs in a folder", lambda i: f"textures/{i // 100:03d}")
    measure("all pairs in one folder", lambda i: "textures")
    print("load of the machine: " + " ".join(f"{load:.1f}" for load in os.getloadavg()))
finally:
    shutil.rmtree(work)

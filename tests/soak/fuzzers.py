# SPDX-License-Identifier: Apache-2.0
"""The libFuzzer targets, each for its share of the time, from its seed corpus."""
import concurrent.futures
import re
import subprocess
import time

from tally import Tally

EXECUTED = re.compile(r"stat::number_of_executed_units:\s*(\d+)")
LANES = 2


def fuzz(soak, program, seconds):
    """One target; its row."""
    door = program.name.removeprefix("fuzz_")
    tally = Tally(f"fuzz {door}", soak.finds)
    found, finds = soak.folder(f"corpus-{door}"), soak.finds / f"fuzz-{door}"
    found.mkdir(parents=True, exist_ok=True)
    finds.mkdir(parents=True, exist_ok=True)
    command = [program, f"-max_total_time={seconds}", "-max_len=4096", "-timeout=10", "-rss_limit_mb=3000",
               "-entropic=0", "-print_final_stats=1", f"-seed={soak.seed}", f"-artifact_prefix={finds}/", found,
               soak.corpus / door]
    begin = time.monotonic()
    # As ctest has it: see tests/fuzz/CMakeLists.txt.
    env = dict(soak.environment, ASAN_OPTIONS="malloc_context_size=0:quarantine_size_mb=4")
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=env, check=False)
    text = done.stdout.decode("utf-8", "replace")
    tally.runs = int((EXECUTED.findall(text) or ["0"])[-1])
    tally.note = f"{tally.runs / (time.monotonic() - begin):,.0f} a second"
    if done.returncode != 0:
        (finds / "what.txt").write_text(text[-20000:])
        tally.counts["hangs" if "timeout after" in text else "crashes"] += 1
    if soak.loud:
        print(f"  {tally.name}: {tally.runs:,}, {tally.note}", flush=True)
    return tally


def fuzzers(soak, deadline):
    """Runs every target of the fuzz build, LANES at a time; their rows. The harnesses beside them mostly wait for
    processes and disks, so that two lanes fill two cores."""
    # An old build may hold targets that are no more.
    programs = sorted(each for each in soak.fuzz_folder.glob("fuzz_*") if (soak.corpus / each.name[5:]).is_dir())
    seconds = max(1, int((deadline - time.monotonic()) * LANES / len(programs)))
    with concurrent.futures.ThreadPoolExecutor(LANES) as pool:
        return list(pool.map(lambda program: fuzz(soak, program, seconds), programs))

# SPDX-License-Identifier: Apache-2.0
"""The libFuzzer targets, each for its share of the time and from all that earlier soaks found worth keeping."""
import re
import subprocess
import time

from tally import Tally

SUMMARY = re.compile(r"stat::number_of_executed_units:\s*(\d+)")
DONE = re.compile(r"^#(\d+)\s+DONE", re.MULTILINE)


def fuzzers(soak, deadline):
    """Runs every target of the fuzz build, one after the other; their rows."""
    programs = sorted(soak.fuzz_folder.glob("fuzz_*"))
    tallies = []
    for i, program in enumerate(programs):
        door = program.name.removeprefix("fuzz_")
        tally = Tally(f"fuzz {door}", soak.finds)
        tallies.append(tally)
        share = max(1, int((deadline - time.monotonic()) / (len(programs) - i)))
        found, finds = soak.folder(f"corpus-{door}"), soak.finds / f"fuzz-{door}"
        found.mkdir(parents=True, exist_ok=True)
        finds.mkdir(parents=True, exist_ok=True)
        command = [program, f"-max_total_time={share}", "-max_len=4096", "-timeout=10", "-rss_limit_mb=3000",
                   "-print_final_stats=1", f"-seed={soak.seed}", f"-artifact_prefix={finds}/", found,
                   soak.corpus / door]
        begin = time.monotonic()
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              check=False)
        text = done.stdout.decode("utf-8", "replace")
        counts = [int(each) for each in SUMMARY.findall(text)] or [0]
        tally.runs = counts[-1]
        seconds = time.monotonic() - begin
        tally.note = f"{tally.runs / seconds:,.0f} a second"
        if done.returncode != 0:
            (finds / "what.txt").write_text(text[-20000:])
            tally.counts["hangs" if "timeout after" in text else "crashes"] += 1
        if soak.loud:
            print(f"  {tally.name}: {tally.runs:,} in {seconds:.0f} s", flush=True)
    return tallies

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# slurm.sh ETAK [PAIRS] [SCENES]: a store in shards on a Slurm cluster of four nodes that is made for this test and
# ended with it (slurm_cluster.sh). Pairs are validated and scenes are packed as arrays; in the middle one node is
# killed, and one task runs twice. All results are compared with those of one run, byte by byte; the same plan then
# runs under GNU parallel and ninja. Prints the measured times. Exits with 77 where Slurm is missing or this is not root.
#   ETAK_KEEP=1   leaves the folder of the test there
set -eu
etak=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
pairs=${2:-10000}
scenes=${3:-200}
here=$(cd "$(dirname "$0")" && pwd)
PATH=$(dirname "$etak"):$PATH
export PATH
for program in slurmctld slurmd sbatch munged python3; do
  command -v $program >/dev/null || [ -x /usr/sbin/$program ] || { echo "no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "Slurm's daemons need root"; exit 77; }
PATH=$PATH:/usr/sbin
top=$(mktemp -d /tmp/etak-slurm.XXXXXX)
chmod 755 "$top"  # as munge wants it
cluster=$top/s
finish() {
  "$here/slurm_cluster.sh" stop "$cluster" || :
  sleep 1
  [ -n "${ETAK_KEEP:-}" ] && echo "left in $top" || rm -rf "$top"
}
trap finish EXIT
trap 'exit 1' INT TERM
cd "$top"
failed=0
say() { echo "$@"; }
wrong() { echo "WRONG: $*"; failed=1; }
now() { date +%s.%N; }
since() { awk -v a="$1" -v b="$(now)" 'BEGIN { printf "%.2f", b - a }'; }

python3 "$here/make_assets.py" pairs store "$pairs"
python3 "$here/make_assets.py" scenes scenes "$scenes"
mkdir plans

# One run, in every form that is compared.
for threads in 1 2 4; do
  begin=$(now)
  etak validate store --no-config --format json -o "one-$threads.json" -q -j $threads 2>/dev/null || :
  say "one process, $threads threads: $(since "$begin") s"
done
cmp one-1.json one-4.json || wrong "threads change the result"
mv one-1.json one.json
whole=0
for form in sarif csv; do
  whole=0
  etak validate store --no-config --format $form -o one.$form -q 2>/dev/null || whole=$?
done

# Four shards side by side on this machine, without an engine.
begin=$(now)
pids=
for i in 1 2 3 4; do
  etak validate store --no-config --format json -o local-$i.json -q --shard $i/4 -j 1 2>/dev/null &
  pids="$pids $!"
done
for pid in $pids; do wait "$pid" || :; done
say "four shards side by side, 1 thread each: $(since "$begin") s"
begin=$(now)
etak validate store --no-config --format json -o empty.json -q --shard 1/1000000 -j 1 2>/dev/null || :
say "a shard of nothing (start, names and sizes of all files): $(since "$begin") s"
for form in json sarif csv; do
  begin=$(now)
  etak merge local-?.json --format $form -o merged -q --force 2>/dev/null || :
  say "merge of four shards to $form: $(since "$begin") s"
  cmp merged one.$form || wrong "local shards as $form"
done

ETAK_SLURM_PORT=$((21000 + $$ % 9000)) "$here/slurm_cluster.sh" start "$cluster" 4
. "$cluster/env"
wait_for() { # wait_for JOB SECONDS
  tries=0
  while squeue -h -j "$1" 2>/dev/null | grep -q .; do
    tries=$((tries + 1))
    [ $tries -lt $(($2 * 5)) ] || { wrong "job $1 does not end"; squeue; cat "$cluster"/log/ctld | tail -20; return; }
    sleep 0.2
  done
}

# The overhead of a task: an array of tasks that do nothing.
printf '#!/bin/sh\n' >nothing.sh
begin=$(now)
nothing=$(sbatch --parsable --array=1-16 --output=/dev/null nothing.sh)
wait_for "$nothing" 120
say "16 tasks of nothing on four nodes: $(since "$begin") s"

# The array: 16 tasks, so that there is a middle. Those on the node n2 wait a moment, and it is killed meanwhile.
etak plan --tasks 16 --format slurm -o plans/slurm -q -- validate store --no-config -j 1
sed -i 's/^cd .*/&\n[ "$SLURMD_NODENAME" != n2 ] || sleep 5/' plans/slurm/task.sh
begin=$(now)
merge=$(sh plans/slurm/submit.sh)
array=$((merge - 1))
find_on_n2() { # the processes that n2 has started, which are known by their environment
  on_n2=
  for process in /proc/[0-9]*; do
    { tr '\0' '\n' <"$process/environ"; } 2>/dev/null | awk -v conf="SLURM_CONF=$cluster/slurm.conf" '
      $0 == "SLURMD_NODENAME=n2" { node = 1 } $0 == conf { own = 1 } END { exit !(node && own) }' || continue
    on_n2="$on_n2 ${process#/proc/}"
  done
}
tries=0
on_n2=
until [ -n "$on_n2" ]; do
  tries=$((tries + 1))
  [ $tries -lt 100 ] || { wrong "nothing runs on n2"; break; }
  sleep 0.1
  find_on_n2
done
victim=$(squeue -h -t running -w n2 -j "$array" -o %K)
# The node goes: its daemon, the step and what that has started. The step goes before its script, so that it cannot
# tell Slurm how the script ended.
kill -KILL "$(cat "$cluster/run/n2.pid")"
for process in $on_n2; do
  parent=$(awk '$1 == "PPid:" { print $2 }' "/proc/$process/status" 2>/dev/null || :)
  if [ -n "$parent" ] && grep -q slurmstepd "/proc/$parent/comm" 2>/dev/null; then kill -KILL "$parent" || :; fi
done
for process in $on_n2; do kill -KILL "$process" 2>/dev/null || :; done
[ -n "$victim" ] || wrong "n2 had no task"
scontrol update nodename=n2 state=down reason=killed
# Slurm waits two minutes before it starts the task of a dead node again; the test does not.
scontrol update jobid="${array}_$victim" starttime=now 2>/dev/null || :
say "n2 killed with task ${victim:-?} of 16 on it"
# And one task runs once more, beside the others.
twice=$(sbatch --parsable --array=3 --output=/dev/null plans/slurm/task.sh)
wait_for "$twice" 120
wait_for "$merge" 300
say "16 tasks and the merge under Slurm, a node killed, one task twice: $(since "$begin") s"
scontrol show job "$array" -o 2>/dev/null | grep -o 'ArrayTaskId=[0-9]* .*Restarts=[1-9]' | sed 's/ .*Restarts=/ started again: /' | head -3
[ -e plans/slurm/result.json ] || { wrong "no result"; cat plans/slurm/*.log; squeue; }
cmp plans/slurm/result.json one.json || wrong "Slurm's array as json"
for form in sarif csv; do
  status=0
  etak merge plans/slurm/part-*.json --format $form -o merged -q --force 2>/dev/null || status=$?
  cmp merged one.$form || wrong "Slurm's array as $form"
  [ $status = $whole ] || wrong "status $status as $form, not $whole"
done

# Scenes packed as an array, with the nodes that are left.
cd scenes
begin=$(now)
etak pack --batch jobs.json --no-config --report none -q --batch-report ../jobs-one.json 2>/dev/null || :
say "$scenes scenes packed by one process: $(since "$begin") s"
mv out ../out-one
mkdir out
etak plan --tasks 8 --format slurm -o ../plans/pack -q -- pack --batch jobs.json --no-config -j 1
begin=$(now)
wait_for "$(sh ../plans/pack/submit.sh)" 300
say "$scenes scenes packed by an array of 8 tasks on three nodes: $(since "$begin") s"
cd ..
[ "$(cat plans/pack/part-*.json | grep -c '"out": ')" = "$(grep -c '"out": ' jobs-one.json)" ] || wrong "the reports of the jobs"
diff -r scenes/out out-one >differences || wrong "the atlases: $(head -3 differences)"

# The same run under the other engines.
for engine in parallel ninja; do
  command -v $engine >/dev/null || { say "no $engine"; continue; }
  etak plan --tasks 16 --format $engine -o plans/$engine -q -- validate store --no-config -j 1
  begin=$(now)
  if [ $engine = parallel ]; then sh plans/parallel/run.sh -j 2; else ninja -C plans/ninja -j 2; fi >log 2>&1 || :
  say "16 tasks and the merge under $engine, two at once: $(since "$begin") s"
  cmp plans/$engine/result.json one.json || { wrong "$engine"; tail -5 log; }
done
[ $failed = 0 ] && say "all results are those of one run: $pairs pairs as JSON, SARIF and CSV, $scenes scenes"
exit $failed

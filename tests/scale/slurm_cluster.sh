#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# A throw-away Slurm cluster on this machine: slurmctld and some slurmd on loopback, with files and ports of its own.
# Debian: slurmctld slurmd slurm-client munge; run as root.
#   slurm_cluster.sh start DIR [NODES]   DIR: a short absolute path that does not exist yet
#   slurm_cluster.sh stop DIR            ends the daemons whose process ids lie in DIR, and no others
#   . DIR/env                            then sbatch, squeue and sinfo use the cluster
set -eu
command=$1
dir=$2
nodes=${3:-4}
port=${ETAK_SLURM_PORT:-27400}
host=$(hostname -s)

stop() {
  for pid in "$dir"/run/n*.pid "$dir/run/ctld.pid" "$dir/run/munge.pid"; do
    [ -s "$pid" ] || continue
    kill "$(cat "$pid")" 2>/dev/null || :
  done
}

case $command in
  start)
    mkdir -m 755 "$dir"
    mkdir "$dir/run" "$dir/state" "$dir/log"
    mkdir -m 700 "$dir/key"
    mkdir -m 755 "$dir/sock"
    (umask 077; head -c 128 /dev/urandom >"$dir/key/key")
    munged --key-file="$dir/key/key" --socket="$dir/sock/munge" --pid-file="$dir/run/munge.pid" \
      --log-file="$dir/key/log" --seed-file="$dir/key/seed" --num-threads=2
    {
      cat <<CONF
ClusterName=etak
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/sock/munge
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
InactiveLimit=0
KillWait=2
MinJobAge=300
SlurmctldTimeout=20
SlurmdTimeout=20
StateSaveLocation=$dir/state
SlurmctldPidFile=$dir/run/ctld.pid
SlurmctldLogFile=$dir/log/ctld
SlurmdSpoolDir=$dir/spool.%n
SlurmdPidFile=$dir/run/%n.pid
SlurmdLogFile=$dir/log/%n
CONF
      i=1
      while [ $i -le "$nodes" ]; do
        echo "NodeName=n$i NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + i)) CPUs=1 State=UNKNOWN"
        i=$((i + 1))
      done
      echo "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO"
    } >"$dir/slurm.conf"
    printf 'CgroupAutomount=no\nIgnoreSystemd=yes\n' >"$dir/cgroup.conf"
    echo "export SLURM_CONF=$dir/slurm.conf" >"$dir/env"
    export SLURM_CONF="$dir/slurm.conf"
    slurmctld -c -f "$SLURM_CONF"
    i=1
    while [ $i -le "$nodes" ]; do
      mkdir "$dir/spool.n$i"
      slurmd -f "$SLURM_CONF" -N "n$i" || { cat "$dir/log/n$i"; stop; exit 1; }
      i=$((i + 1))
    done
    tries=0
    while [ "$(sinfo -h -t idle -o %D 2>/dev/null | awk '{ all += $1 } END { print all + 0 }')" != "$nodes" ]; do
      tries=$((tries + 1))
      [ $tries -lt 100 ] || { echo "the nodes do not come up"; cat "$dir"/log/*; stop; exit 1; }
      sleep 0.2
    done
    ;;
  stop) stop ;;
  *) echo "start DIR [NODES] | stop DIR"; exit 2 ;;
esac

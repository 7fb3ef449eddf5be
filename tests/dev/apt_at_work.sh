#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# apt_at_work.sh SOURCE SCRATCH: checks that ./dev waits for another apt that holds the locks, and that other failures
# of apt end it at once. The apt here is made up, and its `install` ends the run.
set -eu
source=$1 scratch=$2
rm -rf "$scratch"
mkdir -p "$scratch/bin"
cp "$source/dev" "$scratch"
for name in dpkg-query sudo sleep; do printf '#!/bin/sh\n' >"$scratch/bin/$name"; done
# env as sudo: the user of the tests need not be root.
printf '#!/bin/sh\nexec "$@"\n' >"$scratch/bin/sudo"
cat >"$scratch/bin/apt-get" <<'SCRIPT'
#!/bin/sh
echo "$*" >>calls
case "$*" in
  update*)
    [ "$(grep -c '^update' calls)" -gt "$LOCKED" ] && exit 0
    echo "E: $FAULT" >&2
    exit 100 ;;
esac
exit 7
SCRIPT
chmod +x "$scratch"/bin/*
try() { # status of ./dev demo
  rm -f "$scratch/calls"
  (cd "$scratch" && PATH=$scratch/bin:$PATH LOCKED=$1 FAULT=$2 ./dev demo >said 2>&1) && status=0 || status=$?
}
try 2 "Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)"
[ "$status $(grep -c '^update' "$scratch/calls")" = "7 3" ] || { echo "did not wait: $status"; cat "$scratch"/{said,calls}; exit 1; }
grep -q 'DPkg::Lock::Timeout=[1-9].* install' "$scratch/calls" || { echo "apt-get does not wait"; cat "$scratch/calls"; exit 1; }
try 9 "Could not resolve 'mirror.example.org'"
[ "$status $(grep -c . "$scratch/calls")" = "1 1" ] || { echo "went on: $status"; cat "$scratch"/{said,calls}; exit 1; }
grep -q 'Could not resolve' "$scratch/said" || { echo "does not say why"; exit 1; }
rm -rf "$scratch"

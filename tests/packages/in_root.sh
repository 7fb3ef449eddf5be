#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Run by ./dev fresh packages in a bare Debian 12, in a folder with the packages, the consumer project and a texture: installs
# the packages with nothing but what they depend on, tries them, and removes them, after which nothing of them may be left.
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
step() { echo "in_root: $*" >&2; }
fail() {
  echo "in_root: $*" >&2
  exit 1
}
# install PACKAGES...: as a user installs what is in an archive, without what is only recommended.
install() { apt-get install -y -qq --no-install-recommends "$@" >>apt.log 2>&1 || { tail -n 30 apt.log; fail "apt-get install $*"; }; }
# files: everything in the root, but for what apt and dpkg write about themselves and caches that they make anew.
files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /root -o -path /var/lib/apt -o -path /var/cache \
    -o -path /var/log -o -path /var/lib/dpkg -o -path /run -o -path /etc/ld.so.cache \) -prune -o -print | LC_ALL=C sort
}
apt-get update -qq

step "dependencies"
for package in etak etak-editor libetak-dev; do
  [ "$(ls "$package"_*.deb | wc -l)" -eq 1 ] || fail "no package $package, or two"
done
programs=$(ls etak_*.deb etak-editor_*.deb python3-etak_*.deb 2>/dev/null || true)
depends() { for deb; do dpkg-deb -f "$deb" Depends; done | tr , '\n' | sed 's/^ *//' | grep -vE '^(lib)?etak( |$)' | sort -u | paste -sd, ; }
satisfy() { apt-get satisfy -y -qq --no-install-recommends "$(depends "$@")" >>apt.log 2>&1 || { tail -n 30 apt.log; fail "no dependencies"; }; }
satisfy $programs
files >before

step "programs"
install $(for deb in $programs; do echo "./$deb"; done)
mkdir -m 700 home
export HOME="$PWD/home" XDG_RUNTIME_DIR="$PWD/home" QT_QPA_PLATFORM=offscreen
etak f0 gold silicon
etak f0 gold | grep -q '#ffe49c' || fail "etak f0 gold"
etak validate crate_spec.png --role f0 && fail "etak validate found nothing" || [ $? -eq 1 ] || fail "etak validate"
etak validate crate_spec.png --role f0 --exit-zero | grep -q ETK101 || fail "etak validate did not find ETK101"
etak render gold --model ggx-f82 -o gold.png
etak-editor --screenshot editor.png gold --model ggx-f82
for picture in gold.png editor.png; do
  [ "$(head -c 8 "$picture" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "$picture is no PNG"
done
[ -e /usr/share/man/man1/etak-f0.1.gz ] || fail "no manual page"
if [ -e "$(ls python3-etak_*.deb 2>/dev/null)" ]; then
  python3 -c "import etak; print(etak.f0('gold'))"
else
  step "there is no python3-etak"
fi

step "removal of the programs"
dpkg --purge $(for deb in $programs; do dpkg-deb -f "$deb" Package; done) >>apt.log 2>&1
files >after
diff before after || fail "the packages leave files behind"

step "library"
satisfy libetak-dev_*.deb
install g++ cmake make pkg-config
files >before
install ./libetak-dev_*.deb
[ -s /usr/share/doc/libetak-dev/html/index.html ] || fail "no reference"
cmake -S consumer/project -B consumer/build >cmake.log 2>&1 && cmake --build consumer/build -j2 >>cmake.log 2>&1 ||
  { tail -n 30 cmake.log; fail "the project does not build with CMake"; }
(cd consumer/build && ./consumer && ./f0 && ./models && ./pack && ./validate && ./render)
consumer/pkg_config.sh g++ "$PWD/pkg_config"

step "removal of the library"
dpkg --purge libetak-dev >>apt.log 2>&1
files >after
diff before after || fail "libetak-dev leaves files behind"
step "passed"

#!/usr/bin/env bash
# try_in_clean_debian.sh FOLDER: installs the packages of the folder with apt in a fresh, minimal Debian of this release,
# runs a program there, builds the vendor's example, a new plugin and the embedding example, and removes the packages.
set -euo pipefail
folder=$(realpath "$1")
# shellcheck source=/dev/null
release=$(. /etc/os-release && echo "$VERSION_CODENAME")

inside() {
  set -eu
  export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
  apt-get update -q >/dev/null
  apt-get install -y -q --no-install-recommends /packages/isogloss_*.deb /packages/isogloss-dialects_*.deb >/dev/null 2>&1
  echo "== the command alone"
  isogloss --version
  cd /tmp
  printf 'G21 G90 G54 G0 X1.\nM30\n' >line.nc
  isogloss run line.nc -d fanuc --format text
  isogloss complete -- run -d fa
  echo "== with the development files"
  apt-get install -y -q --no-install-recommends /packages/*.deb cmake make g++ pkgconf >/dev/null 2>&1
  cp -r /usr/share/doc/isogloss/examples .
  cmake -S examples/vendor -B vendor >/dev/null
  cmake --build vendor | tail -n 1
  isogloss validate vendor/plugins/acme.so | tail -n 1
  isogloss new plugin zack --cycle G182 >/dev/null 2>&1
  zack/ci.sh | grep 'tests passed'
  g++ -std=c++20 examples/embed/main.cpp $(pkg-config --cflags --libs isogloss) -o embed
  ./embed /usr fanuc | tail -n 1
  echo "== removed"
  apt-get purge -y -q isogloss isogloss-dev isogloss-dialects >/dev/null 2>&1
  left=$(find /etc /usr /var -xdev -name '*isogloss*' -not -path '/var/lib/apt/*' -not -path '/var/log/*')
  [ -z "$left" ] || { echo "still there: $left" >&2; exit 1; }
}

script=$(mktemp -d)
trap 'rm -rf "$script"' EXIT
{ declare -f inside && echo inside; } >"$script/try.sh"
# The ways to the archive, such as a proxy, are those of this machine.
mmdebstrap --quiet --variant=apt --format=null \
  --setup-hook='mkdir -p "$1/etc/apt/apt.conf.d" "$1/packages"' \
  --customize-hook='cp -n /etc/apt/apt.conf.d/* "$1/etc/apt/apt.conf.d/"; cp -L /etc/resolv.conf "$1/etc/"' \
  --customize-hook="copy-in $(printf '%s ' "$folder"/*.deb) $script/try.sh /packages" \
  --customize-hook='chroot "$1" bash /packages/try.sh' "$release"

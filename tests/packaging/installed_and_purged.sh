#!/bin/sh
# installed_and_purged.sh PACKAGE.deb, as root of a new Debian 12: installs it with what it recommends, lets somebody
# without rights make a first map, and purges it. Ends with 1 if anything fails or stays.
set -eu
package=$1
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

# Everything but what apt and dpkg keep for themselves.
files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path /var/lib/apt \
    -o -path /var/lib/dpkg -o -path /var/cache -o -path /var/log \) -prune -o -print | sort
}

files >/tmp/before
apt-get update -qq
apt-get install -y -qq --install-recommends "$package" >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
dpkg --verify rubsweep
dpkg -L rubsweep >/tmp/listed
echo "installed: $(wc -l </tmp/listed) files and folders, $(dpkg-query -W -f='${Installed-Size}' rubsweep) KiB"

mkdir /tmp/work
chown 65534:65534 /tmp/work
setpriv --reuid=65534 --regid=65534 --clear-groups env -i PATH=/usr/bin:/bin HOME=/tmp/work LC_ALL=C.UTF-8 \
  sh -c 'cd /tmp/work && sh /tmp/first_map.sh /usr/share/doc/rubsweep/examples "png svg pdf"'

apt-get purge -y -qq rubsweep >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
while read -r one; do
  case $one in
    *rubsweep* | */rub[a-z]*) [ ! -e "$one" ] || { echo "purged, and still there: $one"; exit 1; } ;;
  esac
done </tmp/listed
apt-get autoremove -y -qq --purge >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
files >/tmp/after
if ! diff /tmp/before /tmp/after >/tmp/difference; then
  echo 'left behind by the packages that rubsweep depends on:'
  cat /tmp/difference
  if grep -q 'rub[a-z]' /tmp/difference; then exit 1; fi
fi
if dpkg -l 'rubsweep*' 2>/dev/null | grep -q '^[a-z][a-z] '; then echo 'dpkg still knows rubsweep'; exit 1; fi
echo 'purged'

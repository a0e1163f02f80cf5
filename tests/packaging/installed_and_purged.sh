#!/bin/sh
# installed_and_purged.sh PACKAGE.deb, as root of a new Debian 12: installs it with what it recommends, lets somebody
# without rights make a first map and go through the first ten minutes, and purges it. Ends with 1 if anything fails or
# stays. Leaves /tmp/transcript.txt and /tmp/installed_files.txt, sizes in bytes with names.
set -eu
package=$1
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8

# Everything but what apt and dpkg keep for themselves.
files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path /var/lib/apt \
    -o -path /var/lib/dpkg -o -path /var/cache -o -path /var/log \) -prune -o -print | sort
}

apt-get update -qq
files >/tmp/before
# Beside it what a minimal system lacks: readers of manual pages and of completion, which go with it.
apt-get install -y -qq --install-recommends "$package" man-db bash-completion >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
dpkg --verify rubsweep
dpkg -L rubsweep >/tmp/listed
echo "\$ apt-get install --install-recommends $(basename "$package") man-db bash-completion
installed: $(wc -l </tmp/listed) files and folders, $(dpkg-query -W -f='${Installed-Size}' rubsweep) KiB" | tee /tmp/transcript.txt

xargs -d '\n' stat -c '%F %s %n' </tmp/listed | sed -n 's/^regular file //p' | sort -rn >/tmp/installed_files.txt

# as_somebody DIRECTORY COMMAND: without rights, in a new directory.
as_somebody() {
  mkdir "$1"
  chown 65534:65534 "$1"
  setpriv --reuid=65534 --regid=65534 --clear-groups env -i PATH=/usr/bin:/bin HOME="$1" LC_ALL=C.UTF-8 \
    sh -c "cd $1 && $2"
}
as_somebody /tmp/work 'sh /tmp/first_map.sh /usr/share/doc/rubsweep/examples "png svg pdf"'
as_somebody /tmp/begun 'sh /tmp/first_ten_minutes.sh /tmp' >>/tmp/transcript.txt || { cat /tmp/transcript.txt; exit 1; }

apt-get purge -y -qq rubsweep man-db bash-completion >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
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
echo '
$ apt-get purge rubsweep
purged' | tee -a /tmp/transcript.txt

#!/usr/bin/env bash
# Pipes, links and control characters where files of ours should be: refused or shown, at once, and nothing else is touched.
# Called with the programs that read files besides rubsweep: rubreport, rubbranch, rubsweep-compare, rubtrace, ringstab.
source "$(dirname "$0")/support.sh"
rubreport=$4 rubbranch=$5 compare=$6 rubtrace=$7 ringstab=$8
small=("$minimal" --set 'sweep={speed_hz: {values: [60, 90]}, whirl_ratio: {values: [0.2, 0.5]}}')
expect_exit 0 "${small[@]}" --output whole --quiet

# refuses CODE PROGRAM ARGUMENT...: it ends by itself with this code.
refuses() {
  local code=0
  timeout -k 1 20 "${@:2}" >stdout 2>stderr </dev/null || code=$?
  [[ $code == "$1" ]] || fail "${*:2}: exit code $code, expected $1"
}

# Nobody ever writes into these pipes.
for file in config.yaml map.csv boundaries.csv; do
  rm -rf map && cp -r whole map && rm -f "map/$file" && mkfifo "map/$file"
  refuses 3 "$rubreport" map --quiet
  expect_contains stderr "map/$file"
  expect_contains stderr 'is not a regular file'
done
rm -rf map && cp -r whole map && mkfifo map/families.journal
refuses 3 "$rubbranch" --map map --quiet
mkfifo pipe
refuses 3 "$compare" whole/map.csv pipe
refuses 3 "$compare" whole/map.csv whole/map.csv --sensitive pipe
refuses 3 "$rubsweep" pipe
refuses 3 "$rubtrace" pipe --speed-hz 60 --whirl-ratio 0.2
refuses 3 "$ringstab" pipe
refuses 3 "$rubsweep" /dev/zero
expect_contains stderr 'is not a regular file'
echo 'base: pipe' >based.yaml
refuses 2 "$rubsweep" based.yaml
# A shell's <(...) and standard input are opened by whoever asks, and go on.
"$rubsweep" <(cat "$minimal") --check >stdout
expect_contains stdout ': ok, '
"$rubsweep" /dev/stdin --check <"$minimal" >stdout

# Behind a link is a file of somebody's.
echo precious >precious
for name in map.lock map.begin.lock map.journal map.partial.csv map.rank-2.journal; do
  rm -rf linked && mkdir linked && ln -s ../precious "linked/$name"
  refuses 3 "$rubsweep" "${small[@]}" --output linked
  expect_contains stderr "linked/$name: it is a symbolic link"
  [[ $(<precious) == precious ]] || fail "linked/$name: the file behind it was changed"
done
for name in families.lock families.journal; do
  rm -rf map && cp -r whole map && ln -s ../precious "map/$name"
  refuses 3 "$rubbranch" --map map --quiet
  [[ $(<precious) == precious ]] || fail "map/$name: the file behind it was changed"
done
# Nor is one made where there was none.
rm -rf linked && mkdir linked && ln -s ../made linked/map.journal
refuses 3 "$rubsweep" "${small[@]}" --output linked
expect_missing made

# Control characters of tables and names are shown, those that begin with U+0080 as well.
rm -rf map && cp -r whole map
# Without its checksum, which would say that the table was changed.
sed -i -e '/^# sha256 /d' -e '/^# format /d' -e $'s/non_contact/\e[31mred\xc2\x9b2J/' map/map.csv
name=$'bell\a\e]0;title'
cp -r whole "$name"
rm "$name/config.yaml"
refuses 3 "$rubreport" map --quiet
shown() { ! LC_ALL=C grep -q $'[\x01-\x08\x0b-\x1f\x7f]\|\xc2\x9b' stdout stderr || fail 'a control character reaches the terminal'; }
shown
refuses 3 "$rubreport" "$name"
expect_contains stderr 'bell\x07\x1b]0;title'
shown
refuses 5 "$compare" whole/map.csv map/map.csv
shown
refuses 1 "$rubsweep" "$minimal" $'--\e[2J'
shown
refuses 0 "$rubsweep" "${small[@]}" --output "$name"
expect_contains stdout 'bell\x07'
shown

#!/usr/bin/env bash
# A loss of power at any call loses nothing that was safe, and leaves no files of two machines side by side. Arguments 4 to 7:
# rubtrace, rubline, rubbranch, and the library that records calls.
source "$(dirname "$0")/support.sh"
rubtrace=$4 rubline=$5 rubbranch=$6 recorder=$7
mkdir disk
# The sanitizers' library wants to be loaded before any other.
export ASAN_OPTIONS=verify_asan_link_order=0

# recorded COMMAND...: runs it and keeps its calls in the file record.
recorded() {
  rm -f record
  IO_DIRECTORY=$work/disk IO_RECORD=$work/record LD_PRELOAD=$recorder "$@" >stdout 2>stderr </dev/null || fail "$*: exit code $?"
  [[ -s record ]] || fail "$*: nothing was recorded"
}
# expect_safe KIND BEFORE [COMMAND]...
expect_safe() { python3 -B "$top/tests/apps/power_loss.py" "$1" record "$work/disk" "${@:2}" >stdout 2>stderr || fail "$1"; }

# A map in a directory that is new: the same command ends it, whatever is left.
small=("$minimal" --threads 1 --quiet --output "$work/disk/a/map"
  --set sweep.speed_hz.count=3 --set 'sweep.whirl_ratio={values: [0.3, 0.5]}')
recorded "$rubsweep" "${small[@]}"
cp -r disk first
expect_safe whole - "$rubsweep" "${small[@]}"
expect_matches stdout '^[0-9]+ different disks, 6 cells safe at the end$'

# --fresh in the directory of another map: what is made of the old one is never beside the new one.
rm -rf disk
cp -r first disk
"$rubbranch" --map disk/a/map --quiet --threads 1 || fail 'no families'
cp disk/a/map/families.csv disk/a/map/report.html # which holds the digest as well
cp -r disk before
recorded "$rubsweep" "${small[@]}" --set rotor.mass_kg=0.9 --fresh
expect_files disk/a/map config.yaml map.csv
expect_safe alike before
[[ $(<stdout) == '2 studies, never two at once' ]] || fail 'another number of studies'

# The files of one call, of two programs.
for program in "$rubtrace" "$rubline"; do
  case ${program##*/} in
    rubtrace) call=("$program" "$minimal" --speed-hz 90 --whirl-ratio 0.6 --revolutions 70) ;;
    rubline) call=("$program" "$minimal" --along speed_hz --from 60 --to 90 --count 3 --whirl-ratio 0.4 --threads 1) ;;
  esac
  call+=(--quiet --output "$work/disk/results")
  rm -rf disk before
  mkdir disk
  "${call[@]}" || fail "${program##*/}"
  # Temporary files of a call that was killed go with the next one, which has other files or not.
  touch disk/results/{config.yaml,events.csv,line.csv}.tmp-elsewhere-7 disk/results/mine.tmp-elsewhere-7
  case ${program##*/} in
    rubtrace) own=(config.yaml events.csv motion.csv section.csv spectrum.csv trajectory.csv line.csv.tmp-elsewhere-7) ;;
    rubline) own=(bifurcation.csv cascade.csv config.yaml line.csv events.csv.tmp-elsewhere-7) ;;
  esac
  cp -r disk before
  recorded "${call[@]}" --set rotor.mass_kg=0.9
  expect_files disk/results "${own[@]}" mine.tmp-elsewhere-7
  expect_safe alike before
  [[ $(<stdout) == '2 studies, never two at once' ]] || fail 'another number of studies'
done

#!/usr/bin/env bash
# compare_outputs.sh BEFORE AFTER [--grid SPEEDS UNBALANCES] [--without COLUMN] [--values] [--recordings]
# [CONFIG.yaml...]: what a change of the code's shape must not change. BEFORE and AFTER are build directories, or directories with programs. Runs the programs
# of both on each configuration, by default on those of configs/, its gallery, its benchmark and its hard case: maps
# (rubsweep) and their pages (rubreport), and of the cell at 75 Hz and whirl ratio 0.4 the trace and the run-up through
# rub (rubtrace), a line (rubline), starts (rubbasin) and the branch (rubbranch); ring files (ringstab). Then come
# recordings, where no configuration is named: a set (rubdata), the reading of a kit and of a run-up (rubscope), a ring-down,
# a run-up and a rub fitted (rubfit), a diagnosis (rubdiagnose), two maps compared (rubsweep-compare) and a map drawn
# (rubplot). Compares exit codes, errors and every byte of every file, but for digests, sums and the version. What both
# refuse with the same errors is listed as such. rubbench is left out: it writes times.
#   --grid SPEEDS UNBALANCES  fewer cells of every map, where its axes have a count
#   --without COLUMN          leave this column out of all tables, as one that AFTER has and BEFORE has not
#   --recordings              recordings, too, where configurations are named
#   --values                  for versions that lie apart: only what both have, values of columns, is compared. Comments, new
#                             columns and keys are named; differences of rounding are told from others. Configurations are
#                             read without title, author and note, which older versions do not know. Ends with a count.
# Lists what differs; exits with 5 where something does, with 1 where it is called wrongly.
set -euo pipefail
help() { sed -n '2,/^set /{/^set /d; s/^# \{0,1\}//; p}' "${BASH_SOURCE[0]}"; }
usage() { help >&2; exit 1; }
[[ ${1:-} != --help ]] || { help; exit 0; }
(($# >= 2)) || usage
# programs DIRECTORY: where the programs of a build directory are.
programs() {
  local found
  for found in "$1/apps" "$1"; do
    [[ ! -x $found/rubsweep ]] || { realpath -- "$found"; return; }
  done
  echo "$1: no program rubsweep in it or in $1/apps" >&2
  return 1
}
before=$(programs "$1")
# shellcheck disable=SC2034  # `both` reads it by its name
after=$(programs "$2")
grid=() column='' configs=() values='' recordings=''
shift 2
while (($# > 0)); do
  case $1 in
    --grid)
      [[ ${2:-} =~ ^[1-9][0-9]*$ && ${3:-} =~ ^[1-9][0-9]*$ ]] || usage
      grid=(--set "sweep.speed_hz.count=$2" --set "sweep.whirl_ratio.count=$3")
      shift 3
      ;;
    --without)
      [[ -n ${2:-} ]] || usage
      column=$2
      shift 2
      ;;
    --values)
      values=on
      shift
      ;;
    --recordings)
      recordings=on
      shift
      ;;
    -*) usage ;;
    *)
      configs+=("$(realpath -e -- "$1")")
      shift
      ;;
  esac
done
cd "$(dirname "${BASH_SOURCE[0]}")/.."
((${#configs[@]} > 0)) || recordings=on
((${#configs[@]} > 0)) || configs=("$PWD"/configs/*.yaml "$PWD"/configs/{benchmark,gallery,ring}/*.yaml "$PWD"/configs/hard_case/one_side.yaml)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# drop_column COLUMN TABLE...: takes a column out of tables; those that do not have it stay.
drop_column() {
  python3 - "$@" <<'PYTHON'
import csv
import sys

for path in sys.argv[2:]:
    with open(path, encoding="utf-8", newline="") as file:
        lines = file.read().splitlines()
    first = next((i for i, line in enumerate(lines) if line and not line.startswith("#")), None)
    if first is None or sys.argv[1] not in (names := next(csv.reader([lines[first]]))):
        continue
    at = names.index(sys.argv[1])
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.writelines(line + "\n" for line in lines[:first])
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows(row[:at] + row[at + 1:] for row in csv.reader(lines[first:]))
PYTHON
}

differ=0
declare -A counted=()
# same_values NAME: what both have below before/NAME and after/NAME has the same values.
same_values() {
  local kind answer
  answer=$(PYTHONPATH=$PWD/scripts PYTHONDONTWRITEBYTECODE=1 python3 scripts/analysis/compared_results.py "$work"/{before,after}/"$1")
  kind=${answer%%$'\n'*}
  if [[ $kind == same && ! -d $work/before/$1/files ]]; then
    kind=refused
    answer="refused by both: $(head -n 1 "$work/before/$1/errors")"
  fi
  counted[$kind]=$((${counted[$kind]:-0} + 1))
  sed "1s|^|$1: |; 2,\$s|^|  |" <<<"$answer"
  [[ $kind != different ]] || differ=5
}

# same NAME: every file below before/NAME is there in after/NAME with the same bytes. Copies are compared: what stays
# below before/ and after/ is whole, and other programs read it.
same() {
  local build files
  for build in before after; do
    mkdir -p "$(dirname "$work/compared/$build/$1")"
    cp -r "$work/$build/$1" "$work/compared/$build/$1"
    find "$work/compared/$build/$1" -type f \( -name '*.csv' -o -name '*.yaml' -o -name '*.json' -o -name '*.html' -o -name files \) \
      -exec sed -i -E -e '/^# (digest|sha256|sum|rub[a-z-]+|ringstab) /d; s/[0-9a-f]{64}/DIGEST/g' \
      -e 's/"(rub[a-z-]+|version)": *"[^"]*"/"\1":"VERSION"/g' -e "s|$work/$build/||g" {} +
    # The journal of a set has its recordings in the order in which threads ended them.
    find "$work/compared/$build/$1" -type f -name recordings.journal -delete
    [[ -z $column ]] || find "$work/compared/$build/$1" -type f -name '*.csv' -print0 |
      while IFS= read -r -d '' table; do drop_column "$column" "$table"; done
  done
  if diff -rq "$work/compared/before/$1" "$work/compared/after/$1" >"$work/differences"; then
    files=$(find "$work/before/$1" -type f ! -name exit_code ! -name errors | wc -l)
    if ((files > 0)); then
      echo "$1: $files files, the same"
    else
      echo "$1: refused by both: $(head -n 1 "$work/before/$1/errors")"
    fi
  else
    sed "s|$work/compared/||g" "$work/differences"
    differ=5
  fi
  rm -rf "$work/compared"
}

# both NAME PROGRAM ARGUMENT...: runs it with both builds into NAME. Cells that fail are rows, too. An argument @NAME/FILE
# is what the same build wrote before. OPTION and FILE, where set, are how the program is told where to write, and the
# name of what it writes.
both() {
  local name=$1 program=$2 build code written=$work/${FILE:-now} quiet=--quiet
  shift 2
  [[ $program != rubplot ]] || quiet=''
  for build in before after; do
    [[ -x ${!build}/$program ]] || { echo "$name: there is no ${!build}/$program" >&2; exit 1; }
    code=0
    mkdir -p "$work/$build/$name"
    "${!build}/$program" "${@/#@/$work/$build/}" "${OPTION:---output}" "$written" $quiet >/dev/null 2>"$work/errors" || code=$?
    # Behind Ctrl-C, or a crash of both, nothing was compared.
    ((code < 128)) || { echo "$name: $program of $build ends with $code" >&2; exit "$code"; }
    [[ ! -e $written ]] || mv "$written" "$work/$build/$name/files"
    sed -i "s|$work/$build/|$work/|g" "$work/errors"
    echo "$code" >"$work/$build/$name/exit_code"
    mv "$work/errors" "$work/$build/$name/errors"
  done
  if [[ -n $values ]]; then same_values "$name"; else same "$name"; fi
}

plane=()
if [[ -n $values ]]; then
  # Older versions have another plane where none is named.
  plane=(--plane "x,vx")
  # A configuration may name others beside it: the whole folder is copied.
  cp -r configs "$work/configs"
  find "$work/configs" -name '*.yaml' -exec sed -i -E '/^(title|author|note):/d' {} +
  configs=("${configs[@]/#"$PWD/configs/"/"$work/configs/"}")
fi
for config in "${configs[@]}"; do
  name=${config%.yaml}
  # Folders of configs/ have files of the same name.
  case $name in
    "$PWD"/configs/*) name=${name#"$PWD"/configs/} ;;
    "$work"/configs/*) name=${name#"$work"/configs/} ;;
    *) name=${name##*/} ;;
  esac
  program=rubsweep
  ! grep -q '^ring:' "$config" || program=ringstab
  if ! "$before/$program" --check "$config" >/dev/null 2>&1; then
    echo "$name: the build before does not know this configuration, left out"
    continue
  fi
  if [[ $program == ringstab ]]; then
    both "$name" ringstab "$config"
    continue
  fi
  fewer=("${grid[@]}")
  # A list of values has no count; it is short anyway.
  "$before/rubsweep" --check "$config" "${grid[@]}" >/dev/null 2>&1 || fewer=()
  both "$name" rubsweep "$config" "${fewer[@]}"
  [[ ! -e $work/before/$name/files/map.csv ]] || both "$name.page" rubreport "@$name/files"
  both "$name.trace" rubtrace "$config" --speed-hz 75 --whirl-ratio 0.4 --revolutions 200
  both "$name.run_up" rubtrace "$config" --run-up 20:60:10 --eccentricity-m 2e-4 --with-stops
  both "$name.line" rubline "$config" --along speed_hz --from 60 --to 90 --count 5 --whirl-ratio 0.4 --kick --up --down
  both "$name.basin" rubbasin "$config" --cell 75,0.4 --grid 5x5 "${plane[@]}"
  both "$name.branch" rubbranch "$config" --cell 75,0.4 --points 20
done

# Recordings: what one build simulated is read, fitted and diagnosed by the same build.
compare_recordings() {
  local kit=configs/rotor_kit.yaml jeffcott=configs/reference_machine.yaml
  printf '%s\n' 'time: t_s' 'speed_hz: 70' 'from_s: 1' \
    'probes: [{column: sensor_0_m, angle_deg: 0}, {column: sensor_1_m, angle_deg: 90}]' >"$work/probes.yaml"
  printf '%s\n' 'recordings: 8' 'recordings_per_machine: 2' 'seed: 77' \
    'machine: {mass_kg: 0.8, contact_radius_m: 0.0375}' \
    'measurement: {turns: 16, sampling_rate_hz: 2000, probes: 2}' 'output: {directory: recordings}' >"$work/set.yaml"
  printf 'candidates: [no_rub, one_side, annular]\n' >"$work/candidates.yaml"
  both recordings.set rubdata "$work/set.yaml"
  both recordings.readings rubtrace "$kit" --speed-hz 70 --whirl-ratio 0.6 --last-revolutions 1 --sample-s 1e-3 --noise-m 2e-6
  both recordings.scope rubscope @recordings.readings/files/sensors.csv --instrument "$work/probes.yaml" \
    --compare "$kit" --cell 70,0.6
  both recordings.ring_down rubtrace "$kit" --set rotor.modes=2 --free-response --duration-s 1 --noise-m 1e-6
  both recordings.ramp rubtrace "$kit" --set rotor.modes=2 --run-up 22:40:4 --eccentricity-m 1.2e-5 --sample-s 5e-4 --noise-m 1e-6
  both recordings.fit rubfit "$kit" --set rotor.modes=2 --set rotor.damping_ratio=0.03 --fit rotor.damping_ratio \
    --ring-down @recordings.ring_down/files/sensors.csv --from-s 0.006
  both recordings.rubbing rubtrace "$jeffcott" --speed-hz 70 --whirl-ratio 0.3 --last-revolutions 1 --sample-s 1e-3 --noise-m 2e-6
  both recordings.diagnosis rubdiagnose @recordings.rubbing/files/sensors.csv --instrument "$work/probes.yaml" \
    --machine "$jeffcott" --candidates "$work/candidates.yaml" --motions 60 --table "$work/cases"
  both recordings.two_maps_a rubsweep configs/minimal.yaml
  both recordings.two_maps_b rubsweep configs/minimal.yaml --set kick.force_n=150
  FILE=map.svg both recordings.picture rubplot map @recordings.two_maps_a/files
  OPTION=--cells FILE=cells.csv both recordings.two_maps rubsweep-compare @recordings.two_maps_a/files/map.csv @recordings.two_maps_b/files/map.csv
}
[[ -z $recordings ]] || compare_recordings
for kind in "${!counted[@]}"; do echo "$kind: ${counted[$kind]} results"; done
exit "$differ"

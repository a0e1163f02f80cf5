#!/usr/bin/env bash
# trace.sh TRACE_DIR OUTPUT_BASENAME HEADING [REVOLUTIONS [TRACE_DIR]...]: draws what rubtrace wrote as
# OUTPUT_BASENAME.png and .svg: time history, orbit and full spectrum, one row of panels per trace.
# The history shows the first REVOLUTIONS after the start of the run (default 40), or of what rubtrace --last-revolutions
# left of it, or the last ones where the number is negative. Orbit and section points are those of the end of the run.
set -euo pipefail
export LC_ALL=C.UTF-8
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

(($# >= 3)) || { echo 'trace.sh: usage: trace.sh TRACE_DIR OUTPUT_BASENAME HEADING [REVOLUTIONS [TRACE_DIR]...]' >&2; exit 1; }
# Absolute names: to gnuplot and awk others may be commands or assignments.
output=$(realpath -ms -- "$2") heading=$3 revolutions=${4:-40}
traces=()
for trace in "$1" "${@:5}"; do traces+=("$(realpath -ms -- "$trace")"); done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# require PLACE VALUE PATTERN...: ends the script unless every value is what its pattern says. What stands in a file becomes
# part of arithmetic and of gnuplot's commands below, and must not become anything else there.
number='[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?' whole='(0|[1-9][0-9]*)' word='[a-z_]+'
require() {
  local place=$1
  shift
  while (($# > 0)); do
    [[ $1 =~ ^($2)$ ]] || { echo "trace.sh: $place: '$1' is not allowed there" >&2; exit 3; }
    shift 2
  done
}
require REVOLUTIONS "$revolutions" "-?$whole"

# calculate EXPRESSION: numbers, + - * / and parentheses, cos, sin and atan2.
calculate() {
  local rest=${1//atan2/}
  rest=${rest//cos/}
  require "$directory" "${rest//sin/}" '[-+*/(),.0-9eE ]*'
  awk "BEGIN { printf \"%.17g\", $1 }"
}

# columns FILE NAME... [--between FROM TO]: see csv_columns.awk
columns() {
  local file=$1 from='' to='' names=()
  shift
  while (($#)); do
    if [[ $1 == --between ]]; then from=$2 to=$3; shift 3; else names+=("$1"); shift; fi
  done
  awk -v columns="${names[*]}" -v from="$from" -v to="$to" -f "$here/csv_columns.awk" "$file"
}

has() { [[ -n ${config[$1]+set} ]]; }

# Flat walls as "NORMAL_X NORMAL_Y CLEARANCE" and rings as "CENTRE_X CENTRE_Y CLEARANCE", in mm. Walls that move up and
# down as "COLUMN Y", the column of ROW.history that holds their displacement and where they rest; wall_names has the
# columns of trajectory.csv in that order.
read_stops() {
  local i c offset angle
  walls='' rings='' moving_walls='' wall_names=()
  for ((i = 0; ; ++i)); do
    has "stops.$i.kind" || break
    c=$(calculate "1e3 * ${config[stops.$i.clearance_m]}")
    if [[ ${config[stops.$i.kind]} == annular ]]; then
      # The casing's centre as seen from the rotor's rest position.
      read -ra offset <<<"$(tr -d '[],' <<<"${config[stops.$i.offset_m]:-[0, 0]}" | tr ',' ' ')"
      rings+="$(calculate "-1e3 * ${offset[0]}") $(calculate "-1e3 * ${offset[1]}") $c "
    else
      angle=${config[stops.$i.angle_deg]}
      walls+="$(calculate "cos($angle * atan2(0, -1) / 180)") $(calculate "sin($angle * atan2(0, -1) / 180)") $c "
      if [[ $angle =~ ^-?90$ ]] && has "stops.$i.casing.mass_kg"; then
        wall_names+=("casing_${i}_y_m")
        moving_walls+="$((3 + ${#wall_names[@]})) $(calculate "$angle / 90 * $c") "
      fi
    fi
  done
}

# Title of a row of panels from motion.csv.
title() {
  local name=${class//_/ }
  [[ $class != non_contact ]] || name='no contact'
  [[ -z $order || $order == 1 ]] || name+=" 1/$order"
  [[ $class != synchronous || $orbit != circle ]] || name+=' circle'
  # Ishibashi & Kawai's name for the oval; a whip rolls backward along the wall.
  [[ -z $comb_spacing ]] || name="self-excited whirl (“synchronous oval”), lines at 1 ± k $(printf '%.4g' "$comb_spacing")"
  [[ -z $comb_spacing || $whirl != backward ]] || name="backward dry whip, lines at 1 ± k $(printf '%.4g' "$comb_spacing")"
  # A rotor kit has many natural frequencies, and none in its configuration.
  local ratio=''
  if has rotor.natural_frequency_hz; then
    ratio=$(printf ' = %.3g × natural frequency' "$(calculate "$speed_hz / ${config[rotor.natural_frequency_hz]}")")
  fi
  local unbalance='no clearance left at rest'
  [[ -z $whirl_ratio ]] || unbalance=$(printf 'whirl ratio %.3g' "$whirl_ratio")
  printf '%s: %.4g Hz%s, %s' "$name" "$speed_hz" "$ratio" "$unbalance"
}

# lay_out ROW DIRECTORY: what trace.gp needs of one trace, as files $work/ROW.* and as assignments on stdout.
lay_out() {
  local row=$1 directory=$2 file
  for file in trajectory.csv section.csv spectrum.csv motion.csv config.yaml; do
    [[ -r $directory/$file ]] || { echo "trace.sh: cannot read $directory/$file" >&2; exit 3; }
  done
  declare -A config=()
  local path value
  while IFS='=' read -r path value; do config[$path]=$value; done \
    < <(awk -f "$here/config_values.awk" "$directory/config.yaml")
  local speed_hz whirl_ratio class order orbit whirl comb_spacing kick_s at_rest=0 walls rings moving_walls wall_names
  # What may be empty is read alone.
  read -r speed_hz class <<<"$(columns "$directory/motion.csv" speed_hz class)"
  whirl_ratio=$(columns "$directory/motion.csv" whirl_ratio) whirl=$(columns "$directory/motion.csv" whirl)
  order=$(columns "$directory/motion.csv" order) orbit=$(columns "$directory/motion.csv" orbit)
  comb_spacing=$(columns "$directory/motion.csv" comb_spacing)
  require "$directory/motion.csv" "$speed_hz" "$number" "$whirl_ratio" "($number)?" "$class" "$word" "$order" "($whole)?" \
    "$orbit" "($word)?" "$whirl" "($word)?" "$comb_spacing" "($number)?"
  require "$directory/config.yaml" "${config[response.window_revolutions]}" "$whole" "${config[gravity_m_per_s2]}" "$number" \
    "${config[kick.duration_s]:-0}" "$number"
  # Where the quiet whirl itself reaches the wall, the rotor starts at rest and is not kicked.
  kick_s=${config[kick.duration_s]:-0}
  [[ $(head -n 5 "$directory/motion.csv" | grep '^speed_hz,') != *,start* ||
    $(columns "$directory/motion.csv" start) != contact ]] || kick_s=0 at_rest=1
  read_stops

  local last first from to
  last=$(tail -n 1 "$directory/section.csv" | cut -d, -f1)
  require "$directory/section.csv" "$last" "$whole"
  # The trajectory may begin late.
  first=$(columns "$directory/trajectory.csv" t_s | awk -v speed_hz="$speed_hz" 'NR == 1 { printf "%.0f", $1 * speed_hz }')
  first=${first:-0}
  require "$directory/trajectory.csv" "$first" "$whole"
  from=$first to=$((revolutions < 0 || first + revolutions > last ? last : first + revolutions))
  ((revolutions >= 0)) || from=$((last + revolutions > first ? last + revolutions : first))
  # A periodic orbit closes after `order` revolutions, an oval fills a ring as it turns: eight show how it begins.
  # Anything else shows all that the spectrum was taken of.
  local window=${config[response.window_revolutions]} shown=${order:+$((2 * order))}
  [[ -z $comb_spacing ]] || shown=8
  shown=${shown:-$window}
  local orbit_from=$((last > shown ? last - shown : 0)) section_from=$((last > window ? last - window + 1 : 0))

  columns "$directory/trajectory.csv" t_s x_m y_m "${wall_names[@]}" \
    --between "$(calculate "($from - 1e-6) / $speed_hz")" "$(calculate "$to / $speed_hz")" >"$work/$row.history"
  columns "$directory/trajectory.csv" x_m y_m --between "$(calculate "($orbit_from - 1e-6) / $speed_hz")" '' \
    >"$work/$row.orbit"
  columns "$directory/section.csv" x_m y_m --between "$section_from" '' >"$work/$row.section"
  columns "$directory/spectrum.csv" order amplitude_m --between -8 8 >"$work/$row.spectrum"
  awk -v period="${order:-0}" -v comb_spacing="${comb_spacing:-0}" -f "$here/spectrum_labels.awk" "$work/$row.spectrum" >"$work/$row.labels"
  local start
  start=$(columns "$directory/section.csv" y_m vy_m_per_s --between 0 0)
  require "$directory/section.csv" "$start" "$number $number"

  cat <<ASSIGNMENTS
row_title[$row] = "$(title)"
from[$row] = $from
to[$row] = $to
speed_hz[$row] = $speed_hz
order[$row] = ${order:-0}
kick_s[$row] = $kick_s
at_rest[$row] = $at_rest
moving_walls[$row] = "$moving_walls"
gravity[$row] = ${config[gravity_m_per_s2]}
start_y_m[$row] = ${start% *}
start_vy_m_per_s[$row] = ${start#* }
walls[$row] = "$walls"
rings[$row] = "$rings"
ASSIGNMENTS
}

for array in row_title from to speed_hz order kick_s at_rest moving_walls gravity start_y_m start_vy_m_per_s walls rings; do
  echo "array ${array}[${#traces[@]}]"
done >"$work/rows.gp"
for i in "${!traces[@]}"; do lay_out $((i + 1)) "${traces[i]}"; done >>"$work/rows.gp"

mkdir -p "$(dirname "$output")"
gnuplot -c "$here/trace.gp" "$work" "$output" "$heading" "${#traces[@]}"

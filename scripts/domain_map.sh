#!/usr/bin/env bash
# domain_map.sh MAP.csv OUTPUT_BASENAME HEADING: draws any map.csv over speed and unbalance, as whirl ratio or eccentricity
# as the map was swept, as OUTPUT_BASENAME.png and .svg. Takes natural frequency and the parameters under the heading from
# config.yaml beside the map. A rotor kit has no natural frequency there: its speeds are drawn in Hz, or over the
# frequency given as NATURAL_FREQUENCY_HZ.
set -euo pipefail
export LC_ALL=C.UTF-8
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

(($# == 3)) || { echo 'domain_map.sh: usage: domain_map.sh MAP.csv OUTPUT_BASENAME HEADING' >&2; exit 1; }
# Absolute names: to gnuplot and awk others may be commands or assignments.
map=$(realpath -ms -- "$1") output=$(realpath -ms -- "$2") heading=$3
config_file=$(dirname "$map")/config.yaml
for file in "$map" "$config_file"; do
  [[ -r $file ]] || { echo "domain_map.sh: cannot read $file" >&2; exit 3; }
done

declare -A config
while IFS='=' read -r path value; do config[$path]=$value; done < <(awk -f "$here/config_values.awk" "$config_file")

natural_frequency_hz=${config[rotor.natural_frequency_hz]:-${NATURAL_FREQUENCY_HZ:-}}
speed_label='shaft speed / natural frequency'
[[ -n $natural_frequency_hz ]] || speed_label='shaft speed (Hz)'
measure=whirl_ratio measure_label='whirl ratio (quiet whirl / clearance)'
if [[ -n ${config[sweep.eccentricity_m.values]+set} ]]; then
  measure=eccentricity_m measure_label='eccentricity (m)'
fi

# number PATH [FACTOR]: the value at PATH times FACTOR for people, 2e+06 as 2×10^6 in gnuplot's notation.
number() {
  awk -v value="${config[$1]}" -v factor="${2:-1}" 'BEGIN { printf "%.4g", value * factor }' |
    sed -E 's/e\+?(-?)0*([0-9]+)/×10^{\1\2}/'
}

has() { [[ -n ${config[$1]+set} ]]; }

stop_text() {
  printf 'clearance %s mm' "$(number stops.0.clearance_m 1e3)"
  ! has stops.0.stiffness_n_per_m || printf ', K = %s N/m' "$(number stops.0.stiffness_n_per_m)"
  ! has stops.0.hertz.design_force_n || printf ', Hertz line contact at %s N' "$(number stops.0.hertz.design_force_n)"
  ! has stops.0.restitution || printf ', nominal e = %s' "$(number stops.0.restitution)"
  [[ ${config[stops.0.offset_m]:-[0, 0]} == '[0, 0]' ]] || printf ', offset %s m' "${config[stops.0.offset_m]}"
  ! has stops.0.restitution_delivered || printf ', delivered e = %s' "$(number stops.0.restitution_delivered)"
}

# one_casing STOP
one_casing() {
  has "stops.$1.casing.mass_kg" || { printf 'rigid'; return; }
  printf '%s kg on %s N/m, ζ = %s' "$(number "stops.$1.casing.mass_kg")" \
    "$(number "stops.$1.casing.stiffness_n_per_m")" "$(number "stops.$1.casing.damping_ratio")"
}

# Those of all stops in turn, when they differ.
casing_text() {
  local i differ=
  for ((i = 1; i < 10; ++i)); do
    has "stops.$i.kind" || break
    [[ $(one_casing "$i") == "$(one_casing 0)" ]] || differ=yes
  done
  printf 'casing %s' "$(one_casing 0)"
  [[ -z $differ ]] || for ((i = 1; i < 10; ++i)); do
    ! has "stops.$i.kind" || printf ', and %s' "$(one_casing "$i")"
  done
}

kick_text() {
  has kick.force_n || { printf 'no kick'; return; }
  printf 'kick %s N for %s ms' "$(number kick.force_n)" "$(number kick.duration_s 1e3)"
}

rotor_text() {
  if ! has rotor.natural_frequency_hz; then
    printf 'rotor kit'
    [[ -z $natural_frequency_hz ]] || printf ', identified %.4g Hz' "$natural_frequency_hz"
    return
  fi
  printf 'rotor %s kg, %s Hz, ζ = %s' "$(number rotor.mass_kg)" "$(number rotor.natural_frequency_hz)" \
    "$(number rotor.damping_ratio)"
}

cells=$(mktemp)
trap 'rm -f "$cells"' EXIT
awk -v natural_frequency_hz="$natural_frequency_hz" -v measure="$measure" -f "$here/domain_map.awk" "$map" >"$cells"
present=$(awk 'NF == 7 { print $7 }' "$cells" | sort -u | tr '\n' ' ')

mkdir -p "$(dirname "$output")"
small() { printf '\n{/*0.75 %s}' "$1"; }
gnuplot -c "$here/domain_map.gp" "$cells" "$output" \
  "{/:Bold $heading}$(small "$(rotor_text); $(stop_text)")$(small "$(casing_text); $(kick_text)")" \
  " $present" "$(awk 'NF == 3' "$cells" | tr '\n' ' ')" "$speed_label" "$measure_label"

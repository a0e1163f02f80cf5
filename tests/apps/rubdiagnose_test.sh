#!/usr/bin/env bash
# rubdiagnose: the same bytes from any number of threads and from a kept table, damaged tables are made anew, Ctrl-C leaves an
# answer so far, and what is refused. The first argument is rubdiagnose, the fourth rubdata, which makes the recordings.
source "$(dirname "$0")/support.sh"
data=$4

expect_exit 0 --help
expect_empty stderr
expect_contains stdout 'rubdiagnose RECORDING --machine MACHINE.yaml'
for option in machine candidates instrument motions rounds seed table output threads figure quiet help version; do
  expect_matches stdout "^  (-. \[ )?--$option "
done
expect_exit 0 -h
expect_exit 0 --version
[[ $(head -n 1 stdout) == "rubdiagnose $version" ]] || fail "expected: rubdiagnose $version"

# Two recordings of the rotor of minimal.yaml on one side, and what the probes were.
cat >study.yaml <<'END'
recordings: 6
recordings_per_machine: 6
machine: {mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02, clearance_m: 3.0e-4}
speed_ratio: [1.95, 2.05]
candidates: [{kind: one_side, whirl_ratio: [0.9, 1.5]}]
measurement: {turns: 32, sampling_rate_hz: 5000, noise_share: 2.0e-3}
split: {training: 1, validation: 0, test: 0}
output: {directory: set}
END
"$data" study.yaml --quiet
[[ $(count_rows set/labels.csv 'rubs == 1') -ge 1 ]] || fail 'no recording rubs'
cp "set/$(cells set/labels.csv rubs file | sed -n 's/^1,//p' | head -n 1)" run.csv
cp set/instrument.yaml run.yaml
echo "base: $minimal" >machine.yaml
usual=(run.csv --machine machine.yaml --motions 60)
# Springs alone, whose motions take a third of the time.
cat >springs.yaml <<'END'
candidates:
  - no_rub
  - {kind: one_side, exponent: 1}
  - {kind: two_sides, exponent: 1}
  - {kind: annular, exponent: 1}
  - {kind: annular_offset, exponent: 1}
END
quick=("${usual[@]}" --candidates springs.yaml)
# Where the answer does not matter: two candidates.
echo 'candidates: [no_rub, {kind: one_side, exponent: 1}]' >two.yaml
quickest=(run.csv --machine machine.yaml --motions 50 --candidates two.yaml)
files=(diagnosis.json lines.csv orbits.csv probabilities.csv)

# The answer begins with how sure it is; tables are whole, and the JSON file says the same as they do.
expect_exit 0 "${quick[@]}" --threads 1 --output one
expect_empty stderr
head -n 1 stdout | grep -qE '^(no_rub|one_side|two_sides|annular|annular_offset|none of these), [0-9]+ % \(' ||
  fail 'another first line'
for text in 'recording run.csv: 30 turns at ' 'no interval is known' 'none of these ' 'closest simulated motion' \
  'files     one: '; do
  expect_contains stdout "$text"
done
expect_files one "${files[@]}"
expect_whole_table one/probabilities.csv one/orbits.csv one/lines.csv
python3 - one/diagnosis.json <(cells one/probabilities.csv candidate probability) <<'END' || fail 'another JSON file'
import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    answer = json.load(file)
with open(sys.argv[2], encoding="utf-8") as file:
    table = {name: float(value) for name, value in (line.split(",") for line in file)}
said = {one["name"]: one["probability"] for one in answer["candidates"]}
said["none_of_these"] = answer["none_of_these"]["probability"]
assert sorted(said) == sorted(table) and len(said) == 6, said
assert all(abs(said[name] - table[name]) < 1e-5 for name in said), table
assert abs(sum(said.values()) - 1) < 1e-9, said
assert answer["recording"]["turns"] == 30 and answer["recording"]["probes"] == 2
assert not answer["simulations"]["interrupted"] and answer["simulations"]["motions"] >= 60
for one in answer["candidates"]:
    for number in one["numbers"].values():
        assert set(number) == {"median", "low_95", "high_95"}
END
# A recording that rubs on one side is not said to touch nothing.
[[ $(count_rows one/probabilities.csv "candidate == 'no_rub' and probability < 0.5") == 1 ]] || fail 'no rub is likely'

# The same bytes from the kept table, and from another number of threads with no table.
[[ $(find machine_cases -name '*.cases' | wc -l) == 1 ]] || fail 'no kept table'
kept=$(echo machine_cases/*.cases)
cp "$kept" good.cases
expect_exit 0 "${quick[@]}" --output two --quiet
expect_empty stdout
diff -r one two || fail 'a kept table, other bytes'
expect_exit 0 "${quick[@]}" --output three --threads 2 --table other_table --quiet
diff -r one three || fail 'another number of threads, other bytes'
expect_same good.cases "other_table/${kept##*/}"
# The usual candidates, half of which are no springs, have the same bytes from the shipped list.
expect_exit 0 "${usual[@]}" --output usual --table usual_cases --quiet --threads 1
expect_exit 0 "${usual[@]}" --candidates springs.yaml --output springs --quiet
cmp -s springs/diagnosis.json usual/diagnosis.json && fail 'the usual candidates are springs'
expect_exit 0 "${usual[@]}" --output listed --table usual_cases --candidates "$top/configs/recordings/candidates.yaml" --quiet
[[ $(find usual_cases -name '*.cases' | wc -l) == 1 ]] || fail 'the shipped list is not the usual one'
# The heads of the tables differ: they have the digest of all that was read.
expect_same usual/diagnosis.json listed/diagnosis.json
for table in probabilities orbits lines; do expect_same <(grep -v '^#' usual/$table.csv) <(grep -v '^#' listed/$table.csv); done
rm machine_cases/*.cases

# Without --output and --instrument: beside the recording.
expect_exit 0 "${quickest[@]}" --quiet -j 1
expect_files run_diagnosis "${files[@]}"
kept=$(echo machine_cases/*.cases)
cp "$kept" good.cases
expect_exit 0 "${quickest[@]}" --output seeded --seed 2 --quiet --table seeded_cases
cmp -s run_diagnosis/diagnosis.json seeded/diagnosis.json && fail 'another seed, the same answer'
expect_exit 0 "${quickest[@]}" --quiet -o short --summary json
python3 -c 'import json; s = json.load(open("stdout")); assert s["program"] == "rubdiagnose" and s["exit_code"] == 0 and s["counts"]["motions"] >= 50, s' ||
  fail 'another summary'

# A damaged table is no table: motions are simulated anew, and the table is whole again.
truncate -s -9 "$kept"
expect_exit 0 "${quickest[@]}" --output cut --quiet
diff -r run_diagnosis cut || fail 'a table that breaks off changed the answer'
expect_same good.cases "$kept"
python3 -c 'import sys; b = bytearray(open(sys.argv[1], "rb").read()); b[len(b) // 2] ^= 16; open(sys.argv[1], "wb").write(b)' "$kept"
cmp -s good.cases "$kept" && fail 'no byte was changed'
expect_exit 0 "${quickest[@]}" --output flipped --quiet
diff -r run_diagnosis flipped || fail 'a table with another byte changed the answer'
expect_same good.cases "$kept"
: >"$kept"
expect_exit 0 "${quickest[@]}" --output emptied --quiet
expect_same good.cases "$kept"

# A table that cannot be written is a failure of output.
expect_exit 3 "${quickest[@]}" --output none --table machine.yaml/table --quiet
expect_contains stderr 'machine.yaml/table'
expect_missing none/diagnosis.json

# One probe.
sed '/y_m/d' run.yaml >one_probe.yaml
expect_exit 0 "${quickest[@]}" --instrument one_probe.yaml --output one_probe
expect_contains stdout 'one probe'
[[ $(header_of one_probe/orbits.csv) == turns,x_m,simulated_x_m ]] || fail 'other columns of one probe'

if command -v gnuplot >/dev/null; then
  expect_exit 0 "${quickest[@]}" --output drawn --figure drawn.svg
  expect_contains stdout 'figure    drawn.svg'
  expect_contains drawn.svg 'closest simulated motion'
fi

# A kit that is the same rotor in bending, asked about a stop somewhere along its shaft. Intervals of a fit are used, and the
# list may name places and the unbalance.
mkdir fit
cat >fit/config.yaml <<'END'
rotor:
  kind: rotor_kit
  shaft:
    - {length_m: 0.4, outer_diameter_m: 0.01, youngs_modulus_pa: 2.06e11, shear_modulus_pa: 7.92e10, density_kg_per_m3: 1.0}
  discs:
    - {position_m: 0.2, mass_kg: 0.8, polar_inertia_kg_m2: 5.6e-4, diametral_inertia_kg_m2: 3.2e-4}
  supports:
    - {position_m: 0, stiffness_x_n_per_m: 2.274e4, stiffness_y_n_per_m: 2.274e4}
    - {position_m: 0.4, stiffness_x_n_per_m: 2.274e4, stiffness_y_n_per_m: 2.274e4}
  sensors: [{position_m: 0.2, angle_deg: 0}, {position_m: 0.2, angle_deg: 90}]
  damping_ratio: 0.02
  modes: 1
  elements: 4
stops:
  - {kind: one_side, angle_deg: 0, position_m: 0.2, clearance_m: 3.0e-4, stiffness_n_per_m: 1.0e6, restitution: 0.8,
    contact_radius_m: 0.005}
sweep: {speed_hz: {from: 50, to: 60, count: 2}, whirl_ratio: {values: [0.5]}}
output: {directory: none}
END
cat >places.yaml <<'END'
candidates: [no_rub, {kind: one_side, position_m: [0.1, 0.3], whirl_ratio: [0.8, 1.6], exponent: 1}]
END
kit=(run.csv --machine fit/config.yaml --candidates places.yaml --motions 50)
expect_exit 0 "${kit[@]}" --output kit
expect_contains stdout 'rotor: no intervals are known, 1 % of the natural frequencies'
expect_matches stdout '^  position +0\.[12][0-9]* m, 95 % from 0\.[12]'
[[ $(count_rows kit/probabilities.csv "candidate == 'one_side' and probability > 0.5") == 1 ]] || fail 'no rub of the kit'
cat >fit/parameters.csv <<'END'
parameter,value,standard_error,low_95,high_95,start,at_bound
rotor.damping_ratio,0.02,0.0005,0.019,0.021,0.02,0
eccentricity_m,1.0e-6,1.0e-8,9.8e-7,1.02e-6,1.0e-6,0
END
expect_exit 0 "${kit[@]}" --output known
grep -q 'no intervals are known' stdout && fail 'the fit is not used'
expect_contains stdout 'eccentricity_m: 7.84e-07 to 1.28e-06, the interval of the fit and 25 % on either side'
# So small an unbalance cannot move the rotor as far.
expect_contains stdout 'no simulated motion of these clearances and this unbalance is as large as the recording'
[[ $(count_rows known/probabilities.csv "candidate == 'one_side' and probability < 0.5") == 1 ]] ||
  fail 'the unbalance is not used'
printf 'eccentricity_m: [1.0e-4, 1.0e-3]\n' >>places.yaml
expect_exit 0 "${kit[@]}" --output listed_unbalance --quiet
[[ $(count_rows listed_unbalance/probabilities.csv "candidate == 'one_side' and probability > 0.5") == 1 ]] ||
  fail 'the list does not go before the fit'
printf 'parameter,rotor.damping_ratio,eccentricity_m\n' >fit/correlation.csv
expect_exit 3 "${kit[@]}" --output none
expect_contains stderr 'fit/correlation.csv: ends before the last of the parameters'
rm fit/correlation.csv fit/parameters.csv

# Readings at rest make the mean position count.
sed 's/column: x_m/rest: 0, &/; s/column: y_m/rest: 0, &/' run.yaml >from_rest.yaml
expect_exit 0 "${quickest[@]}" --instrument from_rest.yaml --output from_rest --quiet
cmp -s run_diagnosis/diagnosis.json from_rest/diagnosis.json && fail 'the mean position does not count'

# Ctrl-C gives the answer so far and keeps no table. With job control, background jobs do not ignore SIGINT.
set -m
"$rubsweep" run.csv --machine machine.yaml --motions 100000 --threads 1 --progress always --output stopped \
  --table stopped_cases >stdout 2>stderr </dev/null &
pid=$!
until [[ -s stderr ]]; do
  kill -0 "$pid" 2>/dev/null || fail 'ended before it was interrupted'
  sleep 0.02
done
sleep 1
kill -INT "$pid"
code=0
wait "$pid" || code=$?
set +m
[[ $code == 130 ]] || fail "exit code $code, expected 130"
expect_contains stderr 'rubdiagnose: interrupted; the answer so far is written'
expect_contains stdout 'interrupted: an answer by the motions simulated so far'
expect_files stopped "${files[@]}"
expect_contains stopped/diagnosis.json '"interrupted": true'
expect_matches stopped/diagnosis.json '^ *"standard_error": 0\.'
expect_matches stdout '^  one_side .* \+- [0-9]+ %'
expect_missing stopped_cases

# Nothing is written on bad input.
expect_usage_error 'a recording and its machine are needed' run.csv
expect_usage_error 'a recording and its machine are needed' --machine machine.yaml
expect_usage_error '--motions: 49, allowed: 50 to 100000' run.csv --machine machine.yaml --motions 49
expect_usage_error '--rounds: 51, allowed: 0 to 50' run.csv --machine machine.yaml --rounds 51
expect_usage_error '--seed: -1, allowed: 0 or more' run.csv --machine machine.yaml --seed -1
expect_exit 1 run.csv --machine machine.yaml --motions many
# refuse TEXT ARGUMENT...: a call is refused with this text.
refuse() {
  local text=$1
  shift
  expect_exit 2 "$@" --motions 60 --output none
  expect_contains stderr "$text"
  expect_empty stdout
  expect_missing none
}
# bad_machine LINE: a machine that differs from that of minimal.yaml by this line.
bad_machine() { printf 'base: %s\n%s\n' "$minimal" "$1" >bad.yaml; }
bad_machine 'gravity_m_per_s2: 9.81'
refuse 'bad.yaml: gravity_m_per_s2: is not 0' run.csv --machine bad.yaml
bad_machine 'rotor: {damping_ratio: 0}'
refuse 'bad.yaml: rotor.damping_ratio: is 0' run.csv --machine bad.yaml
# bad_list LINES TEXT: these candidates are refused with this text.
bad_list() {
  printf '%b' "$1" >list.yaml
  refuse "$2" run.csv --machine machine.yaml --candidates list.yaml
}
expect_refused_kit() { # SED TEXT: the kit with this change is refused with this text.
  sed "$1" fit/config.yaml >bad_kit.yaml
  refuse "$2" run.csv --machine bad_kit.yaml
}
expect_refused_kit 's/^  damping_ratio.*/  damping_ratio: 0/' 'bad_kit.yaml: rotor: has no damping'
expect_refused_kit 's/^  sensors.*//' 'bad_kit.yaml: rotor.sensors: is missing'
expect_refused_kit 's/^  modes: 1/  static_loads: [{position_m: 0.2, force_y_n: -3}]/' 'bad_kit.yaml: rotor.static_loads: gives the motion a size'
printf 'candidates: [no_rub, {kind: one_side, position_m: 0.5}]\n' >beyond.yaml
refuse 'beyond.yaml: candidates: position_m of one_side: is beyond the shaft, allowed: 0 to 0.4' run.csv \
  --machine fit/config.yaml --candidates beyond.yaml
refuse 'beyond.yaml: candidates: position_m of one_side: is said of a Jeffcott rotor' run.csv --machine machine.yaml \
  --candidates beyond.yaml
printf 'candidates: [no_rub, {kind: one_side, position_m: 0}]\n' >beyond.yaml
refuse 'beyond.yaml: candidates: position_m of one_side: is said of a Jeffcott rotor' run.csv --machine machine.yaml \
  --candidates beyond.yaml
bad_list 'candidats: [no_rub, annular]\n' "did you mean 'candidates'?"
bad_list 'candidates: [no_rub, {kind: one_side, stifness_n_per_m: 1.0e6}]\n' "did you mean 'stiffness_n_per_m'?"
bad_list 'candidates: [no_rub, anular]\n' "did you mean 'annular'?"
bad_list 'clearance_m: 1.0e-4\nclearance_m: 2.0e-4\n' 'list.yaml:2:1: clearance_m: '
bad_list 'candidates: [annular]\n' 'list.yaml:1:13: candidates: has nothing to choose from'
bad_list 'candidates: [no_rub, annular]\nprior: [1, 0]\n' 'list.yaml:2:8: prior: has a share that is not above 0'

# Too short, of a speed that changes fast, and a run-up.
head -n 700 run.csv >short.csv
refuse 'whole turns, allowed: 12 or more' short.csv --machine machine.yaml --instrument run.yaml
python3 - <<'END'
import math

def write_ramp(name, duration_s, rate_hz_per_s):
    """A quiet whirl from 40 Hz on above its natural frequency of 30 Hz."""
    with open(name, "w", encoding="utf-8") as file:
        file.write("t_s,x_m,y_m,keyphasor_v\n")
        for k in range(int(5000 * duration_s)):
            t = k / 5000
            turns = 40 * t + rate_hz_per_s / 2 * t * t
            angle, radius = 2 * math.pi * turns, 5e-5 / (1 - (30 / (40 + rate_hz_per_s * t)) ** 2)
            mark = -2 if turns % 1 < 0.1 else -12
            file.write(f"{t},{radius * math.cos(angle)},{radius * math.sin(angle)},{mark}\n")


write_ramp("ramp.csv", 1, 20)
write_ramp("slow.csv", 7, 2)
END
refuse 'ramp.csv: the speed changes by 5 % or more in 12 turns' ramp.csv --machine machine.yaml --instrument run.yaml
for threads in 1 2; do
  expect_exit 0 slow.csv "${quickest[@]:1}" --instrument run.yaml --threads $threads --table slow_cases$threads --output slow$threads
  expect_contains stdout 'the speed changes: stretches of 23 turns at '
done
expect_same slow1/diagnosis.json slow2/diagnosis.json
expect_exit 3 missing.csv --machine machine.yaml --instrument run.yaml --output none
expect_exit 3 run.csv --machine missing.yaml --output none

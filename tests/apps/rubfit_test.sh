#!/usr/bin/env bash
# rubfit on experiments that rubtrace made: what it finds and writes, and what it refuses. The first argument is rubfit,
# the fourth rubtrace, the fifth rubscope.
source "$(dirname "$0")/support.sh"
trace=$4
scope=$5

# found PARAMETER FROM TO: the value lies between, and its interval holds a number there.
found() {
  [[ $(count_rows out/parameters.csv "parameter == '$1' and $2 < value < $3") == 1 ]] ||
    fail "$1 is not between $2 and $3: $(<out/parameters.csv)"
}

start=(--set rotor.natural_frequency_hz=31.5 --set rotor.damping_ratio=0.03)
"$trace" "$minimal" --free-response --duration-s 1 --noise-m 5e-6 --output free --quiet
expect_exit 0 "$minimal" "${start[@]}" --ring-down free/sensors.csv --from-s 0.006 --fit rotor.natural_frequency_hz \
  --fit rotor.damping_ratio --fit hit_s=-0.002:0.002 --output out
expect_empty stderr
expect_files out config.yaml correlation.csv fitted.csv parameters.csv
expect_whole_table out/*.csv
found rotor.natural_frequency_hz 29.98 30.02
found rotor.damping_ratio 0.0197 0.0203
expect_contains stdout 'fit       1990 numbers of data, 3 parameters; settled'
# The configuration that was found is one.
expect_exit 0 out/config.yaml --ring-down free/sensors.csv --from-s 0.006 --fit rotor.damping_ratio --output again

"$trace" "$minimal" --run-up 22:40:4 --eccentricity-m 1e-5 --output run_up --quiet
expect_exit 0 "$minimal" "${start[@]}" --ramp run_up/bode.csv --rate-hz-per-s 4 --fit rotor.natural_frequency_hz \
  --fit rotor.damping_ratio --fit eccentricity_m=1e-6:1e-4 --fit mark_deg --compare-without mark_deg --output out
found rotor.natural_frequency_hz 29.99 30.01
found rotor.damping_ratio 0.0199 0.0201
found eccentricity_m 0.99e-5 1.01e-5
expect_contains stdout 'compared  without mark_deg'

# Phases of a table: lags as instruments have them, and the same with a minus from the one mark, are recognised and said;
# what is said is taken. A machine with sensors at 0 and 90 degrees, whose mode follows from its closed form.
python3 -B - <<'END'
import cmath, math
def table(name, phases):
    with open(name, "w") as file:
        file.write("speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg\n")
        for speed in (21, 25, 28, 29, 30, 31, 32, 35, 44):
            r = speed / 30
            a = 2e-5 * r * r / (1 - r * r + 0.04j * r) * cmath.rect(1, math.radians(35))
            x, y = phases(math.degrees(cmath.phase(a)))
            file.write(f"{speed},{abs(a):.9e},{x:.6f},{abs(a):.9e},{y:.6f}\n")
table("lag.csv", lambda phase: (-phase % 360, (90 - phase) % 360))
table("mark.csv", lambda phase: (phase, phase - 90))
table("sensor.csv", lambda phase: (phase, phase))
END
steady=("${start[@]}" --fit rotor.natural_frequency_hz --fit rotor.damping_ratio --fit eccentricity_m=1e-6:1e-4 --fit mark_deg)
for phase in lag mark sensor; do
  for said in '' "--phase $phase"; do
    expect_exit 0 "$minimal" "${steady[@]}" --steady $phase.csv $said --output out
    found rotor.natural_frequency_hz 29.999 30.001
    found eccentricity_m 1.999e-5 2.001e-5
    found mark_deg 34.99 35.01
    expect_contains stdout "(--phase $phase)"
    if [[ $phase == sensor || $said ]]; then
      ! grep -q warning stdout || fail "$phase: $(<stdout)"
    else
      expect_contains stdout "warning   phases are taken as --phase $phase, which leaves"
    fi
  done
done
expect_exit 0 "$minimal" "${steady[@]}" --steady mark.csv --phase sensor --output out
expect_contains stdout '% of mark.csv are left over: not the right minimum (--starts), bounds, phases (--phase) or machine'
expect_usage_error '--phase late: allowed: lag, mark, sensor' "$minimal" "${steady[@]}" --steady lag.csv --phase late
expect_usage_error '--phase: is of tables' "$minimal" --ring-down free/sensors.csv --fit rotor.damping_ratio --phase lag

# A figure; one that cannot be drawn is said before the fit.
if command -v gnuplot >/dev/null; then
  expect_exit 0 "$minimal" --ramp run_up/bode.csv --rate-hz-per-s 4 --fit rotor.damping_ratio --eccentricity-m 1e-5 \
    --output out --figure pictures/fit.svg
  expect_contains stdout 'figure    pictures/fit.svg'
  for text in minimal.yaml '1X on a ramp' 'rotor.damping_ratio = 0.0' '</svg>'; do expect_contains pictures/fit.svg "$text"; done
fi
expect_usage_error '--figure: allowed: a name that ends with .png, .svg or .pdf' "$minimal" --ramp run_up/bode.csv \
  --rate-hz-per-s 4 --fit rotor.damping_ratio --eccentricity-m 1e-5 --figure fit.gif

# A number that the data do not tell, since nothing turns in a ring-down.
expect_exit 0 "$minimal" --ring-down free/sensors.csv --from-s 0.006 --fit rotor.damping_ratio --fit rotor.mass_kg --output out
expect_contains stdout 'the data do not tell rotor.mass_kg'

# A rub, simulated, recorded as by an instrument, analysed, and fitted. The shaft begins with its quiet whirl at the wall,
# 90 degrees and the lag of the response ahead; the keyway passes 50 degrees later.
"$trace" "$minimal" --speed-hz 70 --whirl-ratio 0.2 --revolutions 300 --sample-s 2e-4 --noise-m 2e-6 --output rub --quiet
PYTHONPATH=$top/scripts python3 -B "$top/scripts/analysis/as_recorded.py" rub/sensors.csv rub.csv --speed-hz 70 --mark-deg 50
echo 'from_s: 2' >>rub.yaml
"$scope" rub.csv --output rub_seen --quiet
rub=(--rub rub_seen --fit stops.0.clearance_m --fit eccentricity_m=5e-5:1.5e-4:1e-3 --fit mark_deg)
expect_exit 0 "$minimal" --set stops.0.clearance_m=1.03e-3 "${rub[@]}" --output out
found stops.0.clearance_m 0.9995e-3 1.0005e-3
found eccentricity_m 1.632e-4 1.634e-4
found mark_deg -41.3 -41.0
expect_contains out/fitted.csv ',rub,0,real,'
# The same bytes again, whichever of the two threads was first.
expect_exit 0 "$minimal" --set stops.0.clearance_m=1.03e-3 "${rub[@]}" --output same
expect_same out/parameters.csv same/parameters.csv
# The exponent of a contact that is no spring.
curved=(--set 'stops.0.law={kind: power, stiffness_n_per_m_n: 2.83e8, exponent: 1.5, damping: delivered, restitution: 0.7,
  approach_speed_m_per_s: 0.2}')
"$trace" "$minimal" "${curved[@]}" --speed-hz 70 --whirl-ratio 0.2 --revolutions 300 --sample-s 2e-4 --noise-m 2e-6 \
  --output curved --quiet
PYTHONPATH=$top/scripts python3 -B "$top/scripts/analysis/as_recorded.py" curved/sensors.csv curved.csv --speed-hz 70 \
  --mark-deg 50
echo 'from_s: 2' >>curved.yaml
"$scope" curved.csv --output curved_seen --quiet
expect_exit 0 "$minimal" "${curved[@]}" --set stops.0.law.exponent=1.45 --rub curved_seen --fit stops.0.law.exponent \
  --fit mark_deg --eccentricity-m 1.633e-4 --output out
found stops.0.law.exponent 1.499 1.501
# A machine that does not rub, a recording that is no rub that repeats, and no recording.
expect_exit 2 "$minimal" --set kick.force_n=1 "${rub[@]}" --output none
expect_contains stderr 'allowed: one in contact that repeats after 2 turns as the recorded one'
expect_missing none
sed -i 's/^period_turns,2,/period_turns,2.5,/' rub_seen/measures.csv
reseal rub_seen/measures.csv
expect_exit 2 "$minimal" "${rub[@]}" --output none
expect_contains stderr 'rub_seen/measures.csv: period_turns: is 2.5, allowed: a whole number from 1 to 64'
expect_exit 3 "$minimal" --rub nowhere --fit stops.0.clearance_m --eccentricity-m 1e-4 --output none
expect_contains stderr 'nowhere/measures.csv'
expect_missing none

# Speeds that change unevenly have no one rate.
"$trace" "$minimal" --run-up 22:40:4 --eccentricity-m 1e-5 --sample-s 5e-4 --output uneven --quiet
awk -F, '/^t_s/ { print "t_s,speed_hz,order,x_amplitude_m,x_phase_deg"; next } !/^#/ && ++n % 200 == 1 {
  speed = n < 4000 ? 22 + n / 1000 : 26 + (n - 4000) / 200; print $1 "," speed ",1,1e-6,0" }' uneven/sensors.csv >uneven.csv
expect_exit 2 "$minimal" --run-up uneven.csv --fit rate_hz_per_s=1:4:8 --eccentricity-m 1e-5 --output none
expect_contains stderr 'uneven.csv: has a speed that changes unevenly, allowed with rate_hz_per_s: one that changes evenly'
expect_missing none

expect_usage_error '--fit rotor.damping: is no number of the configuration' "$minimal" --ring-down free/sensors.csv \
  --fit rotor.damping
expect_usage_error '--fit: a number to be found is needed' "$minimal" --ring-down free/sensors.csv
expect_usage_error 'data are needed' "$minimal" --fit rotor.damping_ratio
expect_usage_error '--fit eccentricity_m: begins at 0' "$minimal" --ramp run_up/bode.csv --rate-hz-per-s 4 --fit eccentricity_m
expect_usage_error '--fit hit_s=2:1: allowed' "$minimal" --ring-down free/sensors.csv --fit hit_s=2:1
sed '20s/,[^,]*$/,x/' free/sensors.csv >broken.csv
expect_exit 3 "$minimal" --ring-down broken.csv --fit rotor.damping_ratio --output none
expect_contains stderr 'broken.csv: is not as it was written'
sed -i '/^# format\|^# sha256/d' broken.csv  # changed on purpose
expect_exit 3 "$minimal" --ring-down broken.csv --fit rotor.damping_ratio --output none
expect_contains stderr 'broken.csv:18'
expect_missing none

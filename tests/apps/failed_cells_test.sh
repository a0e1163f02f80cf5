#!/usr/bin/env bash
# Cells that fail are rows like any other; the program ends with 4.
source "$(dirname "$0")/support.sh"

# 1000 steps are too few for a turn at this tolerance, with a kick or, above a whirl ratio of 1, without one. A rotor that
# static forces press on its wall has no whirl ratio, and nothing to integrate.
few_steps=(--set solver.method=adaptive --set solver.max_steps_per_revolution=1000 --set solver.relative_tolerance=1e-13
  --set 'sweep={speed_hz: {values: [70, 130]}, whirl_ratio: {values: [0.2, 1.2]}}')

expect_exit 4 "$minimal" "${few_steps[@]}" --output out
expect_empty stderr
expect_matches stdout '^ +4 +100\.0 %  failed$'
expect_matches stdout '^ +4  status step_limit$'
expect_files out config.yaml map.csv
expect_whole_rows out/map.csv
# Nothing was measured in any of them.
cells out/map.csv speed_hz whirl_ratio class order orbit whirl proof robust comb_spacing hits_per_revolution contact_fraction \
  peak_displacement_m peak_contact_force_n amplitude_1x_forward_m amplitude_1x_backward_m dominant_order dominant_amplitude_m \
  floquet_modulus lyapunov_per_revolution status start >found
diff - found <<'CSV' || fail 'the rows differ'
70,0.2,failed,,,,,,,,,,,,,,,,,step_limit,kick
130,0.2,failed,,,,,,,,,,,,,,,,,step_limit,kick
70,1.2,failed,,,,,,,,,,,,,,,,,step_limit,contact
130,1.2,failed,,,,,,,,,,,,,,,,,step_limit,contact
CSV

expect_exit 0 "$minimal" --set gravity_m_per_s2=99 --set stops.0.angle_deg=-90 --output pressed \
  --set 'sweep={speed_hz: {values: [70]}, whirl_ratio: {values: [0.2]}}'
expect_matches stdout '^ +1 +100\.0 %  initial_contact$'
[[ $(cells pressed/map.csv class status start) == initial_contact,ok, ]] || fail 'another row where the rotor lies on its wall'

expect_exit 4 "$minimal" "${few_steps[@]}" --quiet --output quiet
expect_empty stdout
expect_empty stderr
expect_same quiet/map.csv out/map.csv

# The same cells with as many steps as they need.
expect_exit 0 "$minimal" "${few_steps[@]}" --set solver.max_steps_per_revolution=1e6 \
  --set solver.relative_tolerance=1e-8 --output enough
[[ $(cells enough/map.csv status | sort -u) == ok ]] || fail 'a cell is not ok'

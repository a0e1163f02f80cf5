#!/usr/bin/env bash
# rubplot draws any map: over whirl ratio or eccentricity, over the natural frequency or,
# of a rotor kit, in Hz. Skipped without gnuplot.
source "$(dirname "$0")/support.sh"
command -v gnuplot >/dev/null || { echo 'skipped: there is no gnuplot'; exit 77; }
touch stdout stderr

# draw EXPECTED_EXIT_CODE ARGUMENT...: a map.
draw() {
  local code=0
  rubplot map "${@:2}" >stdout 2>stderr || code=$?
  [[ $code == "$1" ]] || fail "rubplot map ${*:2}: exit code $code, expected $1"
}

# Above a whirl ratio of 1, where the rotor starts without a kick.
expect_exit 0 "$minimal" --quiet --output ratio --set 'sweep={speed_hz: {values: [60, 75, 90]}, whirl_ratio: {values: [0.4, 0.8, 1.2]}}'
draw 0 ratio/map.csv --output out/ratio
expect_empty stderr
for text in 'whirl ratio (quiet whirl / clearance)' 'shaft speed / natural frequency'; do expect_contains out/ratio.svg "$text"; done
! grep -q 'pressed on the wall' out/ratio.svg || fail 'cells above 1 are not drawn'
[[ -s out/ratio.png ]] || fail 'there is no out/ratio.png'

expect_exit 0 "$minimal" --quiet --output eccentricity \
  --set 'sweep={speed_hz: {values: [60, 75, 90]}, eccentricity_m: {values: [2e-4, 4e-4, 6e-4]}}'
draw 0 eccentricity --output out/eccentricity
expect_empty stderr
expect_contains out/eccentricity.svg 'eccentricity (m)'
! grep -q 'whirl ratio' out/eccentricity.svg || fail 'an eccentricity is called a whirl ratio'

# A kit has no natural frequency in its configuration.
expect_exit 0 "$top/configs/rotor_kit.yaml" --quiet --output kit --set response.max_revolutions=128 --set kick.force_n=1 \
  --set 'sweep={speed_hz: {values: [50, 60]}, whirl_ratio: {values: [0.1, 0.2]}}'
draw 0 kit/map.csv --output out/kit
expect_empty stderr
expect_contains out/kit.svg 'shaft speed (Hz)'
draw 0 kit --output out/kit --natural-frequency-hz 30
expect_contains out/kit.svg 'shaft speed / natural frequency'

# rubsweep draws it itself, of a map that it makes or finds.
expect_exit 0 "$minimal" --output ratio --figure pictures/own.svg --fresh \
  --set 'sweep={speed_hz: {values: [60, 75, 90]}, whirl_ratio: {values: [0.4, 0.8, 1.2]}}'
expect_contains stdout 'figure: pictures/own.svg'
expect_contains pictures/own.svg 'Rub domains after a kick'
draw 0 ratio --output out/own.svg
expect_same out/own.svg pictures/own.svg
expect_exit 1 "$minimal" --shard 1/2 --figure x.png
expect_contains stderr '--figure needs the whole map'
expect_exit 1 "$minimal" --figure x.gif
expect_contains stderr '--figure: allowed: a name that ends with .png, .svg or .pdf'
expect_exit 0 "$minimal" --output ratio --figure pictures/own.pdf \
  --set 'sweep={speed_hz: {values: [60, 75, 90]}, whirl_ratio: {values: [0.4, 0.8, 1.2]}}'
[[ $(head -c 5 pictures/own.pdf) == %PDF- ]] || fail 'no document'

# Cells fade by the share of neighbouring kicks that lead to the same motion, where the map has it.
share=(--set response.robustness=probability --set 'sweep={speed_hz: {values: [60, 75, 90]}, whirl_ratio: {values: [0.4, 0.8, 1.2]}}')
expect_exit 2 "$minimal" --output faded --figure faded.svg --fade
expect_contains stderr '--fade: the map has no column robust_share, allowed: with response.robustness probability'
expect_missing faded
expect_exit 1 "$minimal" --fade
expect_contains stderr '--fade belongs to --figure'
expect_exit 0 "$minimal" "${share[@]}" --output faded --figure faded.svg --fade
expect_contains faded.svg 'fainter: fewer of the neighbouring'
draw 0 faded --fade --output out/faded
expect_same out/faded.svg faded.svg
draw 0 faded --output out/plain
! grep -q fainter out/plain.svg || fail 'cells fade without being asked'
draw 3 ratio --output out/none --fade
expect_contains stderr 'has no column robust_share: response.robustness is not probability'

# A whip and an oval, circles forward and backward: each has its own colour and name.
mkdir motions
cp ratio/config.yaml motions
{
  echo speed_hz,whirl_ratio,class,order,kind
  row() { (IFS=, && echo "$*"); }
  row 60 0.2 quasi_periodic '' quasi_periodic_oval
  row 75 0.2 quasi_periodic '' quasi_periodic_whip
  row 90 0.2 quasi_periodic '' quasi_periodic
  row 60 0.4 synchronous 1 synchronous_circle
  row 75 0.4 synchronous 1 synchronous_circle_backward
  row 90 0.4 synchronous 1 synchronous
} >motions/map.csv
draw 0 motions --output out/motions
for text in 'quasi-periodic oval' 'backward dry whip' '>quasi-periodic<' '>synchronous circle<' 'backward circle' '>synchronous<'; do
  expect_contains out/motions.svg "$text"
done

#!/usr/bin/env bash
# rubdata: the same bytes from any number of threads and after an interruption, the same numbers in MATLAB files,
# recordings that rubscope reads, and what it refuses. The first argument is rubdata, the fourth rubscope,
# the fifth rubsweep.
source "$(dirname "$0")/support.sh"
scope=$4 sweep=$5
config=$top/configs/recordings/rub_recordings.yaml

expect_exit 0 --help
expect_contains stdout 'rubdata STUDY.yaml'
expect_exit 0 "$config" --check
[[ $(<stdout) == "$config: ok, 500 recordings" ]] || fail 'another answer to --check'
expect_exit 0 "$config" --check --quiet
expect_empty stdout
expect_missing results

sed -e 's/^recordings: .*/recordings: 15/' -e 's/^recordings_per_machine: .*/recordings_per_machine: 3/' "$config" >study.yaml
expect_exit 0 study.yaml --output one --threads 1
expect_empty stderr
expect_contains stdout '15 recordings: one'
expect_exit 0 study.yaml --output two --threads 2 --quiet
expect_empty stdout
diff -r --exclude=recordings.journal one two || fail 'another number of threads, other bytes'
for file in README.md labels.csv instrument.yaml; do [[ -s one/$file ]] || fail "no $file"; done
[[ $(find one -name '0000*.csv' | wc -l) == 15 ]] || fail 'another number of recordings'
[[ $(sed '/^# sha256 /d' one/labels.csv | sha256sum | cut -d' ' -f1) == "$(sed -n 's/^# sha256 //p' one/labels.csv)" ]] ||
  fail 'labels.csv has another checksum'

# Three recordings of each machine, all in one part of the set.
[[ $(count_rows one/labels.csv 'machine == 0') == 3 ]] || fail 'recordings of a machine'
for machine in 0 1 2 3 4; do
  parts=0
  for part in training validation test; do
    [[ $(count_rows one/labels.csv "machine == $machine and split == '$part'") == 0 ]] || ((parts += 1))
  done
  [[ $parts == 1 ]] || fail "machine $machine is in $parts parts"
done
[[ $(count_rows one/labels.csv "cause == 'no_rub' and rubs == 1") == 0 ]] || fail 'a machine without a stop rubs'

# An interrupted set goes on: a file that is gone, and a journal that breaks off, are made good.
cp -r one three
head -n -4 one/recordings.journal >three/recordings.journal
rm three/labels.csv "three/$(cd one && find . -name '000002.csv')"
expect_exit 0 study.yaml --output three --quiet
diff -r --exclude=recordings.journal one three || fail 'other bytes after an interruption'

# Ctrl-C keeps what is finished, and the same command goes on. With job control, background jobs do not ignore SIGINT.
set -m
sed 's/^recordings: .*/recordings: 60/' study.yaml >long.yaml
"$rubsweep" long.yaml --output long --threads 1 >stdout 2>stderr </dev/null &
pid=$!
until [[ -n $(find long -name '*.csv' 2>/dev/null | head -n 1) ]]; do
  kill -0 "$pid" 2>/dev/null || fail 'ended without a recording'
  sleep 0.02
done
kill -INT "$pid"
code=0
wait "$pid" || code=$?
set +m
[[ $code == 130 ]] || fail "exit code $code, expected 130"
[[ $(<stderr) == 'rubdata: interrupted; finished recordings are kept, the same command goes on' ]] || fail 'another message'
expect_missing long/labels.csv
kept=$(find long -name '*.csv' | wc -l)
((kept >= 1 && kept < 60)) || fail "$kept recordings after Ctrl-C"
expect_exit 0 long.yaml --output long --quiet
[[ $(find long -name '0000*.csv' | wc -l) == 60 ]] || fail 'another number of recordings'
# The first 15 are those of the shorter set.
for file in $(cd one && find . -name '0000*.csv'); do expect_same "one/$file" "long/$file"; done

# rubscope reads every recording with the description of the set, and finds the speed of its label.
while IFS=, read -r file speed; do
  "$scope" "one/$file" --instrument one/instrument.yaml --output seen --quiet
  [[ $(count_rows seen/measures.csv "quantity == 'speed_hz' and abs(value / $speed - 1) < 1e-3") == 1 ]] ||
    fail "$file has another speed than $speed Hz: $(<seen/measures.csv)"
done < <(cells one/labels.csv file speed_hz | tail -n +2)

# Recordings without a rub may vibrate from another cause, whatever the threads; those of rubs stay as they are.
sed 's/^other_causes_share: .*/other_causes_share: 1/' study.yaml >others.yaml
expect_exit 0 others.yaml --output others --quiet
expect_exit 0 others.yaml --output others_of_one --quiet --threads 1
diff -r --exclude=recordings.journal others others_of_one || fail 'other causes of other bytes'
[[ $(count_rows others/labels.csv "(cause == 'no_rub') == (other_cause != '')") == $(count_rows others/labels.csv 'recording >= 0') ]] ||
  fail 'other causes stand beside a rub, or are missing'
expect_same <(cells one/labels.csv cause sha256 | grep -v no_rub) <(cells others/labels.csv cause sha256 | grep -v no_rub)
[[ $(count_rows one/labels.csv "other_cause != ''") == 0 ]] || fail 'another cause that the study does not ask for'

# MATLAB files have the same numbers: labels agree but for the names of the files, and so does what rubscope reads, up to
# the digits of a table.
sed 's/^format: csv/format: matlab/' study.yaml >matlab.yaml
expect_exit 0 matlab.yaml --output four --quiet
expect_exit 0 matlab.yaml --output five --quiet --threads 1
diff -r --exclude=recordings.journal four five || fail 'MATLAB files of other bytes'
# The last column but three is the sum of the file.
expect_same <(grep -v '^#' one/labels.csv | sed 's/,[^,]*\(,[^,]*,[^,]*,[^,]*\)$/\1/') \
  <(grep -v '^#' four/labels.csv | sed -e 's/[.]mat,/.csv,/' -e 's/,[^,]*\(,[^,]*,[^,]*,[^,]*\)$/\1/')
file=$(cells one/labels.csv file | tail -n 1)
"$scope" "four/${file%.csv}.mat" --instrument four/instrument.yaml --output seen_matlab --quiet
expect_same <(cells seen/measures.csv quantity) <(cells seen_matlab/measures.csv quantity)
# The table rounds its readings to seven digits, which is next to nothing of the motion and more of the noise of a line.
paste -d, <(cells seen/measures.csv quantity) <(cells seen/measures.csv value) <(cells seen_matlab/measures.csv value) | awk -F, '
  $1 == "line_noise_m" { noise = $2; room = ($2 - $3) ^ 2; next }
  $1 == "peak_to_peak_x_m" && room > (1e-8 * $2) ^ 2 { print "noise differs: " noise; bad = 1 }
  NR > 1 && $2 != $3 && ($2 - $3) ^ 2 > (1e-5 * $2) ^ 2 { print "measures differ: " $0; bad = 1 }
  END { if (!noise) print "no noise"; exit bad || !noise }' ||
  fail 'rubscope reads other numbers'

# Nothing is written on bad input, and a directory of another study is left alone.
# refuse SED_SCRIPT TEXT: the study with this change is refused with this text.
refuse() {
  sed "$1" study.yaml >bad.yaml
  expect_exit 2 bad.yaml --output none
  expect_contains stderr "$2"
  expect_missing none
}
refuse 's/noise_share: .*/noise_share: [0, 1.0e-2]/' 'bad.yaml:33:16: measurement.noise_share: '
refuse 's/offset_ratio/ofset_ratio/' "did you mean 'offset_ratio'?"
refuse 's/sampling_rate_hz: 5000/sampling_rate_hz: 500/' 'reads fewer than 5 times in a turn'
refuse 's/kind: two_sides/kind: two_sides\n    name: "two\\nlines"/' 'candidates.2.name: is no name, allowed: one line of text'
sed 's/^seed: 1/seed: 2/' study.yaml >other.yaml
expect_exit 2 other.yaml --output one
expect_contains stderr 'one: holds a data set of another study or build of the program'
diff -r --exclude=recordings.journal one two || fail 'a refused study changed the set'
expect_usage_error 'a configuration file is needed: rubdata CONFIG.yaml'
expect_usage_error '--output: allowed: the name of a directory' study.yaml --output ''

# A set is whole as its labels say; a recording that is not as it was written is made again, with the same bytes.
"$sweep" --verify one >stdout || fail 'the set is not whole'
expect_contains stdout 'one: whole: labels.csv README.md instrument.yaml 15 recordings'
cp -r one damaged
file=damaged/$(cells one/labels.csv file | tail -n 1)
truncate -s -60 "$file"
"$sweep" --verify damaged 2>stderr && fail 'the set is whole'
expect_contains stderr "${file#damaged/}: is not as it was written"
expect_exit 0 study.yaml --output damaged --quiet
"$sweep" --verify damaged --quiet || fail 'the set is not whole again'
diff -r --exclude=recordings.journal one damaged || fail 'another set'

#!/usr/bin/env bash
# rubdata: the same bytes from any number of threads and after an interruption, labels that rubscope confirms, and what
# it refuses. The first argument is rubdata, the fourth rubscope.
source "$(dirname "$0")/support.sh"
scope=$4
config=$top/configs/recordings/rub_recordings.yaml

expect_exit 0 --help
expect_contains stdout 'rubdata STUDY.yaml'
expect_exit 0 "$config" --check
[[ $(<stdout) == "$config: ok, 500 recordings" ]] || fail 'another answer to --check'
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

# rubscope reads a recording with the description of the set, and sees what the label says.
file=$(cd one && find . -name '000000.csv')
"$scope" "one/$file" --instrument one/instrument.yaml --output seen >scope_stdout
expect_contains scope_stdout 'synchronous'

# MATLAB files have the same numbers.
sed 's/^format: csv/format: matlab/' study.yaml >matlab.yaml
expect_exit 0 matlab.yaml --output four --quiet
expect_exit 0 matlab.yaml --output five --quiet --threads 1
diff -r --exclude=recordings.journal four five || fail 'MATLAB files of other bytes'
"$scope" "four/${file%.csv}.mat" --instrument four/instrument.yaml --output seen_matlab >scope_stdout
expect_contains scope_stdout 'synchronous'

# Nothing is written on bad input, and a directory of another study is left alone.
sed 's/noise_share: .*/noise_share: [0, 1.0e-2]/' study.yaml >noise.yaml
expect_exit 2 noise.yaml --output none
expect_contains stderr 'noise.yaml:31:16: measurement.noise_share: '
expect_missing none
sed 's/offset_ratio/ofset_ratio/' study.yaml >key.yaml
expect_exit 2 key.yaml --output none
expect_contains stderr "did you mean 'offset_ratio'?"
sed 's/sampling_rate_hz: 5000/sampling_rate_hz: 500/' study.yaml >slow.yaml
expect_exit 2 slow.yaml --output none
expect_contains stderr 'reads fewer than 5 times in a turn'
expect_missing none
sed 's/^seed: 1/seed: 2/' study.yaml >other.yaml
expect_exit 2 other.yaml --output one
expect_contains stderr 'one: holds a data set of another study or version'
diff -r --exclude=recordings.journal one two || fail 'a refused study changed the set'
expect_usage_error 'one study is needed'

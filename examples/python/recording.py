"""A recording is made, read as one from a machine would be, and asked for its cause."""

import tempfile
from pathlib import Path

import rubsweep

machine = "configs/minimal.yaml"
with tempfile.TemporaryDirectory() as directory:
    recording = Path(directory) / "made" / "sensors.csv"
    rubsweep.trace(machine, speed_hz=75, whirl_ratio=0.4, options=("--sample-s", "2e-4", "--noise-m", "2e-6"),
                   output=recording.parent)

    instrument = {"time": "t_s", "speed_hz": 75, "from_s": 2,
                  "probes": [{"column": "sensor_0_m", "angle_deg": 0}, {"column": "sensor_1_m", "angle_deg": 90}]}
    scope = rubsweep.scope(recording, instrument=instrument)
    print(scope.text)
    print(scope["lines"].head(6).to_string(index=False))

    answer = rubsweep.diagnose(recording, machine, instrument=instrument, options=("--motions", "50"))
    print(answer["probabilities"].to_string(index=False))

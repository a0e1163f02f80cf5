"""A recording is made, read as one from a machine would be, and asked for its cause."""

import tempfile
from pathlib import Path

import rubsweep

kit = "configs/rotor_kit.yaml"
with tempfile.TemporaryDirectory() as directory:
    recording = Path(directory) / "made" / "sensors.csv"
    rubsweep.trace(kit, speed_hz=70, whirl_ratio=0.6, options=("--sample-s", "2e-4", "--noise-m", "2e-6"), output=recording.parent)

    instrument = {"time": "t_s", "speed_hz": 70, "from_s": 1,
                  "probes": [{"column": "sensor_0_m", "angle_deg": 0}, {"column": "sensor_1_m", "angle_deg": 90}]}
    scope = rubsweep.scope(recording, instrument=instrument)
    print(scope.text)
    print(scope["lines"].head(6).to_string(index=False))

    answer = rubsweep.diagnose(recording, kit, instrument=instrument, options=("--motions", "20", "--rounds", "0"))
    print(answer["probabilities"].to_string(index=False))

"""A map over speed and unbalance with twice the friction, its rub share by speed, and its figure."""

import sys

import rubsweep

rub = rubsweep.run("configs/minimal.yaml", **{"sweep.speed_hz.count": 21, "stops.0.friction": {"coefficient": 0.2}})
rubs = rub["class"] != "non_contact"
print(rubs.mean("whirl_ratio").to_series().to_string())

worst = rub["peak_contact_force_n"]
print(f"largest contact force {float(worst.max()):.0f} {worst.units} at",
      {name: float(value) for name, value in worst.isel(worst.argmax(...)).coords.items()})

axes = rubsweep.plot(rub)
axes.set_title("Twice the friction")
axes.figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "map.png")

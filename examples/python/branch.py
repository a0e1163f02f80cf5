"""Where the subharmonic motion of one cell begins and ends, stable or not, and what else the cell can do."""

import rubsweep

branch = rubsweep.branch("configs/minimal.yaml", cell=(75, 0.4), along="speed_hz")
print(branch["events"][["kind", "parameter", "amplitude_m"]].to_string(index=False))
orbits = branch["branch"]
print(f"orbits between {orbits['parameter'].min():.2f} and {orbits['parameter'].max():.2f} Hz")

basin = rubsweep.basin("configs/minimal.yaml", cell=(75, 0.4), grid=(9, 9))
print(basin["attractors"][["label", "share"]].to_string(index=False))

"""One cell of a map under the lens: the motion after the kick, its orbit and its spectrum."""

import rubsweep

cell = rubsweep.trace("configs/minimal.yaml", speed_hz=75, whirl_ratio=0.4)
print(cell.text)

# Tables are pandas DataFrames; the unit of a column stands in its name and in the attributes.
last = cell["trajectory"].query("t_s > t_s.max() - 2 / 75")
print(f"largest displacement of the last two turns: {last[['x_m', 'y_m']].abs().max().max() * 1e3:.3f} mm")

lines = cell["spectrum"].nlargest(5, "amplitude_m")
print(lines.to_string(index=False))

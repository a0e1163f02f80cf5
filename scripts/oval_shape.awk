# oval_shape.awk: from a spectrum.csv, the ellipse that the largest forward line off 1X and the largest backward line
# make: short axis / long axis, its precession in turns per revolution of the shaft, and the share of these two lines in
# the energy without 0X and 1X. A line that falls between bins spreads: three bins on either side are counted with it.
BEGIN { FS = "," }
/^#/ { next }
!header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; next }
{
  bins++
  order[bins] = $at["order"] + 0
  amplitude[bins] = $at["amplitude_m"] + 0
  if (order[bins] == 0 || order[bins] == 1) next
  energy += amplitude[bins] ^ 2
  if (order[bins] > 0 && amplitude[bins] > amplitude[forward]) forward = bins
  if (order[bins] < 0 && amplitude[bins] > amplitude[backward]) backward = bins
}
function held(line,    i, sum) {
  for (i = line - 3; i <= line + 3; i++) if (order[i] != 0 && order[i] != 1) sum += amplitude[i] ^ 2
  return sum
}
END {
  f = sqrt(held(forward))
  b = sqrt(held(backward))
  printf "%.2f %.3f %.2f\n", (f > b ? f - b : b - f) / (f + b), (order[forward] + order[backward]) / 2, (f * f + b * b) / energy
}

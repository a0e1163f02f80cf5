# Names the lines of a spectrum that a picture has room for. Input: lines "ORDER AMPLITUDE" in rising order; set -v
# period=n where the orders are multiples of 1/n, 0 where they are not, and comb_spacing=s where they are 1 + k s, which
# the spectrum's lines only come near to. Prints "ORDER AMPLITUDE TEXT", largest first.

function absolute(x) { return x < 0 ? -x : x }
function nearest(x) { return x < 0 ? -int(0.5 - x) : int(x + 0.5) }
function divisor(a, b) { return b == 0 ? a : divisor(b, a % b) }

function text(order,    p, common) {
  if (comb_spacing) order = 1 + nearest((order - 1) / comb_spacing) * comb_spacing
  p = nearest(order * period)
  if (!period || absolute(p - order * period) > 1e-6) return sprintf("%s%.3gX", order < 0 ? "−" : "", absolute(order))
  common = divisor(absolute(p), period)
  return (p < 0 ? "−" : "") absolute(p) / common (common == period ? "" : "/" period / common) "X"
}

{
  order[NR] = $1
  amplitude[NR] = $2
  if ($2 > largest) largest = $2
}

# At most eight, each above its neighbours and not in the way of a larger one.
END {
  for (named = 0; named < 8; ++named) {
    best = 0
    for (i = 1; i <= NR; ++i) {
      if (amplitude[i] <= 0.05 * largest || amplitude[i] < amplitude[i - 1] || amplitude[i] < amplitude[i + 1]) continue
      if (best && amplitude[i] <= amplitude[best]) continue
      free = 1
      for (k = 1; k <= named; ++k) if (absolute(order[i] - taken[k]) < 0.19) free = 0
      if (free) best = i
    }
    if (!best) exit
    taken[named + 1] = order[best]
    print order[best], amplitude[best], text(order[best])
  }
}

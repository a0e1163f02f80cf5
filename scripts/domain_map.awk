# Lays out a map.csv for domain_map.gp. Set -v measure=whirl_ratio or eccentricity_m, the column that goes upward, and
# where there is one -v natural_frequency_hz=...
# Prints two blocks, parted by two empty lines as gnuplot wants them:
#   one line per cell:   x y left right bottom top kind     x = speed / natural frequency, else speed in Hz
#   one line per domain: x y text                           where to write 1/n
# A cell reaches half way to its neighbours. `kind` is the class, with the order behind a subharmonic (8: 8 and more),
# and with what parts the motions of an annulus: synchronous_circle and synchronous_circle_backward, and of closed combs
# quasi_periodic_oval and, whirling backward, quasi_periodic_whip.

function fail(message) {
  print FILENAME ":" FNR ": " message > "/dev/stderr"
  failed = 1
  exit 1
}

function sort(values, count,    i, j, value) {
  for (i = 2; i <= count; ++i) {
    value = values[i]
    for (j = i - 1; j > 0 && values[j] > value; --j) values[j + 1] = values[j]
    values[j + 1] = value
  }
}

# low[v] and high[v]: the edges of the cells at each distinct value v.
function find_edges(values, count, low, high,    i, v, before, after) {
  sort(values, count)
  for (i = 1; i <= count; ++i) {
    v = values[i]
    before = i > 1 ? v - values[i - 1] : 0
    after = i < count ? values[i + 1] - v : 0
    if (count == 1) before = after = 0.1
    low[v] = v - (before ? before : after) / 2
    high[v] = v + (after ? after : before) / 2
  }
}

function kind_of(class, order, orbit, whirl, comb_spacing) {
  if (class == "subharmonic") return class "_" (order > 8 ? 8 : order)
  if (class == "synchronous" && orbit == "circle") return "synchronous_circle" (whirl == "backward" ? "_backward" : "")
  if (class == "quasi_periodic" && comb_spacing != "") return class (whirl == "backward" ? "_whip" : "_oval")
  return class
}

BEGIN {
  FS = ","
  CONVFMT = OFMT = "%.17g"  # numbers are keys: all their digits count
}
{ sub(/\r$/, "") }
/^#/ || /^$/ { next }
!columns {
  columns = NF
  for (i = 1; i <= NF; ++i) place[$i] = i
  split("speed_hz class order orbit whirl comb_spacing " measure, need, " ")
  for (i in need) if (!(need[i] in place)) fail("no column '" need[i] "'")
  next
}
$place[measure] != "" {
  ++cells
  x[cells] = $place["speed_hz"] / (natural_frequency_hz ? natural_frequency_hz : 1)
  y[cells] = $place[measure] + 0
  kind[cells] = kind_of($place["class"], $place["order"], $place["orbit"], $place["whirl"], $place["comb_spacing"])
  if (!(x[cells] in seen_x)) seen_x[x[cells]] = xs[++nx] = x[cells]
  if (!(y[cells] in seen_y)) seen_y[y[cells]] = ys[++ny] = y[cells]
}

# How many cells beyond its own a label of 4 % of the axis reaches, on an axis of `count` cells.
function reach(count,    cells_beyond) {
  cells_beyond = 0.02 * count - 0.5
  return cells_beyond <= 0 ? 0 : int(cells_beyond) + 1
}

# True when a label on cell i hides cells of its own kind only.
function fits(i,    column, row) {
  for (column = column_of[x[i]] - reach(nx); column <= column_of[x[i]] + reach(nx); ++column) {
    for (row = row_of[y[i]] - reach(ny); row <= row_of[y[i]] + reach(ny); ++row) {
      if (kind_at[xs[column], ys[row]] != kind[i]) return 0
    }
  }
  return 1
}

# Writes 1/n into the cell nearest to the middle of all cells of that order, among those where it fits.
function print_labels(    n, i, count, middle_x, middle_y, distance, best, best_distance) {
  for (n = 2; n < 8; ++n) {
    count = middle_x = middle_y = best = 0
    for (i = 1; i <= cells; ++i) {
      if (kind[i] != "subharmonic_" n) continue
      ++count
      middle_x += x[i]
      middle_y += y[i]
    }
    for (i = 1; i <= cells; ++i) {
      if (kind[i] != "subharmonic_" n || !fits(i)) continue
      distance = ((x[i] - middle_x / count) / (xs[nx] - xs[1] + 1e-9)) ^ 2 + \
                 ((y[i] - middle_y / count) / (ys[ny] - ys[1] + 1e-9)) ^ 2
      if (!best || distance < best_distance) {
        best = i
        best_distance = distance
      }
    }
    if (best) print x[best], y[best], "1/" n
  }
}

END {
  if (failed) exit 1
  if (!cells) fail("no cells")
  find_edges(xs, nx, left, right)
  find_edges(ys, ny, bottom, top)
  for (i = 1; i <= nx; ++i) column_of[xs[i]] = i
  for (i = 1; i <= ny; ++i) row_of[ys[i]] = i
  for (i = 1; i <= cells; ++i) kind_at[x[i], y[i]] = kind[i]
  for (i = 1; i <= cells; ++i) print x[i], y[i], left[x[i]], right[x[i]], bottom[y[i]], top[y[i]], kind[i]
  print "\n"
  print_labels()
}

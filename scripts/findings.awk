# findings.awk: measures of one map.csv, one "name value" per line. -v natural_frequency_hz=F, -v clearance_m=C.
# Speeds are in units of the natural frequency.
#   o<n>_lowest, o<n>_least_ratio   lowest speed and smallest whirl ratio of the 1/n domain
#   o<n>_lean                       its mean speed above whirl ratio 0.6 minus that below
#   gap_<n>                         cells without contact between the last 1/n and the first 1/(n + 1), row by row
#   s<n>_lowest                     lowest speed of any 1/n motion, also of islands beside the domains
#   subharmonic_upper_percent       share of the subharmonic cells above whirl ratio 0.5
#   even_percent                    share of the subharmonic cells with even n
#   synchronous_top, circle_top     highest speed of synchronous motion, of a synchronous circle
#   circle_least_ratio              smallest whirl ratio of a synchronous circle
#   wide_rows, circle_rows          with -v other=MAP.csv: rows of the map whose circles reach higher speed than those of
#                                   the same whirl ratio in the other; rows with circles in either
#   wide_rows_alike, circle_rows_alike
#                                   the same for rows of the same unbalance: that of a quiet whirl of -v gap_share=G
#                                   times the whirl ratio in the other map, where it lies between two rows; the circle
#                                   has to reach higher speed than in both
#   small_circle_cells, _lowest     synchronous circles smaller than the clearance at rest: the casing is out of phase
#   oval_cells, _lowest, _least_ratio, _hits, _repeated_percent
#                                   ovals (combs): lowest speed, smallest whirl ratio, median of the hits per whirl about
#                                   the centre, share with more than 1.5: there most whirls see two hits or more
#   <class>_percent                 share of all cells
function median(values, count,    i, j, value) {
  for (i = 2; i <= count; i++) {
    value = values[i]
    for (j = i - 1; j > 0 && values[j] > value; j--) values[j + 1] = values[j]
    values[j + 1] = value
  }
  return count % 2 ? values[(count + 1) / 2] : (values[count / 2] + values[count / 2 + 1]) / 2
}

# The dominant line is only known to 1/64 of the shaft speed, the comb's spacing well. Where 1X is the largest line, the
# whirl's own is taken to be the next one of the comb.
function whirl_order(dominant, comb_spacing) {
  return absolute(dominant - 1) < 1 / 64 || absolute(dominant - 1 + comb_spacing) < 1 / 64 ? 1 - comb_spacing : dominant
}
function absolute(x) { return x < 0 ? -x : x }
function keep_least(name, value) { if (!(name in least) || value < least[name]) least[name] = value }

function read_circles(map,    line, cell, place, i, count) {
  while ((getline line < map) > 0) {
    if (line ~ /^#/) continue
    count = split(line, cell, ",")
    if (!("class" in place)) { for (i = 1; i <= count; i++) place[cell[i]] = i; continue }
    other_ratios[cell[place["whirl_ratio"]] + 0] = 1
    if (cell[place["class"]] != "synchronous" || cell[place["orbit"]] != "circle") continue
    i = cell[place["whirl_ratio"]] + 0
    if (cell[place["speed_hz"]] + 0 > other_top[i]) other_top[i] = cell[place["speed_hz"]] + 0
  }
}

# Highest circle of the other map in the two rows about `ratio`, which may be one and the same.
function other_top_about(ratio,    r, below, above, top) {
  below = -1
  above = 1e9
  for (r in other_ratios) {
    if (r + 0 <= ratio * (1 + 1e-9) && r + 0 > below) below = r + 0
    if (r + 0 >= ratio * (1 - 1e-9) && r + 0 < above) above = r + 0
  }
  top = other_top[below] + 0
  if (other_top[above] + 0 > top) top = other_top[above] + 0
  return top
}

BEGIN { FS = ","; CONVFMT = "%.17g"; if (other != "") read_circles(other) }
/^#/ { next }
!header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; next }
{
  speed = $at["speed_hz"] / natural_frequency_hz
  ratio = $at["whirl_ratio"] + 0
  class = $at["class"]
  order = $at["order"]
  cells++
  count[class]++
  ratios[ratio] = 1
  if (class == "non_contact") quiet[ratio, ++quiets[ratio]] = speed
}
class == "subharmonic" {
  subharmonic++
  if (order % 2 == 0) even++
  if (ratio > 0.5) upper++
  keep_least("s" order "_lowest", speed)
  # A domain's own motion hits once in n turns; islands of other 1/n motions beside the domains hit more often.
  if ($at["hits_per_revolution"] * order >= 1.5) next
  keep_least("o" order "_lowest", speed)
  keep_least("o" order "_least_ratio", ratio)
  if (ratio > 0.6) { high_sum[order] += speed; high[order]++ } else { low_sum[order] += speed; low[order]++ }
  row_last[ratio, order] = speed
  if (!((ratio, order) in row_first)) row_first[ratio, order] = speed
}
class == "synchronous" {
  if (speed > synchronous_top) synchronous_top = speed
  if ($at["orbit"] != "circle") next
  if (speed > circle_top) circle_top = speed
  if (speed * natural_frequency_hz > row_top[ratio]) row_top[ratio] = speed * natural_frequency_hz
  keep_least("circle_least_ratio", ratio)
  if ($at["amplitude_1x_forward_m"] >= clearance_m) next
  small_circles++
  keep_least("small_circle_lowest", speed)
}
class == "quasi_periodic" && $at["comb_spacing"] != "" {
  hits[++ovals] = $at["hits_per_revolution"] / absolute(whirl_order($at["dominant_order"], $at["comb_spacing"]))
  if (hits[ovals] > 1.5) repeated++
  keep_least("oval_lowest", speed)
  keep_least("oval_least_ratio", ratio)
}
END {
  for (name in least) printf "%s %.2f\n", name, least[name]
  for (n = 2; n <= 6; n++) {
    if (high[n] && low[n]) printf "o%d_lean %.2f\n", n, high_sum[n] / high[n] - low_sum[n] / low[n]
    gap = 0
    for (ratio in ratios) {
      if (!((ratio, n) in row_last) || !((ratio, n + 1) in row_first)) continue
      for (i = 1; i <= quiets[ratio]; i++) {
        if (quiet[ratio, i] > row_last[ratio, n] && quiet[ratio, i] < row_first[ratio, n + 1]) gap++
      }
    }
    printf "gap_%d %d\n", n, gap
  }
  printf "even_percent %.0f\n", subharmonic ? 100 * even / subharmonic : 0
  printf "subharmonic_upper_percent %.0f\n", subharmonic ? 100 * upper / subharmonic : 0
  printf "circle_top %.1f\nsynchronous_top %.1f\n", circle_top, synchronous_top
  for (ratio in ratios) {
    if (row_top[ratio] || other_top[ratio]) circle_rows++
    if (row_top[ratio] > other_top[ratio] * (1 + 1e-9)) wide_rows++
    alike = other_top_about(gap_share * ratio)
    if (row_top[ratio] || alike) circle_rows_alike++
    if (row_top[ratio] > alike * (1 + 1e-9)) wide_rows_alike++
  }
  printf "wide_rows %d\ncircle_rows %d\n", wide_rows, circle_rows
  printf "wide_rows_alike %d\ncircle_rows_alike %d\n", wide_rows_alike, circle_rows_alike
  printf "small_circle_cells %d\noval_cells %d\n", small_circles, ovals
  if (ovals) printf "oval_hits %.1f\noval_repeated_percent %.0f\n", median(hits, ovals), 100 * repeated / ovals
  for (class in count) printf "%s_percent %.1f\n", class, 100 * count[class] / cells
}

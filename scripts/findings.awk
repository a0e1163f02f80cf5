# findings.awk: measures of one map.csv, one "name value" per line. -v natural_frequency_hz=F.
# o<n>_lowest: lowest speed of order n in units of the natural frequency; o<n>_least_ratio: smallest whirl ratio;
# o<n>_lean: mean speed above whirl ratio 0.6 minus mean speed below it; gap_<n>: cells without contact between the
# last n and the first n + 1 of a row, all rows together.
BEGIN { FS = "," }
/^#/ { next }
!header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; next }
{
  speed = $at["speed_hz"] / natural_frequency_hz
  ratio = $at["whirl_ratio"]
  class = $at["class"]
  order = $at["order"]
  cells++
  count[class]++
  if (class == "subharmonic") {
    subharmonic++
    if (order % 2 == 0) even++
  }
  # A tongue's own motion hits once in n turns; islands of other 1/n motions beside the tongues hit more often.
  if (class == "subharmonic" && $at["hits_per_revolution"] * order < 1.5) {
    if (!(order in lowest) || speed < lowest[order]) lowest[order] = speed
    if (!(order in least) || ratio < least[order]) least[order] = ratio
    if (ratio > 0.6) { high_sum[order] += speed; high[order]++ } else { low_sum[order] += speed; low[order]++ }
    row_last[ratio, order] = speed
    if (!((ratio, order) in row_first)) row_first[ratio, order] = speed
  }
  if (class == "synchronous" && speed > top[$at["orbit"]]) top[$at["orbit"]] = speed
  if (class == "synchronous" && speed > top_any) top_any = speed
  if (class == "quasi_periodic" && $at["orbit"] == "oval") {
    oval++
    oval_hits += $at["hits_per_revolution"]
    if (oval == 1 || speed < oval_lowest) oval_lowest = speed
    if (oval == 1 || ratio < oval_least_ratio) oval_least_ratio = ratio
  }
  if (class == "non_contact") quiet[ratio, ++quiets[ratio]] = speed
  ratios[ratio] = 1
}
END {
  for (n = 2; n <= 6; n++) {
    if (!(n in lowest)) continue
    printf "o%d_lowest %.2f\no%d_least_ratio %.3f\n", n, lowest[n], n, least[n]
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
  printf "even_percent %.1f\n", subharmonic ? 100 * even / subharmonic : 0
  printf "circle_top %.2f\nsynchronous_top %.2f\n", top["circle"], top_any
  printf "oval_cells %d\n", oval
  if (oval) printf "oval_lowest %.2f\noval_least_ratio %.3f\noval_hits %.2f\n", oval_lowest, oval_least_ratio, oval_hits / oval
  for (class in count) printf "%s_percent %.1f\n", class, 100 * count[class] / cells
}

# gap_cells.awk: from a map.csv, the middle cell of every gap between a 1/n and a 1/(n + 1) domain, row by row of the
# whirl ratio: lines "N SPEED_HZ WHIRL_RATIO". A gap is the cells without contact between the last 1/n and the first
# 1/(n + 1) motion that hits once in n turns.
BEGIN { FS = ","; CONVFMT = OFMT = "%.17g" }
/^#/ { next }
!header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; next }
{
  speed = $at["speed_hz"]
  ratio = $at["whirl_ratio"]
  n = $at["order"]
  if (!(ratio in quiets)) { quiets[ratio] = 0; rows[++row_count] = ratio }
  if ($at["class"] == "non_contact") quiet[ratio, ++quiets[ratio]] = speed
  if ($at["class"] != "subharmonic" || $at["hits_per_revolution"] * n >= 1.5) next
  last[ratio, n] = speed
  if (!((ratio, n) in first)) first[ratio, n] = speed
}
END {
  for (row = 1; row <= row_count; row++) {
    ratio = rows[row]
    for (n = 2; n <= 5; n++) {
      if (!((ratio, n) in last) || !((ratio, n + 1) in first)) continue
      count = 0
      for (i = 1; i <= quiets[ratio]; i++) {
        if (quiet[ratio, i] > last[ratio, n] && quiet[ratio, i] < first[ratio, n + 1]) gap[++count] = quiet[ratio, i]
      }
      if (count) print n, gap[int((count + 1) / 2)], ratio
    }
  }
}

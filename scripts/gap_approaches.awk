# gap_approaches.awk: where the casing is whenever the rotor comes near it. Input: lines "T_S Y_M CASING_Y_M GAP_M" of one
# run against a stop above; set -v clearance_m=C, -v kick_s=T. One line per approach after that of the kick; it is a
# stretch of time in which the rotor is more than half a clearance up: "hit" or "miss", then, at the last sample before the
# contact begins or at the smallest gap, displacement of the casing away from the rotor in clearances, its velocity
# away in clearances per second, the gap in clearances; then the largest displacement during the approach. Ends with the
# first miss after the last hit.

function take(name) {
  kind = name
  displacement = casing1
  velocity = (casing1 - casing2) / (time1 - time2)
  gap_then = gap1
}
function close_approach() {
  lines[++count] = kind " " displacement / clearance_m " " velocity / clearance_m " " gap_then / clearance_m " " \
    largest / clearance_m
  if (kind == "hit") last_hit = count
  kind = ""
}

{ time = $1; y = $2; casing = $3; gap = $4 }
NR > 2 && time1 > kick_s && y1 <= 0.5 * clearance_m { after_kick = 1 }
NR > 2 && after_kick {
  if (y1 > 0.5 * clearance_m) {
    if (kind == "") { kind = "open"; smallest = 1e9; largest = 0 }
    if (casing1 > largest) largest = casing1
    if (kind != "hit" && (gap1 <= 0 || gap <= 0)) take("hit")
    else if (kind != "hit" && gap1 < smallest) { smallest = gap1; take("miss") }
  } else if (kind != "") close_approach()
}
{ time2 = time1; casing2 = casing1; time1 = time; y1 = y; casing1 = casing; gap1 = gap }
END { for (i = 1; i <= last_hit + 1 && i <= count; i++) print lines[i] }

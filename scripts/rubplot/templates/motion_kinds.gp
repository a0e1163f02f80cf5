# Names of the kinds of analysis/domain_map.py in a legend, and their colours; loaded by the scripts that draw them.
# Colours: Paul Tol's "muted" scheme, made for colour-blind readers, and some of their own for rare kinds. The last three
# kinds are hatched.
kinds = 19
array kind[kinds] = ["non_contact", "synchronous_circle", "synchronous_circle_backward", "synchronous", "resting_contact", "subharmonic_2", \
  "subharmonic_3", "subharmonic_4", "subharmonic_5", "subharmonic_6", "subharmonic_7", "subharmonic_8", \
  "quasi_periodic_oval", "quasi_periodic_whip", "quasi_periodic", "chaotic", "unsettled", "initial_contact", "failed"]
array legend[kinds] = ["no contact", "synchronous circle", "backward circle", "synchronous", "at rest on a stop", "subharmonic 1/2", \
  "subharmonic 1/3", "subharmonic 1/4", "subharmonic 1/5", "subharmonic 1/6", "subharmonic 1/7", "subharmonic ≤ 1/8", \
  "quasi-periodic oval", "backward dry whip", "quasi-periodic", "chaotic", "unsettled", "pressed on the wall", "failed"]
array colour[kinds] = ["#F4F4F4", "#4F9BD0", "#F4A6B8", "#88CCEE", "#A8C686", "#CC6677", \
  "#332288", "#DDCC77", "#117733", "#882255", "#44AA99", "#999933", \
  "#EE8866", "#7A4F20", "#AA4499", "#000000", "#555555", "#999999", "#CC0000"]
# The level of red (1), green (2) or blue (3) of a colour.
part(c, i) = int("0x" . c[2 * i:2 * i + 1])

# Drawing of kinds of motion; the arrays kind, legend and colour, with `kinds` entries each, stand before it
# (motion_kinds.py).
# The level of red (1), green (2) or blue (3) of a colour.
part(c, i) = int("0x" . c[2 * i:2 * i + 1])

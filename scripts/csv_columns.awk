# Picks columns of a CSV file by name. Set -v columns='NAME ...'; with -v from=A -v to=B only rows whose first column
# is between A and B, both included. Prints the values parted by blanks.

BEGIN { FS = "," }
{ sub(/\r$/, "") }
/^#/ || /^$/ { next }
!wanted {
  for (i = 1; i <= NF; ++i) place[$i] = i
  wanted = split(columns, names, " ")
  for (i = 1; i <= wanted; ++i) {
    if (names[i] in place) continue
    print FILENAME ":" FNR ": no column '" names[i] "'" > "/dev/stderr"
    exit 1
  }
  next
}
(from == "" || $1 + 0 >= from + 0) && (to == "" || $1 + 0 <= to + 0) {
  line = $place[names[1]]
  for (i = 2; i <= wanted; ++i) line = line " " $place[names[i]]
  print line
}

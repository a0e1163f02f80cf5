# Turns the output of --print-config (block style, one value per line) into lines PATH=VALUE, list items by number:
# stops.0.casing.mass_kg=0.05

# The open keys and the column each starts in; the number of a list item stands half a column behind its dash.
function open_key(column, key) {
  while (depth && columns[depth] >= column) --depth
  columns[++depth] = column
  keys[depth] = key
}

function open_item(column) {
  while (depth && columns[depth] > column + 0.5) --depth
  if (depth && columns[depth] == column + 0.5) ++keys[depth]
  else open_key(column + 0.5, 0)
}

function path(    i, text) {
  text = keys[1]
  for (i = 2; i <= depth; ++i) text = text "." keys[i]
  return text
}

/^ *(- )?[a-z0-9_]+:/ {
  match($0, /^ */)
  column = RLENGTH
  if (substr($0, column + 1, 2) == "- ") {
    open_item(column)
    column += 2
  }
  rest = substr($0, column + 1)
  value = rest
  sub(/:.*/, "", rest)
  sub(/^[^:]*: */, "", value)
  open_key(column, rest)
  if (value != "") print path() "=" value
}

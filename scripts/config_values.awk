# Flattens a YAML configuration into lines PATH=VALUE, lists by number: stops.0.casing.mass_kg=0.05
# Understands what the programs write and read: block and flow style, plain scalars, comments.

function emit(path, text,    body, depth, part, i, c, n) {
  sub(/^ +/, "", text)
  sub(/ +$/, "", text)
  if (text !~ /^[{[]/) {
    gsub(/^["']|["']$/, "", text)
    print path "=" text
    return
  }
  body = substr(text, 2, length(text) - 2)
  if (body !~ /[^ ]/) return
  depth = 0
  part = ""
  n = 0
  for (i = 1; i <= length(body) + 1; ++i) {
    c = i > length(body) ? "," : substr(body, i, 1)
    depth += (c ~ /[{[]/) - (c ~ /[]}]/)
    if (c != "," || depth > 0) {
      part = part c
      continue
    }
    if (text ~ /^\[/) emit(path "." n++, part)
    else emit(path "." key_of(part), value_of(part))
    part = ""
  }
}

function key_of(text) {
  sub(/:.*/, "", text)
  gsub(/[ "']/, "", text)
  return text
}

function value_of(text) {
  sub(/^[^:]*:/, "", text)
  return text
}

# The path of the open keys, each with the column it starts in; a list's number stands half a column further.
function open_key(column, key) {
  while (depth && columns[depth] >= column) --depth
  columns[++depth] = column
  keys[depth] = key
}

function path(    i, text) {
  text = keys[1]
  for (i = 2; i <= depth; ++i) text = text "." keys[i]
  return text
}

{
  sub(/(^| )#.*/, "")
  if ($0 !~ /[^ ]/ || /^---/) next
  match($0, /^ */)
  column = RLENGTH
  rest = substr($0, column + 1)
  while (rest ~ /^-( |$)/) {
    while (depth && columns[depth] > column + 0.5) --depth
    if (depth && columns[depth] == column + 0.5) ++keys[depth]
    else open_key(column + 0.5, 0)
    match(rest, /^- */)
    column += RLENGTH
    rest = substr(rest, RLENGTH + 1)
  }
  if (rest ~ /^[{[]/ || rest !~ /:( |$)/) {
    if (rest != "") emit(path(), rest)
    next
  }
  open_key(column, key_of(rest))
  if (value_of(rest) ~ /[^ ]/) emit(path(), value_of(rest))
}

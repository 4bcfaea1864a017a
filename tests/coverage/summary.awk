# Sums statements (DA of an lcov file), sides of branches and conditions of decisions by folder, and lists what is not
# covered.

function excluded(file, line,    i) {
  for (i = 1; i <= rules; ++i)
    if (rule_file[i] == file && index(text(file, line), rule_words[i]) > 0) {
      used[i] = 1
      return 1
    }
  return 0
}

function text(file, line,    row, n) {
  if (!(file in loaded)) {
    loaded[file] = 1
    while ((getline row < (root file)) > 0) source[file, ++n] = row
    close(root file)
  }
  return source[file, line]
}

function room(file) {
  if (file ~ /^include\//) return "include"
  split(file, part, "/")
  return part[1] "/" part[2]
}

function share(part, whole) {
  return sprintf("%d of %d %6.2f%%", part, whole, whole ? 100 * part / whole : 100)
}

BEGIN {
  while ((getline row < exclusions) > 0) {
    if (row ~ /^#/ || split(row, cell, / *\| */) < 3) continue
    rule_file[++rules] = cell[1]
    rule_words[rules] = cell[2]
  }
}

/^SF:/ {
  file = substr($0, 4)
  counted = index(file, root) == 1
  file = substr(file, length(root) + 1)
  counted = counted && file ~ /^(include|src)\// && file !~ /^src\/(examples|firmware)\//
}

/^DA:/ && counted {
  split(substr($0, 4), field, ",")
  hits[file, field[1]] += field[2]
  if (!((file, field[1]) in seen)) {
    seen[file, field[1]] = 1
    order[++lines] = file SUBSEP field[1]
  }
}

# The other file: branches and conditions of every instance of a template, at the same place of the source.
FNR < NR && split($0, field, "\t") == 4 && index(field[1], root) == 1 {
  file = substr(field[1], length(root) + 1)
  if (file !~ /^(include|src)\// || file ~ /^src\/(examples|firmware)\//) next
  if (field[3] == "mcdc") {
    key = file SUBSEP (field[2] + 0) SUBSEP field[2]
    decides[key] += field[4]
    if (!(key in condition_seen)) {
      condition_seen[key] = 1
      condition_order[++conditions] = key
    }
    next
  }
  for (side = 0; side < 2; ++side) {
    key = file SUBSEP (field[2] + 0) SUBSEP field[2] SUBSEP side
    taken[key] += field[3 + side]
    if (!(key in branch_seen)) {
      branch_seen[key] = 1
      branch_order[++branches] = key
    }
  }
}

END {
  for (i = 1; i <= lines; ++i) {
    split(order[i], at, SUBSEP)
    if (excluded(at[1], at[2])) continue
    ++statements[room(at[1])]
    if (hits[at[1], at[2]] > 0) ++statements_hit[room(at[1])]
    else missing = missing at[1] ":" at[2] ": not reached: " text(at[1], at[2]) "\n"
  }
  for (i = 1; i <= branches; ++i) {
    split(branch_order[i], at, SUBSEP)
    if (excluded(at[1], at[2])) continue
    ++sides[room(at[1])]
    if (taken[branch_order[i]] > 0) ++sides_hit[room(at[1])]
    else if (hits[at[1], at[2]] > 0) one_sided = one_sided at[1] ":" at[2] ": one side only: " text(at[1], at[2]) "\n"
  }
  for (i = 1; i <= conditions; ++i) {
    split(condition_order[i], at, SUBSEP)
    if (excluded(at[1], at[2])) continue
    ++terms[room(at[1])]
    if (decides[condition_order[i]] > 0) ++terms_hit[room(at[1])]
    else if (hits[at[1], at[2]] > 0) idle = idle at[1] ":" at[3] ": never decides: " text(at[1], at[2]) "\n"
  }
  printf "%s%s%s", missing, one_sided, idle
  printf "%-14s %22s %22s %22s\n", "", "statements", "sides of branches", "conditions (MC/DC)"
  for (name in statements)
    printf "%-14s %22s %22s %22s\n", name, share(statements_hit[name], statements[name]),
           share(sides_hit[name], sides[name]), conditions ? share(terms_hit[name], terms[name]) : "not measured"
  for (i = 1; i <= rules; ++i)
    if (!(i in used)) print "exclusion without a line: " rule_file[i] " | " rule_words[i]
}

#!/usr/bin/env bash
# trace.sh RUN_TESTS: every requirement of tests/requirements.csv (id,sentence,tests) names tests that exist and pass.
# Names of tests are divided by blanks; one that ends in * stands for all that begin so.
set -u -o pipefail
runner=$1
table=tests/requirements.csv
list=$(mktemp) && log=$(mktemp) || exit 1
trap 'rm -f "$list" "$log"' EXIT

"$runner" --list >"$list" || exit 1
"$runner" >"$log" 2>&1
result=$(tail -n 1 "$log")
echo "$result" | grep -Eq '^[0-9]+ passed, [0-9]+ failed(, [0-9]+ left out.*)?$' || { echo "trace: the tests did not end: $result"; exit 1; }

awk -F, -v list="$list" -v log_file="$log" '
  BEGIN {
    while ((getline name < list) > 0) exists[name] = 1
    while ((getline line < log_file) > 0) if (split(line, word, " ") == 2 && word[1] == "FAIL") failed[word[2]] = 1
  }
  /^#/ || /^$/ || $1 == "id" { next }
  {
    ++requirements
    sentence = $2
    for (i = 3; i < NF; ++i) sentence = sentence "," $i
    if ($1 in seen) { print "trace: " $1 " appears twice"; bad = 1 }
    seen[$1] = 1
    found = 0
    n = split($NF, test, " ")
    for (i = 1; i <= n; ++i) {
      hits = 0
      family = test[i] ~ /\*$/ ? substr(test[i], 1, length(test[i]) - 1) : ""
      for (name in exists) {
        if (name != test[i] && (family == "" || index(name, family) != 1)) continue
        ++hits
        if (!(name in traced)) { traced[name] = 1; ++tests }
        if (name in failed) { print "trace: " $1 ": " name " fails"; bad = 1 }
      }
      if (hits == 0) { print "trace: " $1 ": there is no test " test[i]; bad = 1 }
      found += hits
    }
    if (found == 0) { print "trace: " $1 " has no test: " sentence; bad = 1 }
  }
  END {
    for (name in exists) ++all
    printf "trace: %d requirements, %d of %d tests belong to one, %s\n", requirements, tests, all, bad ? "NOT fulfilled" : "all pass"
    exit bad
  }' "$table"

#!/usr/bin/env bash
# report.sh PROFDATA COV BUILD: statements and branches of include/ and src/ from the profiles below BUILD/profiles,
# without what exclusions.txt lists. A template counts once: a line or a side of a branch is covered when any is.
set -eu -o pipefail
profdata=$1
cov=$2
build=$3
"$profdata" merge -sparse "$build"/profiles/*.profraw -o "$build/tests.profdata"
"$cov" export -format=lcov -instr-profile="$build/tests.profdata" "$build/run_tests" \
    -object "$build/tiltrotor" -object "$build/tablegen" >"$build/coverage.lcov"
"$cov" show -format=html -instr-profile="$build/tests.profdata" "$build/run_tests" \
    -object "$build/tiltrotor" -object "$build/tablegen" -ignore-filename-regex='(tests|bench|generated)/' \
    -show-branches=count -output-dir="$build/coverage" >/dev/null 2>&1 || true
# What lcov does not know, with its place, in lines of four fields divided by TABs: sides of branches (file, line:column,
# times true, times false) and conditions of decisions of two or more (file, line:column+place, "mcdc", 1 when shown to
# decide alone).
"$cov" export -skip-functions -instr-profile="$build/tests.profdata" "$build/run_tests" \
    -object "$build/tiltrotor" -object "$build/tablegen" | sed 's/{"branches":/\n&/g' | awk '
  /^\{"branches":\[.*\],"expansions":/ { branches = substr($0, 1, index($0, "],\"expansions\":")) }
  match($0, /"filename":"[^"]*"/) {
    file = substr($0, RSTART + 12, RLENGTH - 13)
    n = split(branches, item, /\],?\[?/)
    for (i = 1; i <= n; ++i) {
      gsub(/[^0-9,]/, "", item[i])
      if (split(item[i], x, ",") >= 6) printf "%s\t%d:%d\t%s\t%s\n", file, x[1], x[2], x[5], x[6]
    }
    branches = ""
    if ((at = index($0, "\"mcdc_records\":[[")) == 0) next
    records = substr($0, at + 17)
    sub(/\]\]\].*/, "]]", records)
    n = split(records, item, /\]\],\[/)
    for (i = 1; i <= n; ++i) {
      split(item[i], x, ",")
      shown = item[i]
      sub(/^[^[]*\[/, "", shown)
      gsub(/\]/, "", shown)
      conditions = split(shown, condition, ",")
      for (k = 1; k <= conditions; ++k)
        printf "%s\t%d:%d+%d\tmcdc\t%d\n", file, x[1], x[2], k, condition[k] == "true"
    }
  }' >"$build/coverage.branches"
awk -v root="$PWD/" -v exclusions=tests/coverage/exclusions.txt -f tests/coverage/summary.awk "$build/coverage.lcov" \
    "$build/coverage.branches" >"$build/coverage.txt"
cat "$build/coverage.txt"
echo "line by line: $build/coverage/index.html"

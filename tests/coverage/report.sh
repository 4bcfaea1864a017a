#!/usr/bin/env bash
# report.sh CLANG BUILD: statements and branches of include/ and src/ from the profiles below BUILD/profiles, without
# what exclusions.txt lists. A template counts once: a line or a side of a branch is covered when any instance is.
set -eu -o pipefail
clang=$1
build=$2
tool() { "$clang" -print-prog-name="$1"; }
"$(tool llvm-profdata)" merge -sparse "$build"/profiles/*.profraw -o "$build/tests.profdata"
"$(tool llvm-cov)" export -format=lcov -instr-profile="$build/tests.profdata" "$build/run_tests" \
    -object "$build/tiltrotor" -object "$build/tablegen" >"$build/coverage.lcov"
"$(tool llvm-cov)" show -format=html -instr-profile="$build/tests.profdata" "$build/run_tests" \
    -object "$build/tiltrotor" -object "$build/tablegen" -ignore-filename-regex='(tests|bench|generated)/' \
    -show-branches=count -output-dir="$build/coverage" >/dev/null 2>&1 || true
awk -v root="$PWD/" -v exclusions=tests/coverage/exclusions.txt -f tests/coverage/summary.awk "$build/coverage.lcov" \
    >"$build/coverage.txt"
cat "$build/coverage.txt"
echo "line by line: $build/coverage/index.html"

#!/usr/bin/env bash
# lint.sh FLAGS FILE...: clang-tidy (.clang-tidy) and cppcheck (tests/cppcheck.txt) with as many jobs as processors.
# A tool that is not installed, or cannot read the standard library, is named and left out.
set -u
flags=$1
shift
status=0
here=$(dirname "$0")

# A version of clang-tidy needs the headers of its own clang.
tidy_works() {
    "$here/tool.sh" lint clang-tidy clang-tidy || return
    local folder
    folder=$(mktemp -d) || return
    printf '#include <cmath>\n#include <cstddef>\nint main() {}\n' >"$folder/one.cpp"
    clang-tidy --quiet --checks='-*,bugprone-*' "$folder/one.cpp" -- -std=c++17 >/dev/null 2>&1
    local works=$?
    rm -rf "$folder"
    [ $works -eq 0 ] || echo "lint: clang-tidy $(clang-tidy --version 2>/dev/null | sed -n 's/.*version \([0-9.]*\).*/\1/p')" \
        "cannot read a program of one line: its clang is missing or of another version (Debian: clang clang-tidy), left out"
    return $works
}

if tidy_works; then
    # shellcheck disable=SC2086
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" sh -c \
        'clang-tidy --quiet --warnings-as-errors="*" "$1" -- $0 2>/dev/null' "$flags" || status=1
    [ $status -ne 0 ] || echo "clang-tidy: $# files, nothing found"
fi

if "$here/tool.sh" lint cppcheck cppcheck; then
    # One configuration, that of GCC: its parser needs minutes a file for each of them.
    # shellcheck disable=SC2086
    if cppcheck -D__GNUC__=12 -DTILTROTOR_NUMERICAL_DIFFERENCES=0 --quiet --std=c++17 --language=c++ --inline-suppr --enable=warning,performance,portability \
        --suppressions-list=tests/cppcheck.txt --error-exitcode=1 -j "$(nproc)" -Iinclude -Isrc "$@"; then
        echo "cppcheck: $# files, nothing found"
    else
        status=1
    fi
fi
exit $status

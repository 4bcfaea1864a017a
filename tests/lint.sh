#!/usr/bin/env bash
# lint.sh FLAGS FILE...: clang-tidy (.clang-tidy) and cppcheck (tests/cppcheck.txt) with as many jobs as processors.
# A tool that is not installed is named and left out.
set -u
flags=$1
shift
status=0

if command -v clang-tidy >/dev/null; then
    # shellcheck disable=SC2086
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" sh -c \
        'clang-tidy --quiet --warnings-as-errors="*" "$1" -- $0 2>/dev/null' "$flags" || status=1
    [ $status -ne 0 ] || echo "clang-tidy: $# files, nothing found"
else
    echo "lint: clang-tidy is not installed, left out"
fi

if command -v cppcheck >/dev/null; then
    # One configuration, that of GCC: its parser needs minutes a file for each of them.
    # shellcheck disable=SC2086
    if cppcheck -D__GNUC__=12 -DTILTROTOR_NUMERICAL_DIFFERENCES=0 --quiet --std=c++17 --language=c++ --inline-suppr --enable=warning,performance,portability \
        --suppressions-list=tests/cppcheck.txt --error-exitcode=1 -j "$(nproc)" -Iinclude -Isrc "$@"; then
        echo "cppcheck: $# files, nothing found"
    else
        status=1
    fi
else
    echo "lint: cppcheck is not installed, left out"
fi
exit $status

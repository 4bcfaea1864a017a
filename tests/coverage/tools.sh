#!/bin/sh
# tools.sh CLANG FLAGS: two lines, the llvm-profdata and the llvm-cov that read what this compiler writes. The profile of
# a program of one line is tried on each that is installed, for LLVM changes the format with every version and PATH may
# hold another one's. Without a pair: one line on stderr, status 1.
clang=$1
flags=$2
name=${clang##* }
fail() {
    echo "coverage: $*, nothing measured" >&2
    exit 1
}

command -v "$name" >/dev/null 2>&1 || fail "$name is not installed (Debian: clang llvm)"
# shellcheck disable=SC2086 # a compiler may be two words, flags are many
version=$($clang --version 2>/dev/null | sed -n 's/.*clang version \([0-9]*\).*/\1/p')
[ -n "$version" ] || fail "$name is not clang (Debian: clang llvm)"

folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
echo 'int main(int n, char**) { return n > 1 && n < 9; }' >"$folder/one.cpp"
# shellcheck disable=SC2086
{ $clang $flags "$folder/one.cpp" -o "$folder/one" && LLVM_PROFILE_FILE=$folder/one.profraw "$folder/one" &&
    [ -e "$folder/one.profraw" ]; } >/dev/null 2>&1 ||
    fail "$name $version cannot measure coverage (Debian: libclang-rt-$version-dev)"

beside=$(dirname "$(readlink -f "$(command -v "$name")")")
# works TOOL COMMAND...: the first place of TOOL whose COMMAND succeeds
works() {
    tool=$1
    shift
    # shellcheck disable=SC2086
    for place in "$beside/$tool" "$tool-$version" "$($clang -print-prog-name="$tool" 2>/dev/null)" "$tool"; do
        command -v "$place" >/dev/null 2>&1 && "$place" "$@" >/dev/null 2>&1 && command -v "$place" && return
    done
    fail "no $tool reads what $name $version writes (Debian: llvm-$version)"
}
works llvm-profdata merge -sparse "$folder/one.profraw" -o "$folder/one.profdata"
works llvm-cov export -format=lcov -instr-profile="$folder/one.profdata" "$folder/one"

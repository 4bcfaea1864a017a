#!/bin/sh
# tool.sh GOAL NEED PACKAGE [NEED PACKAGE]...: status 0 when every need is met; else status 1 and one line that names all
# that are not, with their Debian packages. A NEED is a program, or COMPILER:HEADER for what that compiler must find.
goal=$1
shift

met() {
    case $1 in
        *:*) echo "#include <${1#*:}>" | ${1%%:*} -x c++ -fsyntax-only - ;;
        *) command -v "$1" ;;
    esac >/dev/null 2>&1
}

missing=
packages=
while [ $# -ge 2 ]; do
    if ! met "$1"; then
        case $1 in
            *:*) name="<${1#*:}> of ${1%%:*}" ;;
            *) name=$1 ;;
        esac
        missing="$missing${missing:+, }$name"
        case " $packages " in *" $2 "*) ;; *) packages="$packages${packages:+ }$2" ;; esac
    fi
    shift 2
done
[ -z "$missing" ] && exit 0
echo "$goal: not installed: $missing (Debian: $packages), left out"
exit 1

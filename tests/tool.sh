#!/bin/sh
# tool.sh GOAL TOOL PACKAGE [TOOL PACKAGE]...: status 0 when every tool can be started; else status 1 and one line that
# names all that are missing with their Debian packages.
goal=$1
shift
tools=
packages=
while [ $# -ge 2 ]; do
    if ! command -v "$1" >/dev/null 2>&1; then
        tools="$tools${tools:+, }$1"
        case " $packages " in *" $2 "*) ;; *) packages="$packages${packages:+ }$2" ;; esac
    fi
    shift 2
done
[ -z "$tools" ] && exit 0
echo "$goal: not installed: $tools (Debian: $packages), nothing done"
exit 1

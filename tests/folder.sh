#!/bin/sh
# folder.sh NAME FOLDER: one line that says why the build cannot write there; nothing when it can. Called in the tree.
# BUILD is emptied by `make clean` and a word of make: it must not hold the sources, nor signs that make or a shell read.
name=$1
folder=$2
tree=$(pwd -P)

refuse() {
    echo "$name='$folder' $1"
    exit
}

[ -n "$folder" ] || refuse "is empty: name a folder"
if [ "$name" = BUILD ]; then
    case $folder in -*) refuse "begins with -" ;; esac
    odd=$(printf %s "$folder" | LC_ALL=C tr -d 'A-Za-z0-9._/+@,\200-\377-' | tr ' \t\n' '___')
    [ -z "$odd" ] || refuse "is no name without blanks, of letters, digits and . _ / + - @ ,"
else
    case $folder in *[\'\"\`\\\$]*) refuse "has a quote, a backslash or a dollar" ;; esac
fi

# The nearest folder that exists, links followed; then what is to be made in it.
nearest=$folder
rest=
until [ -e "$nearest" ]; do
    rest=/$(basename -- "$nearest")$rest
    nearest=$(dirname -- "$nearest")
done
[ -d "$nearest" ] || refuse "is no folder: $nearest is a file"
case $rest/ in */../*) refuse "leads back through a folder that does not exist" ;; esac
place=$(cd -- "$nearest" && pwd -P)
place=${place%/}$rest/

case $name$tree/ in "BUILD$place"* | "$name$place") refuse "holds the sources" ;; esac
for part in include src tables tests bench .git .ci; do
    case $place in "$tree/$part/"*) refuse "lies among the sources, in $part" ;; esac
done

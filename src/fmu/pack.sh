#!/bin/sh
# From the root of the tree: pack.sh FOLDER FMU packs what the build has put into FOLDER. One date, one order, one set of
# modes, whatever the umask: the same parts give the same bytes. ZIPPER: another name of zip.
set -e
folder=$1 packed=$1/packed
case $2 in /*) to=$2 ;; *) to=$(pwd)/$2 ;; esac

rm -rf "$to" "$packed"
mkdir -p "$packed/documentation/licenses" "$packed/terminalsAndIcons"
cp -R "$folder/modelDescription.xml" "$folder/binaries" "$folder/sources" "$packed"
cp src/fmu/terminalsAndIcons.xml src/fmu/icon.svg src/fmu/icon.png "$packed/terminalsAndIcons"
cp src/fmu/README.md "$folder/index.html" "$packed/documentation"
cp LICENSE "$packed/documentation/licenses/license.txt"

find "$packed" -type d -exec chmod 755 {} +
find "$packed" -type f -exec chmod 644 {} +
find "$packed" -name '*.so' -exec chmod 755 {} +
find "$packed" -exec touch -t 198001010000 {} +

cd "$packed"
if command -v "${ZIPPER:-zip}" >/dev/null; then
  find . -type f | LC_ALL=C sort | "${ZIPPER:-zip}" -q -X -@ "$to"
elif command -v python3 >/dev/null; then
  python3 -m zipfile -c "$to" binaries documentation modelDescription.xml sources terminalsAndIcons
else
  echo "fmu: not installed: zip (Debian: zip), left as the folder $folder/packed"
fi

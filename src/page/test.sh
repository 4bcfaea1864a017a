#!/bin/sh
# test.sh BROWSER PAGE REFERENCE FOLDER: the page's own test in a headless browser. REFERENCE is the output of the reference flight
# on this machine, equal line by line; nothing may be written to the console. Screenshots of both rooms go to FOLDER.
browser=$1
page=$2
reference=$3
folder=$4
mkdir -p "$folder"
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT

# A profile of its own for each run: one that was stopped leaves a lock.
run() { # ADDRESS OPTIONS...
    address=$1
    shift
    rm -rf "$profile"
    timeout -k 5 180 "$browser" --headless --no-sandbox --disable-gpu --no-first-run --user-data-dir="$profile" \
        --enable-logging=stderr --hide-scrollbars "$@" "file://$page$address" </dev/null 2>"$folder/browser.log"
}

failed=0
run '#self_test' --dump-dom >"$folder/dom.html"
grep 'CONSOLE' "$folder/browser.log" && failed=1
# The text of the result, and entities as characters.
sed -n '/<pre id="self_test"/,/<\/pre>/p' "$folder/dom.html" |
    sed -e 's/^.*<pre id="self_test">//; s/<\/pre>.*//; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' >"$folder/self_test.txt"
grep -E '^(ok|FAILED) ' "$folder/self_test.txt"
grep -q '^FAILED ' "$folder/self_test.txt" && failed=1
[ "$(tail -n 1 "$folder/self_test.txt")" = done ] || { echo "test-page: the page's test did not end"; failed=1; }
sed -n '/^reference flight$/,/^$/p' "$folder/self_test.txt" | sed '1d; /^$/d' >"$folder/reference_flight.txt"
if cmp -s "$folder/reference_flight.txt" "$reference"; then
    echo "ok reference flight: that of this machine, bit for bit"
else
    diff "$folder/reference_flight.txt" "$reference" | tail -n 8
    failed=1
fi
for width in 390 1440; do
    for room in explore fly; do
        run "#still&mast=30&speed=60$([ $room = fly ] && echo '&fly=1')" --window-size=$width,$((width < 500 ? 2600 : 1000)) \
            --screenshot="$folder/$room$width.png" >/dev/null
        grep 'CONSOLE' "$folder/browser.log" && failed=1
    done
done
[ -s "$folder/explore390.png" ] || { echo "test-page: no screenshots"; failed=1; }
exit $failed

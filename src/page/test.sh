#!/bin/sh
# test.sh BROWSER PAGE REFERENCE FOLDER PROGRAM: the page's own test in a headless browser. REFERENCE is the output of the reference
# flight on this machine, equal line by line; PROGRAM flies what the page has recorded again and comes to the same state; nothing may
# be written to the console. Screenshots of both rooms go to FOLDER.
browser=$1
page=$2
reference=$3
folder=$4
program=$5
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

# The recorded flight, as it is downloaded.
sed -n '/^script$/,/^series$/p' "$folder/self_test.txt" | sed '1d; $d' >"$folder/flight.txt"
sed -n '/^series$/,/^end of series$/p' "$folder/self_test.txt" | sed '1d; $d; /^$/d' >"$folder/flight.csv"
options=$(sed -n '1s/^# tiltrotor fly //p' "$folder/flight.txt")
# shellcheck disable=SC2086 # words
(cd "$folder" && "$program" fly $options --every 3600 \
    --columns u_mps,v_mps,w_mps,p_degps,q_degps,r_degps,roll_deg,pitch_deg,yaw_deg) >"$folder/again.csv" 2>"$folder/again.log"
{ sed -n 's/^state //p' "$folder/self_test.txt"; tail -n 1 "$folder/again.csv"; } | tr ',' ' ' | awk '
    NR == 1 { split($0, flown) }
    NR == 2 { count = NF
        for (k = 1; k <= NF; ++k) {
            off = $k - flown[k] * (k > 3 ? 180 / atan2(0, -1) : 1)
            if (off < 0) off = -off
            if (off > worst) worst = off
        } }
    END { fails = count != 9 || !(worst < 1e-7)
        printf "%s recorded flight: flown again to %g m/s and deg\n", fails ? "FAILED" : "ok", worst; exit fails }' || failed=1
for width in 390 1440; do
    for room in explore fly; do
        run "#still&mast=30&speed=60$([ $room = fly ] && echo '&fly')" --window-size=$width,$((width < 500 ? 2600 : 1000)) \
            --screenshot="$folder/$room$width.png" >/dev/null
        grep 'CONSOLE' "$folder/browser.log" && failed=1
    done
done
[ -s "$folder/explore390.png" ] || { echo "test-page: no screenshots"; failed=1; }
exit $failed

#!/bin/sh
# test.sh BROWSER PAGE REFERENCE FOLDER PROGRAM: the page's own test in a headless browser. REFERENCE is the output of the reference
# flight on this machine, equal line by line; PROGRAM flies what the page has recorded again and comes to the same state; nothing may
# be written to the console. Screenshots of both rooms go to FOLDER, and nothing may be cut off there.
browser=$1
page=$2
reference=$3
folder=$4
program=$5
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT

# open ADDRESS OPTIONS...: the page as it is after its scripts, in dom.html. Browsers without a screen sometimes never answer, or
# answer and never end: one that is silent is asked once more, one that has answered is ended. What the page says is judged the same.
open() {
    address=$1
    shift
    for try in first second; do
        # A profile of its own for each try: one that was stopped leaves a lock.
        rm -rf "$profile"
        timeout -k 5 180 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --no-first-run \
            --disable-background-networking --disable-component-update --disable-sync --disable-extensions --password-store=basic \
            --user-data-dir="$profile" --enable-logging=stderr --hide-scrollbars --dump-dom "$@" "file://$address" \
            </dev/null >"$folder/dom.html" 2>"$folder/browser.log" &
        left=30
        while kill -0 $! 2>/dev/null && [ $left -gt 0 ]; do
            sleep 0.5
            if grep -q '</html>' "$folder/dom.html"; then left=$((left - 1)); fi
        done
        kill $! 2>/dev/null
        wait $!
        if grep -q '</html>' "$folder/dom.html"; then
            grep 'CONSOLE' "$folder/browser.log" && failed=1
            return
        fi
        echo "test-page: $browser did not answer for $address ($try try)"
    done
    failed=1
}
# The text of the page's own test.
said() {
    sed -n '/<pre id="self_test"/,$p' "$folder/dom.html" | sed '/<\/pre>/q' |
        sed -e 's/^.*<pre id="self_test"[^>]*>//; s/<\/pre>.*//; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g'
}

failed=0
open "$page#self_test"
said >"$folder/self_test.txt"
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

# picture NAME ROOM WIDTH HEIGHT ADDRESS OPTIONS...: in a frame, since browsers without a screen have a least width.
picture() {
    name=$1 room=$2 width=$3 height=$4 address=$5
    shift 5
    rm -f "$folder/$name.png"
    printf '<!DOCTYPE html><body style="margin:0"><pre id="self_test" hidden></pre><script>
      onmessage = (event) => { document.getElementById("self_test").textContent = event.data; };</script>
      <iframe src="file://%s" width="%s" height="%s" style="border:0;display:block"></iframe>' \
        "$page$(echo "$address" | sed 's/&/\&amp;/g')" "$width" "$height" >"$folder/frame.html"
    open "$folder/frame.html" --window-size="$((width < 500 ? 500 : width)),$height" --screenshot="$folder/$name.png" "$@"
    if [ "$(said)" = "$room at $width pixels: nothing cut off" ] && [ -s "$folder/$name.png" ]; then
        echo "ok picture $name: $room, nothing cut off"
    else
        echo "FAILED picture $name: not '$room, nothing cut off' at $width pixels but: $(said)"
        failed=1
    fi
}
at='#still&mast=30&speed=60'
picture explore390 explore 390 4400 "$at"
picture explore1440 explore 1440 1650 "$at"
picture fly390 fly 390 2100 "$at&fly"
picture fly1440 fly 1440 1250 "$at&fly" --force-prefers-reduced-motion
picture none390 explore 390 1500 '#still&mast=90&speed=10&mass=9e9'
exit $failed

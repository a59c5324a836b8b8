#!/bin/sh
# The commands of pens and traces: what they say and with which exit code.
#
#     pen_commands_test.sh CROQUIS
set -u
croquis=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failures=0

expect() { # CODE WORDS COMMAND...
    code=$1 words=$2
    shift 2
    output=$("$croquis" "$@" 2>&1)
    got=$?
    if [ "$got" -ne "$code" ] || ! printf '%s' "$output" | grep -qF -- "$words"; then
        echo "croquis $*: exit code $got, expected $code and: $words"
        printf '%s\n' "$output" | cut -c1-300 | head -5
        failures=$((failures + 1))
    fi
}

# A pen of 32767 by 32767 steps that comes, draws six samples and leaves.
descriptor="05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 09 3c 09 32 15 00 25 01 75 01 95 05 81 02 95 03 81 03
 05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 05 0d 09 30 26 ff 1f 95 01 81 02 09 3d 09 3e 15 c4 25 3c 75 08 95 02 81 02
 c0 c0"
bytes=$(echo "$descriptor" | wc -w)
{
    echo "R: $bytes" $descriptor
    echo 'N: Some Pen'
    echo 'I: 3 1234 5678'
    echo 'E: 1.000000 10 07 10 00 10 00 10 00 00 05 06'
    for i in 1 2 3 4 5 6; do echo "E: 1.00${i}000 10 07 11 00 1$i 00 2$i 00 1$i 05 06"; done
    echo 'E: 1.007000 10 07 00 00 00 00 00 00 00 00 00'
} >"$folder/pen.rec"

expect 0 '8 samples' tablet decode "$folder/pen.rec"
expect 0 '"tilt_x_rad"' tablet decode "$folder/pen.rec" --json
expect 0 '1 strokes' trace convert "$folder/pen.rec" "$folder/a.trace"
expect 0 '1 strokes' trace info "$folder/a.trace"
expect 0 '"differing":0' trace info "$folder/a.trace" --json
expect 0 'stroke 1: 6 samples' trace replay "$folder/a.trace"
for format in inkml svg ndjson; do
    expect 0 '1 strokes' trace convert "$folder/a.trace" "$folder/a.$format"
    expect 0 'stroke 1: 6 samples' trace replay "$folder/a.$format"
done
expect 0 '1 strokes' trace convert "$folder/a.trace" "$folder/b.trace"
cmp -s "$folder/a.trace" "$folder/b.trace" || { echo "a trace converted to a trace is another"; failures=$((failures + 1)); }

head -c -5 "$folder/a.trace" >"$folder/torn.trace"
expect 1 'the last record was cut off' trace info "$folder/torn.trace"
sed '4s/0/1/' "$folder/a.trace" >"$folder/flipped.trace"
expect 1 'damaged, first in line 4' trace replay "$folder/flipped.trace"
echo '<ink xmlns="http://www.w3.org/2003/InkML"></ink>' >"$folder/none.inkml"
expect 1 'no strokes' trace info "$folder/none.inkml"
printf 'R: 3 05 0d 26\nE: 0.1 2 07 81\n' >"$folder/malformed.rec"
expect 1 'malformed: truncated item at byte 2' tablet decode "$folder/malformed.rec"
printf '\005\015\046' >"$folder/malformed.bin"
expect 1 'malformed: truncated item at byte 2' tablet decode "$folder/malformed.bin"
expect 1 'no such file' tablet decode "$folder/nothing"
expect 1 'no recording of a tablet' tablet decode "$croquis"
expect 1 'there is such a file already' trace record "$folder/a.trace" --seconds 0.1
expect 2 'has to end in' trace convert "$folder/a.trace" "$folder/a.png"
expect 2 '--by takes' tablet monitor --by magic
expect 2 'required' tablet

[ "$failures" -eq 0 ] && echo "pen commands: all as expected"
[ "$failures" -eq 0 ]

#!/bin/sh
# What croquis says to wrong calls, to input that never ends and to output that has no room: one sentence that names
# the thing, and the exit code.
#
#     wrong_calls_test.sh CROQUIS
set -u
croquis=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failures=0
fault() {
    echo "$*"
    failures=$((failures + 1))
}

expect() { # CODE WORDS COMMAND...
    code=$1 words=$2
    shift 2
    timeout 20 "$croquis" "$@" >"$folder/out" 2>"$folder/err" </dev/null
    got=$?
    [ "$got" -eq "$code" ] || fault "croquis $*: exit code $got, expected $code"
    [ -z "$words" ] || grep -qF -- "$words" "$folder/err" || fault "croquis $*: no \"$words\" in: $(cut -c1-300 "$folder/err")"
    [ "$code" -ne 1 ] || [ "$(wc -l <"$folder/err")" -eq 1 ] || fault "croquis $*: more than one sentence"
}

echo '{"word":"x","drawing":[[[0,90,90,0,0],[0,0,90,90,0]]]}' >"$folder/square.ndjson"
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n' >"$folder/a.off"
printf 'square.ndjson\tx\nsquare.ndjson\tx\n' >"$folder/two.list"
printf 'gone.off\tx\n' >"$folder/gone.list"
mkfifo "$folder/pipe" || exit 1

# Numbers out of range write nothing; command_line_test.sh has the other wrong calls.
expect 2 '--jobs: give a number from 1 to 256, not "1000000"' index build "$folder/a.off" --db "$folder/x.db" --jobs 1000000
expect 2 'give a number, not "inf"' trace record "$folder/x.trace" --seconds inf
[ ! -e "$folder/x.db" ] || fault "a wrong call made an index"

# Input that never ends.
for path in "$folder/pipe" /dev/zero; do
    says='a device or a pipe'
    expect 1 "$says" describe "$path"
    expect 1 "$says" match "$folder/square.ndjson" "$path"
    expect 1 "$says" trace info "$path"
    expect 1 "$says" tablet decode "$path"
    expect 1 "$says" eval shapes "$path"
    expect 1 "$says" garment build "$path" --out "$folder/x.obj"
    expect 1 "$says" garment fill "$path" --out "$folder/x.obj"
    expect 1 "$says" config "$path"
    expect 1 "$says" index build "$folder/a.off" --db "$folder/x.db" --classes "$path"
    expect 1 "$says" index list --db "$path"
    expect 1 "$says" kiosk --headless --replay "$path"
    expect 1 'not an ordinary file' index build "$path" --db "$folder/y.db"
done

mkdir "$folder/words" "$folder/no_words"
mkfifo "$folder/words/xx.json" || exit 1
expect 1 'xx.json: this is a device or a pipe' \
    kiosk --headless --replay "$folder/square.ndjson" --set visitors.languages_folder="$folder/words"
: >"$folder/no_words/xx.json"
expect 1 'xx.json: a language file must be one JSON object' \
    kiosk --headless --replay "$folder/square.ndjson" --set visitors.languages_folder="$folder/no_words"
printf 'P2\n10 10\n255\n' >"$folder/picture.pgm"
expect 1 'picture.pgm: this is no drawing that can be read; give PNG' describe "$folder/picture.pgm"

# Figures for as many ranks as there are others, whatever is asked for.
expect 0 '' eval shapes "$folder/two.list" --ranks 2000000000 --json
grep -q '"hits_by_rank":\[2\]' "$folder/out" || fault "not one rank: $(cut -c1-300 "$folder/out")"

# A list of classes that names nothing is a mistake.
expect 1 'gone.list: none of the files that it names is there' \
    index build "$folder/a.off" --db "$folder/x.db" --classes "$folder/gone.list"

# Output without room, and closed output.
for call in "describe $folder/square.ndjson" "describe $folder/square.ndjson --json" config --help --version; do
    # shellcheck disable=SC2086  # the words of the call
    "$croquis" $call >/dev/full 2>"$folder/err"
    got=$?
    [ "$got" -eq 1 ] || fault "croquis $call >/dev/full: exit code $got"
    grep -q 'the results could not be written' "$folder/err" || fault "croquis $call >/dev/full said nothing"
    # shellcheck disable=SC2086
    "$croquis" $call >&- 2>"$folder/err"
    [ $? -eq 1 ] || fault "croquis $call >&-: done, though nothing was written"
done
"$croquis" describe "$folder/square.ndjson" --picture "$folder/a.png" >/dev/null 2>&1 || fault "no picture"
"$croquis" describe "$folder/square.ndjson" --picture "$folder/b.png" <&- >&- 2>&-
cmp -s "$folder/a.png" "$folder/b.png" || fault "with its streams closed, describe wrote another picture"

if [ "$failures" -gt 0 ]; then
    echo "$failures faults"
    exit 1
fi
echo "croquis: every wrong call was answered"

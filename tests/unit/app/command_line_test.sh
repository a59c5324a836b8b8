#!/bin/sh
# The command line as a stranger meets it: wrong calls, file names of any bytes, what --json holds, an output that is
# full, a kiosk without a screen.
#
#     command_line_test.sh CROQUIS FOLDER      FOLDER is made anew
set -u
croquis=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder/models"
db=$folder/a.db

faults=0
fault() {
    echo "FAULT: $*"
    faults=$((faults + 1))
}
# expect CODE WORDS…: runs the words, keeps out and err, and compares the exit code.
expect() {
    wanted=$1
    shift
    "$@" >"$folder/out" 2>"$folder/err"
    code=$?
    [ "$code" -eq "$wanted" ] || fault "exit code $code instead of $wanted from: $*: $(cat "$folder/err")"
}
says() { grep -q -- "$2" "$folder/$1" || fault "no \"$2\" in $1: $(head -c 600 "$folder/$1")"; }
lines() { [ "$(wc -l <"$folder/$1")" -eq "$2" ] || fault "not $2 lines in $1: $(head -c 600 "$folder/$1")"; }
# wrong_call WORDS ARGUMENTS…: exit code 2, one sentence that holds the words and leads to the help, nothing else.
wrong_call() {
    words=$1
    shift
    expect 2 "$croquis" "$@"
    says err "^croquis: .*$words"
    lines err 1
    lines out 0
}

for command in "" kiosk config doctor index "index build" "index list" "index show" "index remove" "index check" \
    "index vacuum" query describe match eval "eval shapes" "eval sketches" "eval models" starter trace "trace info" \
    "trace convert" "trace replay" "trace record" tablet "tablet list" "tablet monitor" "tablet decode" mannequin \
    garment "garment fill" "garment build" "garment pattern" "garment wardrobe" "garment designs list"; do
    # shellcheck disable=SC2086 # the words of a command are words
    expect 0 "$croquis" $command --help
    says out "^Usage: croquis"
    lines err 0
done

wrong_call 'A subcommand is required; see croquis --help$'
wrong_call 'there is no command "draw"; see croquis --help$' draw
wrong_call 'there is no command "make"; see croquis index --help$' index make
wrong_call 'SKETCH is required; see croquis query --help$' query
wrong_call '--db is required' query a.png
wrong_call 'not expected: --colour' query a.png --db a.db --colour
wrong_call '--db may be given once only; see croquis query --help$' query a.png --db a.db --db b.db
wrong_call '--top: give a number above 0, not "0"; see' query a.png --db a.db --top 0
wrong_call '--top: give a number above 0, not "-3"; see' query a.png --db a.db --top -3
wrong_call '--top: give a whole number, not "1.5"; see' query a.png --db a.db --top 1.5
wrong_call '--top: give a whole number, not "99999999999"; see' query a.png --db a.db --top 99999999999
wrong_call '--jobs: give a whole number, not "two"; see croquis index build --help$' index build m --db a.db --jobs two
wrong_call 'ID: give a whole number, not "first"' index show first --db a.db
wrong_call '--view: give a number from 0 to 1, not "2"' index show 1 --db a.db --view 2
wrong_call '--shuffle: give a whole number from 0 to 4294967295, not "-1"' eval shapes a.list --shuffle -1
wrong_call '--alpha: give a number from -0.25 to 0, not "-0.3"' garment fill a.json --out a.obj --alpha -0.3
wrong_call '--alpha: give a number, not "nan"' garment fill a.json --out a.obj --alpha nan
wrong_call 'a.stl: the name has to end in .obj' garment fill a.json --out a.stl
wrong_call 'a.stl: the name has to end in .obj or .glb' garment build a.json --out a.stl
wrong_call 'a.glb: the name has to end in .obj' mannequin --out a.glb
[ ! -e a.glb ] || fault "a.glb was written all the same"

# A region of four sides, which fills with or without a word about alpha.
echo '{"sides":[[[0,0,0],[1,0,0],[2,0,0]],[[2,0,0],[2,2,0]],[[2,2,0],[1,2,0],[0,2,0]],[[0,2,0],[0,0,0]]]}' >"$folder/plain.json"
expect 0 "$croquis" garment fill "$folder/plain.json" --out "$folder/plain.obj" --json
lines err 0
# Five sides that arch high: at -0.25 the cloth would rise far above all of them.
awk 'BEGIN {
    split("6 4 3 5 4", edges, " ")
    pi = atan2(0, -1)
    printf "{\"sides\":["
    for (i = 0; i < 5; i++) {
        a = 2 * pi * i / 5; b = 2 * pi * (i + 1) % (10 * pi) / 5; n = edges[i + 1]
        printf "%s[", i ? "," : ""
        for (k = 0; k <= n; k++) {
            t = k / n
            printf "%s[%.9f,%.9f,%.9f]", k ? "," : "", 10 * ((1 - t) * cos(a) + t * cos(b)),
                10 * ((1 - t) * sin(a) + t * sin(b)), 4 * sin(pi * t)
        }
        printf "]"
    }
    print "]}"
}' >"$folder/arch.json"
expect 0 "$croquis" garment fill "$folder/arch.json" --out "$folder/arch.obj" --json
says err "arch.json: alpha [-0-9.e]* was used in place of -0.25"

# An index of two models of boxes.
. "$(dirname "$0")/../../support/table_models.sh"
write_model low.off 1
write_model high.off 3
printf 'models/low.off\ttable\nmodels/high.off\tdesk\n' >"$folder/classes.list"
expect 0 "$croquis" index build "$folder/models" --db "$db" --classes "$folder/classes.list"

# A drawing, under a name that is no UTF-8.
latin=$(printf '%s/t\344ble.ndjson' "$folder")
echo '{"word":"table","drawing":[[[0,200,200,180,180,20,20,0,0],[0,0,20,20,120,120,20,20,0]]]}' >"$latin"
expect 0 "$croquis" describe "$latin" --json
says out '^{"shape":".*"parts":\[{"part":0,"first_terminal":0,'
expect 0 "$croquis" describe "$latin"
says out '  part  0: terminal  0'
expect 0 "$croquis" query "$latin" --db "$db" --json
says out '"id":[12],"path":"[^"]*/models/[a-z]*.off",'
lines out 1

# What the page of the command line names is there, without more than it names being asked for.
cp "$latin" "$folder/table.ndjson"
printf 'table.ndjson\ttable\ntable.ndjson:0\tchair\n' >"$folder/drawings.list"
expect 0 "$croquis" eval sketches "$folder/drawings.list" --db "$db" --json
for row in parts fused reranked; do says out "\"$row\":{\"NN\":"; done
says err 'a.db: drawings of 1 classes, "chair" the first, can find no model'
lines err 1
printf 'table.ndjson\ttable\ntable.ndjson:0\ttable\n' >"$folder/drawings.list"
expect 0 "$croquis" eval shapes "$folder/drawings.list" --json
says out '"bullseye":1.0,"ties":0}'
: >"$folder/empty.list"
expect 1 "$croquis" eval shapes "$folder/empty.list" --json
says err 'empty.list: the list names no file'
lines err 1

# Health: permissions are looked at, and what is wrong is said in one sentence beside the report.
"$croquis" doctor --db "$db" --json >"$folder/out" 2>"$folder/err"
says out '{"name":"permissions","good":'
lines out 1
[ "$(wc -l <"$folder/err")" -le 1 ] || fault "more than one sentence: $(cat "$folder/err")"

# A disk that is full, under standard output.
if [ -w /dev/full ]; then
    "$croquis" index list --db "$db" >/dev/full 2>"$folder/err"
    [ $? -eq 1 ] || fault "nobody was told that the list could not be written"
    says err 'the results could not be written'
fi

# Every format that a query reads is replayed, pictures too; an index that is not there is a fault.
expect 0 "$croquis" index show 1 --db "$db" --picture "$folder/low.png"
expect 0 "$croquis" kiosk --headless --size 640x480 --db "$db" --replay "$folder/low.png" --replay "$folder/table.ndjson" --json
says out '"drawing":"[^"]*low.png","ids":\[[12],'
lines out 1
expect 1 "$croquis" kiosk --headless --size 640x480 --db "$folder/gone.db" --replay "$folder/table.ndjson"
says err 'gone.db: there is no such file'
if [ ! -e /dev/dri/card0 ]; then
    expect 1 env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR -u SDL_VIDEODRIVER timeout 60 "$croquis" kiosk --db "$db"
    says err '^croquis: no screen can be opened'
    lines err 1
fi

[ "$faults" -eq 0 ]

#!/bin/sh
# croquis index as people call it: exit codes, one sentence a fault, one JSON object on standard output.
#
#     index_command_test.sh CROQUIS FOLDER      FOLDER is made anew
set -u
croquis=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder/models" "$folder/empty"
db=$folder/a.db

. "$(dirname "$0")/../../support/table_models.sh"

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
says() { grep -q -- "$2" "$folder/$1" || fault "no \"$2\" in $1: $(cat "$folder/$1")"; }
lines() { [ "$(wc -l <"$folder/$1")" -eq "$2" ] || fault "not $2 lines in $1: $(cat "$folder/$1")"; }

write_model a.off 2
write_model b.off 3
write_model c.off 4

expect 0 "$croquis" index build "$folder/models" --db "$db" --json
says out '^{"added":3,"skipped":0,"failed":\[\],"kept":\[\],"measured":0,"ms":[0-9.]*}$'
lines out 1
lines err 0

printf 'PK\003\004\024\000' >"$folder/models/b2.obj"
expect 1 "$croquis" index build "$folder/models" --db "$db" --json
says out '"added":0,"skipped":3,"failed":\[{"file":"[^"]*b2.obj","why":"this is an archive'
lines out 1
lines err 1
rm "$folder/models/b2.obj"

expect 1 "$croquis" index build "$folder/empty" --db "$db" --json
says err "empty: there is no 3D model in it"
lines err 1
lines out 0
expect 1 "$croquis" index build "$folder/gone" --db "$db"
says err "gone: there is no such file or folder"
expect 2 "$croquis" index build --db "$db"
expect 2 "$croquis" index build "$folder/models"
expect 2 "$croquis" index build "$folder/models" --db "$db" --jobs 0

expect 0 "$croquis" index list --db "$db" --json
says out '^{"models":\[{"id":1,"name":"A",'
lines out 1
expect 0 "$croquis" index list --db "$db"
lines out 3
expect 0 "$croquis" index show 2 --db "$db" --json --picture "$folder/b.png" --view 1
says out '^{"id":2,"name":"B",.*"views":\[{"camera":'
[ "$(head -c 8 "$folder/b.png" | tail -c 7 | head -c 3)" = PNG ] || fault "the thumbnail is no PNG"
expect 1 "$croquis" index show 9 --db "$db" --json
says err "there is no model 9"
lines out 0
expect 0 "$croquis" index check --db "$db" --json
says out '^{"models":3,"damaged":\[\]}$'
expect 0 "$croquis" index remove 2 --db "$db" --json
says out '^{"removed":2}$'
expect 1 "$croquis" index remove 2 --db "$db" --json
expect 0 "$croquis" index vacuum --db "$db" --json
says out '^{"bytes":[0-9]*}$'
expect 0 "$croquis" index list --db "$db"
lines out 2

# Re-ranking needs the models' likeness among themselves, which a build is asked for once.
echo '{"word":"table","drawing":[[[0,200,200,180,180,20,20,0,0],[0,0,20,20,120,120,20,20,0]]]}' >"$folder/table.ndjson"
expect 1 "$croquis" query "$folder/table.ndjson" --db "$db" --rerank
says err "a.db: the index does not know which models are near to which; call .croquis index build. with --graph"
lines err 1
lines out 0
expect 0 "$croquis" index build "$folder/models" --db "$db" --graph --json
says out '"added":1,"skipped":2,.*"measured":3,'
write_model d.off 5
expect 0 "$croquis" index build "$folder/models" --db "$db" --json
says out '"added":1,"skipped":3,.*"measured":4,'
expect 0 "$croquis" index check --db "$db"
expect 0 "$croquis" query "$folder/table.ndjson" --db "$db" --json
cp "$folder/out" "$folder/plain"
expect 0 "$croquis" query "$folder/table.ndjson" --db "$db" --rerank --json
says out '^{"results":\[{"rank":1,'
lines out 1
first() { sed 's/^{"results":\[\({[^}]*}\).*/\1/' "$folder/$1" | grep -o '"model":"[^"]*"' | head -1; }
[ "$(first out)" = "$(first plain)" ] || fault "re-ranking changed the first: $(first plain) to $(first out)"
expect 0 "$croquis" eval models --db "$db" --json
says out '^{"models":4,"rows":{"parts":{"NN":'
lines out 1
rm "$folder/models/d.off"

echo "Dear all," >"$folder/letter.db"
for command in "build $folder/models" list "show 1" "remove 1" check vacuum; do
    # shellcheck disable=SC2086  # the words of the command
    expect 1 "$croquis" index $command --db "$folder/letter.db" --json
    says err "letter.db: it is no Croquis index and was left as it is"
    lines err 1
    lines out 0
done
[ "$(cat "$folder/letter.db")" = "Dear all," ] || fault "a file that is no index was altered"

# A file size limit stands for a full disk.
(
    ulimit -f 40
    write_model d.off 5
    expect 1 "$croquis" index build "$folder/models" --db "$folder/full.db" --json
    says err "full.db: "
    lines err 1
    exit "$faults"
) || faults=$((faults + 1))
expect 0 "$croquis" index build "$folder/models" --db "$folder/full.db" --json
expect 0 "$croquis" index check --db "$folder/full.db"

# Ctrl-C: what is in is whole, and the next call goes on.
for n in 1 2 3 4 5 6 7 8 9; do write_model "many$n.off" "$n"; done
"$croquis" index build "$folder/models" --db "$folder/c.db" --jobs 1 --json >"$folder/out" 2>"$folder/err" &
builder=$!
sleep 0.15
kill -INT "$builder" 2>/dev/null
wait "$builder"
expect 0 "$croquis" index build "$folder/models" --db "$folder/c.db" --json
expect 0 "$croquis" index check --db "$folder/c.db" --json
says out '^{"models":13,"damaged":\[\]}$'

if [ "$faults" -gt 0 ]; then
    echo "$faults faults"
    exit 1
fi
echo "croquis index: no fault"

#!/bin/sh
# The include check finds each kind of fault, at its place, and passes a tree that has none.
set -u
check=$(cd "$(dirname "$0")" && pwd)/include_direction.sh
tree=$(mktemp -d) || exit 1
trap 'rm -rf "$tree"' EXIT
failures=0

write() { # FILE LINE...
    file=$tree/$1
    shift
    mkdir -p "${file%/*}"
    printf '%s\n' "$@" >"$file"
}
fresh_tree() {
    rm -rf "${tree:?}"/*
    for module in core db input ui firmware_like_app tests; do
        write "$module/good.hpp" '#pragma once' '#include "core/base/result.hpp"'
        write "$module/good.cpp" "#include \"$module/good.hpp\"" '#include <vector>'
    done
    write firmware_like_app/all.cpp '#include "db/good.hpp"' '#include "input/good.hpp"' '#include "ui/good.hpp"'
    write core/skeleton/cdt.cpp '#include <CGAL/Triangulation_2.h>'
    write db/sqlite/database.cpp '#include <sqlite3.h>'
}
expect_fault() { # PLACE WORDS, after one more file was written
    if output=$(sh "$check" "$tree"); then
        echo "not found: $1 $2"
        failures=$((failures + 1))
    elif ! echo "$output" | grep -qF "$1: $2"; then
        echo "expected: $1: $2"
        echo "got:      $output"
        failures=$((failures + 1))
    fi
    fresh_tree
}

fresh_tree
sh "$check" "$tree" >/dev/null || { echo "a tree without faults does not pass: $(sh "$check" "$tree")"; failures=1; }

write core/base/a.cpp '' '#include "db/good.hpp"'
expect_fault core/base/a.cpp:2 'core may not include'
write ui/draw/a.cpp '#include "db/good.hpp"'
expect_fault ui/draw/a.cpp:1 'ui may not include'
write db/a.cpp '#  include "input/good.hpp"'
expect_fault db/a.cpp:1 'db may not include'
write input/a.hpp '#pragma once' '#include "firmware_like_app/good.hpp"'
expect_fault input/a.hpp:2 'input may not include'
write core/a.cpp '#include "../db/good.hpp"'
expect_fault core/a.cpp:1 '"../db/good.hpp" does not start at its module'
write db/stores/a.cpp '#include <sqlite3.h>'
expect_fault db/stores/a.cpp:1 '<sqlite3.h> belongs'
write core/skeleton/a.hpp '#pragma once' '#include <CGAL/Triangulation_2.h>'
expect_fault core/skeleton/a.hpp:2 '<CGAL/Triangulation_2.h> belongs'
write core/parts/a.cpp '#include <opencv2/imgproc.hpp>'
expect_fault core/parts/a.cpp:1 '<opencv2/imgproc.hpp> belongs'
write core/mesh/a.cpp '#include <assimp/scene.h>'
expect_fault core/mesh/a.cpp:1 '<assimp/scene.h> belongs'
write input/trace/a.cpp '#include <libudev.h>'
expect_fault input/trace/a.cpp:1 '<libudev.h> belongs'
write input/sources/a.hpp '#pragma once' '#include <hidapi/hidapi.h>'
expect_fault input/sources/a.hpp:2 '<hidapi/hidapi.h> belongs'
write ui/a.hpp '#pragma once' '#include <nlohmann/json.hpp>'
expect_fault ui/a.hpp:2 '<nlohmann/json.hpp> belongs'
write core/a.hpp '// no guard'
expect_fault core/a.hpp 'has no #pragma once'

[ "$failures" -eq 0 ] && echo "every kind of fault is found"
[ "$failures" -eq 0 ]

#!/bin/sh
# Reads every #include line of ours and says which of them its folder may not have.
#
#     include_direction.sh [ROOT]
#
# core stands alone; db, input and ui see core; firmware_like_app and tests see all. Third-party types stay out of our
# headers (Eigen excepted), and those that have one home stay at home. Every header has #pragma once.
# Exit code 1, after one line for each fault.
set -u
cd "${1:-$(dirname "$0")/../..}" || exit 1

sources=$(find core db input ui firmware_like_app tests \( -name '*.cpp' -o -name '*.hpp' \) -type f | LC_ALL=C sort)
count=$(echo "$sources" | wc -l)
if [ "$count" -lt 10 ]; then
    echo "include direction: $count source files found; is $(pwd) the root of the project?"
    exit 1
fi

# shellcheck disable=SC2086  # our file names have no spaces
awk '
function fault(text) { print FILENAME ":" FNR ": " text; faults++ }
function home(header, pattern, folder) {  # a third-party header that only the .cpp files of one folder may include
    if (header ~ pattern && module != "tests" && (in_header || index(FILENAME, folder "/") != 1))
        fault("<" header "> belongs in the .cpp files of " folder)
}
function end_of_file() {
    if (previous ~ /\.hpp$/ && !once) { print previous ": has no #pragma once"; faults++ }
}
BEGIN {
    sees["core"] = " core "
    sees["db"] = " core db "
    sees["input"] = " core input "
    sees["ui"] = " core ui "
    sees["firmware_like_app"] = " core db input ui firmware_like_app "
    sees["tests"] = " core db input ui firmware_like_app tests support unit "
}
FNR == 1 {
    end_of_file()
    previous = FILENAME
    once = 0
    module = FILENAME
    sub(/\/.*/, "", module)
    in_header = FILENAME ~ /\.hpp$/
}
/^[ \t]*#[ \t]*pragma[ \t]+once/ { once = 1 }
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, parts, "\"")
    target = parts[2]
    if (target ~ /^\.\.?\// || target !~ /\//) {
        if (module != "tests") fault("\"" target "\" does not start at its module")
        next
    }
    folder = target
    sub(/\/.*/, "", folder)
    if (!index(sees[module], " " folder " ")) fault(module " may not include \"" target "\"")
}
/^[ \t]*#[ \t]*include[ \t]*</ {
    header = $0
    sub(/^[^<]*</, "", header)
    sub(/>.*/, "", header)
    home(header, "^sqlite3", "db/sqlite")
    home(header, "^CGAL/", "core/skeleton")
    home(header, "^opencv2/", "core/silhouette")
    home(header, "^assimp/", "core/exchange")
    home(header, "^opensubdiv/", "core/garment")
    home(header, "^stb/stb_image[.]h", "core/exchange")
    home(header, "^(SDL|EGL/|GLES|hb|ft2build)", "ui")
    home(header, "^cairo", FILENAME ~ /^core\// ? "core/exchange" : "ui")
    home(header, "^CLI/", "firmware_like_app")
    home(header, "^toml[+][+]/", "firmware_like_app/config")
    home(header, "^(hidapi/|libinput[.]h|libudev[.]h|libwacom/)", "input/sources")
    if (header ~ /^pugixml/ && module != "tests" && FILENAME !~ /^core\/exchange\//)
        fault("<" header "> belongs in core/exchange")
    # What commands print is JSON, and several share its pieces; no other folder includes their headers.
    if (in_header && module != "tests" && header ~ /^(nlohmann|png|fmt)/ &&
        !(header ~ /^nlohmann/ && FILENAME ~ /^firmware_like_app\/commands\//))
        fault("<" header "> belongs in .cpp files")
}
END {
    end_of_file()
    if (faults) print faults " faults"
    exit faults > 0
}' $sources || exit 1
echo "include direction: $count files, no fault"

#!/bin/sh
# Are our source files formatted as .clang-format says? Names those that are not.
# Exit code 77 where there is no clang-format, 1 when a file is not formatted.
set -u
cd "$(dirname "$0")/../.." || exit 1
if ! command -v clang-format >/dev/null; then
    echo "skipped: clang-format is not installed"
    exit 77
fi
faults=$(find core db input ui firmware_like_app tests \( -name '*.cpp' -o -name '*.hpp' \) -type f -print0 |
    xargs -0 -n 16 -P 2 clang-format --dry-run -Werror 2>&1)
status=$?
if [ "$status" -ne 0 ]; then
    files=$(echo "$faults" | sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: error:.*/\1/p' | LC_ALL=C sort -u)
    [ -n "$files" ] || files=$faults
    echo "$files"
    echo "not formatted; to mend it: clang-format -i FILE..."
    exit 1
fi

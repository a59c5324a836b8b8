#!/bin/sh
# Installs the Debian packages that are missing, and nothing else.
#
#     ensure_packages.sh SECTION...     sections of packages.txt beside this file: build, run, check
#
# Silent and fast when all is there. Exit code 1, after one sentence, when packages are missing and cannot be installed.
set -u
list=$(dirname "$0")/packages.txt

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian system: what $list names has to be there already." >&2
    exit 0
fi

wanted=
for section in "$@"; do
    packages=$(awk -v section="[$section]" '/^\[/ { inside = ($1 == section); next } inside && /^[a-z0-9]/ { print $1 }' "$list")
    if [ -z "$packages" ]; then
        echo "$list has no section [$section]." >&2
        exit 1
    fi
    wanted="$wanted $packages"
done

# Word splitting is wanted from here on: package names have no spaces.
# shellcheck disable=SC2086
installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' $wanted 2>/dev/null) "
missing=
for package in $wanted; do
    case $installed in
        *" installed:$package "*) ;;
        *) missing="$missing $package" ;;
    esac
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "Packages are missing and only root may install them; as root, run: apt-get install --no-install-recommends$missing" >&2
        exit 1
    fi
    as_root=sudo
    [ -t 0 ] || as_root="sudo -n"  # with nobody there to type a password, fail rather than wait
fi

apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" </dev/null
}
# shellcheck disable=SC2086
install_missing() { apt install --no-install-recommends $missing; }
updated=
update() { apt update && updated=yes; }

echo "Installing:$missing"
# The package lists are fetched when there are none, or when what they name is no longer there.
# shellcheck disable=SC2086
apt-cache show $missing >/dev/null 2>&1 || update
install_missing || { [ -z "$updated" ] && update && install_missing; } || {
    echo "Installing packages failed (apt's own words are above); is the network there? By hand, as root:" \
         "apt-get update && apt-get install --no-install-recommends$missing" >&2
    exit 1
}

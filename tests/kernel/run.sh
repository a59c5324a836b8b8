#!/bin/sh
# The kernel's own decoding of pens against ours, report for report, in a virtual machine without a disk.
#
#     run.sh KERNEL_PEN OUT [DESCRIPTOR]...     files of report descriptors; our own generic pen is always among them
#
# A descriptor in a file named BUS:056A:PRODUCT.… whose product a data file of ours claims becomes that very Wacom tablet, so
# that the kernel's Wacom driver takes it. Every other becomes a tablet that no driver knows.
#
# KERNEL_PEN is the program of kernel_pen.cpp. Needs the Debian packages qemu-system-x86, cpio, gcc, and
# linux-image-amd64 or a kernel unpacked below $KERNEL_ROOT. Emulated, so it takes a minute or two; nothing is timed.
# Exit code 1 when a pen differs, 77 where a tool is missing.
set -eu
kernel_pen=$1
out=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
root=${KERNEL_ROOT:-}
vmlinuz=$(ls "$root"/boot/vmlinuz-* 2>/dev/null | tail -1)
for tool in qemu-system-x86_64 cpio gcc; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
[ -n "$vmlinuz" ] || { echo "skipped: there is no kernel below $root/boot"; exit 77; }
modules=$root/lib/modules/${vmlinuz##*/vmlinuz-}/kernel/drivers

mkdir -p "$out/root/modules"
"$kernel_pen" make "$out/root/work.txt" "$@"
gcc -O1 -static -o "$out/root/init" "$here/guest_init.c" 2>"$out/gcc.log" || { cat "$out/gcc.log"; exit 1; }
for module in input/evdev hid/hid hid/uhid hid/hid-generic hid/hid-multitouch hid/wacom hid/usbhid/usbhid usb/core/usbcore \
    usb/common/usb-common; do
    cp "$modules/$module.ko" "$out/root/modules/"
done
(cd "$out/root" && find . | cpio -o -H newc 2>/dev/null) | gzip -1 >"$out/initrd.gz"
setsid timeout -s KILL "${LIMIT:-600}" qemu-system-x86_64 -M q35 -accel tcg -cpu max -m 512 -kernel "$vmlinuz" \
    -initrd "$out/initrd.gz" -append "console=ttyS0 quiet loglevel=0 panic=-1 rdinit=/init" -display none -nic none \
    -serial "file:$out/serial.txt" -no-reboot
tr -d '\r' <"$out/serial.txt" >"$out/kernel.txt"
grep -q '^END$' "$out/kernel.txt" || { echo "the virtual machine did not finish; see $out/serial.txt"; exit 1; }
"$kernel_pen" check "$out/root/work.txt" "$out/kernel.txt"

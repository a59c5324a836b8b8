#!/bin/bash
# Opens the real window on a screen of its own (Xvfb), draws with the pointer, and looks at what is there.
#
#     window_test.sh PROGRAM FOLDER
#
# Leaves its pictures in FOLDER. Exit code 77: a tool is missing, so nothing was tested.
set -u
program=$1
folder=$2
for tool in Xvfb xdotool import convert; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
mkdir -p "$folder"

coproc XVFB { exec Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null; }
xvfb=$XVFB_PID
read -r -t 20 number <&"${XVFB[0]}" || { echo "Xvfb did not start"; exit 1; }
export DISPLAY=:$number
unset WAYLAND_DISPLAY
export SDL_VIDEODRIVER=x11
kiosk=
finish() {
    [ -n "$kiosk" ] && kill "$kiosk" 2>/dev/null
    kill "$xvfb" 2>/dev/null
}
trap finish EXIT
fail() { echo "FAILED: $*"; exit 1; }

# Mean of a region as a number 0 … 255, after turning it grey.
mean() { convert "$1" -crop "$2" +repage -colorspace Gray -format '%[fx:mean*255]' info: | cut -d. -f1; }
colours() { convert "$1" -crop "$2" +repage -colorspace HSL -channel G -separate -format '%[fx:maxima*255]' info: | cut -d. -f1; }
shot() { import -window root "$folder/$1.png"; }

"$program" --record "$folder/drawings" >"$folder/kiosk.log" 2>&1 &
kiosk=$!
window=
for _ in $(seq 100); do
    window=$(xdotool search --name '^Croquis$' 2>/dev/null | tail -1)
    [ -n "$window" ] && break
    kill -0 "$kiosk" 2>/dev/null || fail "the program ended: $(cat "$folder/kiosk.log")"
    sleep 0.1
done
[ -n "$window" ] || fail "no window"
# The first touch wakes the attract picture and draws nothing.
for _ in $(seq 50); do # the first frame
    shot attract
    [ "$(mean "$folder/attract.png" 200x20+1040+20)" -ge 250 ] && break
    sleep 0.2
done
xdotool mousemove 900 150 mousedown 1
sleep 0.1
xdotool mouseup 1
for _ in $(seq 50); do
    shot empty
    # The board stands on the left by now: it is darker than the sheet.
    [ "$(mean "$folder/empty.png" 200x200+900+50)" -ge 250 ] && [ "$(mean "$folder/empty.png" 8x300+8+250)" -le 244 ] && break
    sleep 0.2
done
sheet=$(mean "$folder/empty.png" 200x200+900+50)
[ "$sheet" -ge 250 ] || fail "the sheet is not on the screen (mean $sheet)"

draw() { # points x y x y …
    xdotool mousemove "$1" "$2" mousedown 1
    shift 2
    while [ $# -ge 2 ]; do
        xdotool mousemove "$1" "$2"
        sleep 0.02
        shift 2
    done
    xdotool mouseup 1
}
draw 620 350 660 340 760 335 860 340 960 335 1000 300 1040 240 1080 260 1110 280 1080 300 1050 310 1030 380 \
     1020 420 1020 520 990 520 985 430 860 425 720 425 700 520 670 520 665 420 620 400 600 480 590 470 600 400 620 350
sleep 1
for _ in $(seq 40); do
    shot drawn
    [ "$(colours "$folder/drawn.png" 376x212+24+100)" -ge 100 ] && break
    sleep 0.25
done
ink=$(convert "$folder/drawn.png" -crop 20x30+750+325 +repage -colorspace Gray -format '%[fx:minima*255]' info: | cut -d. -f1)
[ "$ink" -le 60 ] || fail "no ink where the pointer went (darkest $ink)"
card=$(colours "$folder/drawn.png" 376x212+24+100)
[ "$card" -ge 100 ] || fail "no coloured model on the best card (saturation $card)"

# The best card opens its model, large and coloured; "Keep drawing" brings the sheet back with its ink.
click() {
    xdotool mousemove "$1" "$2" mousedown 1
    sleep 0.1
    xdotool mouseup 1
    sleep 0.2
}
click 212 206
for _ in $(seq 40); do
    shot detail
    # where the tools stood there is paper now
    [ "$(mean "$folder/detail.png" 20x40+425+185)" -ge 240 ] && break
    sleep 0.25
done
[ "$(mean "$folder/detail.png" 20x40+425+185)" -ge 240 ] || fail "a tap on the best card did not open it"
sleep 0.6
shot detail
model=$(colours "$folder/detail.png" 500x330+580+270)
[ "$model" -ge 100 ] || fail "no coloured model after a tap on its card (saturation $model)"
click 100 56
sleep 0.7
shot back
ink=$(convert "$folder/back.png" -crop 20x30+750+325 +repage -colorspace Gray -format '%[fx:minima*255]' info: | cut -d. -f1)
[ "$ink" -le 60 ] || fail "the ink is gone after looking at a result (darkest $ink)"

# The screen is taken by another window and given back: everything is there again.
xdotool windowunmap --sync "$window"
sleep 0.3
xdotool windowmap --sync "$window"
sleep 0.7
shot regained
ink=$(convert "$folder/regained.png" -crop 20x30+750+325 +repage -colorspace Gray -format '%[fx:minima*255]' info: | cut -d. -f1)
[ "$ink" -le 60 ] || fail "the ink is gone after the window was hidden and shown (darkest $ink)"

xdotool windowsize --sync "$window" 1024 700 2>/dev/null
sleep 1
shot resized
kill -0 "$kiosk" 2>/dev/null || fail "the program did not survive a resize: $(cat "$folder/kiosk.log")"

# One more short stroke, then New: the sheet is empty again and the drawing was kept.
xdotool windowsize --sync "$window" 1280 800 2>/dev/null
sleep 0.7
xdotool mousemove 448 550 mousedown 1
sleep 0.1
xdotool mouseup 1
sleep 0.7
shot cleared
ink=$(convert "$folder/cleared.png" -crop 20x30+750+325 +repage -colorspace Gray -format '%[fx:minima*255]' info: | cut -d. -f1)
[ "$ink" -ge 240 ] || fail "New left ink on the sheet (darkest $ink)"
ls "$folder"/drawings/drawing-*.trace >/dev/null 2>&1 || fail "the drawing was not kept"

# Where drawings can be kept no more, as on a disk that is full, visitors draw on all the same.
rm -rf "$folder/drawings"
draw 620 350 660 340 760 335
sleep 0.3
xdotool mousemove 448 550 mousedown 1
sleep 0.1
xdotool mouseup 1
sleep 0.7
kill -0 "$kiosk" 2>/dev/null || fail "the program ended with its recording: $(cat "$folder/kiosk.log")"

# To Garment with the pointer: the figure stands on the sheet. An outline drawn round the hips on it becomes cloth.
click 337 52
for _ in $(seq 60); do
    shot figure
    [ "$(mean "$folder/figure.png" 30x30+873+190)" -le 240 ] && break
    sleep 0.5
done
figure=$(mean "$folder/figure.png" 30x30+873+190)
[ "$figure" -le 240 ] || fail "no figure on the sheet after a tap on Garment (mean $figure)"
sleep 1
draw 906 330 914 331 922 333 930 335 934 350 938 370 941 390 943 405 930 407 918 408 906 408 906 390 906 370 906 350 \
     906 332
for _ in $(seq 40); do
    shot cloth
    [ "$(colours "$folder/cloth.png" 20x20+912+360)" -ge 100 ] && break
    sleep 0.5
done
cloth=$(colours "$folder/cloth.png" 20x20+912+360)
[ "$cloth" -ge 100 ] || fail "no cloth where an outline was closed on the figure (saturation $cloth)"

xdotool key --window "$window" Escape
for _ in $(seq 50); do
    kill -0 "$kiosk" 2>/dev/null || break
    sleep 0.1
done
kill -0 "$kiosk" 2>/dev/null && fail "Escape did not end the program"
wait "$kiosk" || fail "the program ended with $?: $(cat "$folder/kiosk.log")"
kiosk=
cat "$folder/kiosk.log"
echo "the window showed ink and cards, came back after being hidden, and ended on Escape"

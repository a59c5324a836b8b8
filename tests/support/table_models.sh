# Models for tests of the command line; to be read with "." by a script that has set $folder, where models/ is.

# write_model NAME LEG: a seat with a back, on two rows of legs of that length.
write_model() {
    awk -v leg="$2" 'BEGIN {
        n = 0; m = 0
        split("-2 2 0 0.3 -1 1;-1.9 -1.5 -" leg " 0 -0.9 -0.5;1.5 1.9 -" leg " 0 0.5 0.9;-1.9 -1.6 0 2.5 -0.2 0.2", boxes, ";")
        for (b = 1; b <= 4; b++) {
            split(boxes[b], s, " ")
            for (i = 0; i < 8; i++) v[n++] = s[1 + int(i / 4)] " " s[3 + int(i / 2) % 2] " " s[5 + i % 2]
            split("0 1 3 2;4 6 7 5;0 4 5 1;2 3 7 6;0 2 6 4;1 5 7 3", faces, ";")
            for (k = 1; k <= 6; k++) {
                split(faces[k], c, " ")
                f[m++] = "4 " c[1] + n - 8 " " c[2] + n - 8 " " c[3] + n - 8 " " c[4] + n - 8
            }
        }
        print "OFF"; print n, m, 0
        for (i = 0; i < n; i++) print v[i]
        for (i = 0; i < m; i++) print f[i]
    }' >"$folder/models/$1"
}

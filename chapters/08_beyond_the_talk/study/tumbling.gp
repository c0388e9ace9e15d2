# Some of ten thousand. The program has projected the polygons; the third column is their paint:
# eight shades of orange, blue, green and grey.
call animation "tumbling.gif" 640 270 5
set palette maxcolors 32 defined ( \
    0 "#4a1d00", 3.5 "#a84a00", 7 "#ff9d4d", 7.999 "#ff9d4d", \
    8 "#00263f", 11.5 "#00609a", 15 "#62b8ee", 15.999 "#62b8ee", \
   16 "#003b2b", 19.5 "#008a64", 23 "#57d9b3", 23.999 "#57d9b3", \
   24 "#3a3a3a", 27.5 "#8a8a8a", 31 "#e6e6e6")
set cbrange [-0.5:31.5]
unset colorbox
unset border
unset tics
unset xlabel
unset ylabel
unset title
unset key
unset grid
unset xzeroaxis
unset yzeroaxis
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [-0.535:0.555]
set yrange [-0.24:0.22]
do for [i=0:79] {
    plot for [row=0:4] "tumbling.tsv" index 5*i + row using 1:2:3 \
        with filledcurves closed fs solid 1 noborder lc palette
}

# Every method on every extreme input that a run lets in: a cell each, its word a colour and a sign.
call figure "extremes.svg" 640 680 840
set xrange [-0.5:12.5]
set yrange [20.5:-0.5]
set border 0
unset grid
unset xzeroaxis
unset yzeroaxis
if (narrow) { set xtics rotate by 90 right scale 0 font ",14" offset 0,0 } \
else { set xtics rotate by 40 right scale 0 font ",12" offset 0.6,0 }
set ytics scale 0 font ",14"
set lmargin at screen (narrow ? 0.42 : 0.38)
set rmargin at screen 0.985
set tmargin at screen 0.985
set bmargin at screen (narrow ? 0.335 : 0.30)
unset key
set style fill solid 1.0 border rgb "white"
# refused, does not compile, exact, bounded, grows, not finite
colour(word) = word == 0 ? 0xcccccc : word == 1 ? 0xf4f4f4 : word == 2 ? 0x56b4e9 : word == 3 ? 0x009e73 : \
               word == 4 ? 0xe69f00 : 0xd55e00
sign(word) = word == 0 ? "✕" : word == 1 ? "–" : word == 2 ? "=" : word == 3 ? "○" : word == 4 ? "↑" : "∞"
meaning = "refused 'does not compile' exact bounded grows 'not finite, reported'"
do for [i = 0:5] {
    y = 0.2 - 0.034 * i
    set object 1 + i rectangle from screen 0.02, screen y - 0.0155 to screen 0.06, screen y + 0.0155 \
        fc rgb colour(i) fs solid border rgb "#999999"
    set label 1 + i sign(i) at screen 0.04, screen y center tc rgb on_paint font ",14"
    set label 7 + i word(meaning, 1 + i) at screen 0.075, screen y left tc rgb ink
}
# The last name leans out of the picture by itself: gnuplot refuses a longer one.
shown(method) = method eq "constant acceleration" ? "constant accel." : method
plot "extremes.tsv" using 1:2:(0.47):(0.45):(colour($3)):xticlabel(shown(strcol(4))):yticlabel(5) with boxxyerror lc rgb variable, \
     "" using 1:2:(sign($3)) with labels tc rgb on_paint font ",14"
# The next figure finds the axes as it expects them.
unset label
unset object
unset lmargin
unset rmargin
unset tmargin
unset bmargin
set xtics norotate center scale 0.6 font "" offset 0,0
set ytics scale 0.6 font ""
load style

# What a body costs: sorted by kind and mixed.
call figure "leave_out.svg" 640 420
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.85 border lc rgb ink
set boxwidth 0.9
set xtics nomirror
if (narrow) { set xtics font ",15" }
unset xlabel
set ylabel "a body and step (ns)"
set yrange [0:*]
set xrange [0.4:4.6]  # 0 is the line of names
unset xzeroaxis
set key outside bottom center horizontal reverse Left maxcols 2 samplen 1.5
plot "leave_out.tsv" using 2:xtic(1) lc rgb "#009e73" fs solid 0.9 title "sorted by kind", \
     "" using 3 lc rgb "#56b4e9" fs pattern 4 title "mixed, std::variant", \
     "" using 4 lc rgb "#0072b2" fs pattern 2 title "mixed, virtual", \
     "" using 5 lc rgb "#d55e00" fs solid 0.35 title "every body a box"
# The next figure finds the axes as it expects them.
set style data points
set xtics autofreq font ""
set autoscale
set xzeroaxis lc rgb soft lt 1

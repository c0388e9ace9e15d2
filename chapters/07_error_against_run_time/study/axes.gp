# call rooms."axes.gp" LEAST: both axes logarithmic, errors from LEAST up in percent where one thinks in percent.
set logscale xy
set xtics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "10^3" 1e3, "10^4" 1e4, "10^5" 1e5)
set ytics ("100 %%" 1, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3, "10^{-4}" 1e-4, "10^{-5}" 1e-5, "10^{-6}" 1e-6, \
    "10^{-7}" 1e-7, "10^{-9}" 1e-9, "10^{-11}" 1e-11, "10^{-13}" 1e-13, "10^{-15}" 1e-15)
set xrange [*:*]
set yrange [@ARG1:3]

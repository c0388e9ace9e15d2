# call figure NAME WIDTH HEIGHT: a still picture, in pixels of the page. The key is where gnuplot puts it
# again, whatever the figure before did with it.
set key default
set key noautotitle textcolor rgb ink
set output
set terminal svg size ARG2,ARG3 enhanced font "Helvetica Neue,Helvetica,Arial,sans-serif,17" background "#ffffff" linewidth 1 rounded
set output ARG1

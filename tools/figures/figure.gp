# call figure NAME WIDTH HEIGHT [HEIGHT_ON_A_PHONE]: a still picture, in pixels of the page. The key is where gnuplot
# puts it again, whatever the figure before did with it. Where style.gp says narrow = 1 it is drawn for a phone: as wide
# as `phone`, with letters of the same size, in the folder narrow.
set key default
set key noautotitle textcolor rgb ink
if (narrow) { set key samplen 2 }
set output
width = narrow ? phone : int(ARG2)
height = narrow ? (ARGC > 3 ? int(ARG4) : int(ARG3)) : int(ARG3)
set terminal svg size width,height enhanced font "Helvetica Neue,Helvetica,Arial,sans-serif,17" background "#ffffff" linewidth 1 rounded
set output (narrow ? "narrow/" : "").ARG1

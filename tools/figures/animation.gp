# call animation NAME WIDTH HEIGHT DELAY: every plot is a frame. Drawn at twice the size that it is
# shown at, so that its lines are smooth on the page.
set output
if (narrow) {
    set terminal dumb 40 20  # a film is the same on a phone: none is drawn
    set output "/dev/null"
} else {
    set terminal gif animate delay ARG4 loop 0 optimize size 2*ARG2,2*ARG3 enhanced font "DejaVuSans,30" linewidth 2 rounded background "#ffffff"
    set output ARG1
}

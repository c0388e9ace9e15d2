# call figure NAME WIDTH HEIGHT: a still picture, in pixels of the page.
set output
set terminal svg size ARG2,ARG3 enhanced font "Helvetica Neue,Helvetica,Arial,sans-serif,17" background "#ffffff" linewidth 1 rounded
set output ARG1

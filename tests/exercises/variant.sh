# One answer out of correct.cpp or of the build's NAME_mistakes.hpp, as a learner would hand it in:  sh variant.sh FILE NAME
# What stands before the first answer belongs to each of them.
sed '/^namespace /,$d; /^\/\//d' "$1"
sed -n "/^namespace $2 {\$/,/^}  \/\/ namespace $2\$/p" "$1" | sed '1d;$d'

# One answer out of correct.cpp or mistakes.cpp, as a learner would hand it in:  sh variant.sh FILE NAME
grep '^#include' "$1"
echo
sed -n "/^namespace $2 {\$/,/^}  \/\/ namespace $2\$/p" "$1" | sed '1d;$d'

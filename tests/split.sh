# Puts each of the sources that stand one after the other in FROM/*.cpp, below a line  // ---- its name
# into a file of its own, INTO/its_name.cpp:  sh split.sh FROM INTO
# (SOURCE in what it includes is the folder of the course.)
source=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$2"
mkdir -p "$2" || exit
awk -v folder="$2" -v source="$source" '
    FNR == 1 { file = "" }
    /^\/\/ ---- / {
        if (file != "") close(file)
        file = substr($0, 9)
        gsub(/ /, "_", file)
        file = folder "/" file ".cpp"
        next
    }
    file != "" { gsub(/"SOURCE\//, "\"" source "/"); print >file }
' "$1"/*.cpp

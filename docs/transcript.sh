# One exercise from the file that the learner gets to a pass, as it is seen on a terminal:
#   sh transcript.sh COURSE SOURCE BUILD FOLDER
# COURSE is the course program that takes its places from the environment. Works on a copy in FOLDER.
set -eu
course=$1 source=$2 build=$3 folder=$4

rm -rf "$folder"
mkdir -p "$folder/chapters" "$folder/exercises" "$folder/tests"
ln -s "$source/solutions" "$folder/solutions"
ln -s "$source/tests/exercises" "$folder/tests/exercises"
for solution in "$source"/solutions/*/*.cpp; do
    name=$(basename "$solution" .cpp) chapter=$(basename "$(dirname "$solution")")
    mkdir -p "$folder/chapters/$chapter" "$folder/exercises/$chapter"
    cp "$source/chapters/$chapter/about.json" "$folder/chapters/$chapter"
    cp "$build/exercises/generated/${name}_stub.cpp" "$folder/exercises/$chapter/$name.cpp"
done
cd "$folder"
file=exercises/01_derivatives/velocity_now.cpp

run() {
    echo "\$ ./course $*"
    # What a slow machine waits for is not the reader's.
    FIXTURE_SOURCE=$folder FIXTURE_BUILD=$build FIXTURE_CMAKE=true FIXTURE_CTEST=false "$course" "$@" 2>&1 |
        grep -v '^Waiting for ' || true
    echo
}
# answer LINE: what the learner writes in place of the line before
answer() {
    cp "$build/exercises/generated/velocity_now_stub.cpp" "$file"
    sed "s|.*return not_started;.*|    $1|" "$file" >new && mv new "$file"
    echo "(the file says now)     $1"
    echo
}

run check velocity_now
answer 'return (x2 - x1) / hh;'
run check velocity_now --seed 1
answer 'return (x2 - x1) / h;'
run check velocity_now --seed 1
run hint velocity_now
# The last answer is the reader's to find: this page stands in the learner's edition, too.
cp solutions/01_derivatives/velocity_now.cpp "$file"
echo "(the file holds the right answer now, which is yours to find)"
echo
run check velocity_now --seed 1

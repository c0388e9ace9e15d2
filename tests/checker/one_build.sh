# How often a check runs the build tool: once where the exercise is new, never where only the answer is.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"
. "$here/fixture.sh"

# builds NUMBER COMMAND…: the command runs CMake so often.
builds() {
    number=$1
    shift
    : >calls
    expect 1 env FIXTURE_SOURCE="$folder/source" FIXTURE_BUILD="$folder/build" FIXTURE_CMAKE="$folder/cmake" FIXTURE_CTEST=false "$@"
    is "$* $(lines calls)" "$* $number"
}

# A build folder of this fixture's own, and what a check is made of.
new_build() {
    own_build
    for part in ready hidden; do ln -s "$real_build/exercises/$part" build/exercises; done
    printf '#!/bin/sh\necho "$*" >>"%s/calls"\n' "$folder" >cmake
    chmod +x cmake
    mkdir -p source/include source/tools/cmake source/tools/checker source/tools/processes
    cp -r "$source/include" "$source/CMakeLists.txt" source
    cp "$source/tests/CMakeLists.txt" source/tests
    cp "$source/tests/exercises/CMakeLists.txt" source/tests/exercises
    echo cache >build/CMakeCache.txt
}

test_a_first_check_builds_once_and_a_second_never() {
    new_build
    builds 1 "$program" check velocity_now
    is "$(cat calls | grep -o ' --target .*')" ' --target ready_velocity_now'
    builds 0 "$program" check velocity_now
    cp "$mistake" $file
    builds 0 "$program" check velocity_now
    builds 0 "$program" check
    builds 1 "$program" check best_gap
    touch source/include/timestep/run.hpp
    builds 1 "$program" check velocity_now
    builds 0 "$program" check velocity_now
}

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"

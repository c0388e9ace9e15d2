# A fixture for a learner: what is needed to check, and a checkout to work in.

# The exercises of a chapter.
add_chapter() {
    mkdir -p "source/chapters/$1" source/tests/exercises "source/exercises/$1" source/solutions
    cp "$source/chapters/$1/about.json" "source/chapters/$1"
    cp -r "$source/tests/exercises/$1" source/tests/exercises
    cp -r "$source/solutions/$1" source/solutions
    for solution in "$source/solutions/$1"/*.cpp; do
        name=$(basename "$solution" .cpp)
        cp "$real_build/exercises/generated/${name}_stub.cpp" "source/exercises/$1/$name.cpp"
    done
}

# A checkout with the exercises of one chapter and the build's ready parts.
new_fixture() {
    mkdir build
    add_chapter 01_derivatives
    ln -s "$real_build/exercises" build/exercises
    file=source/exercises/01_derivatives/velocity_now.cpp
    solved=source/solutions/01_derivatives/velocity_now.cpp
    mistake=mistake_middle.cpp
    sh "$source/tests/exercises/variant.sh" "$real_build/exercises/generated/velocity_now_mistakes.hpp" middle >$mistake
}

course() {
    FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=true FIXTURE_CTEST=false "$program" "$@"
}

state() {
    course list --json >list.json || fail 'list --json'
    sed -n "/\"exercise\": \"$1\"/,/\"file\"/s/.*\"state\": \"\(.*\)\".*/\1/p" list.json
}

# own_build COMPILER: a build folder for this fixture alone. COMPILER, a script's text, is the compiler of answers;
# none given: the real one.
own_build() {
    rm build/exercises
    mkdir build/exercises
    ln -s "$real_build/exercises/generated" build/exercises/generated
    cp "$real_build/exercises/commands.json" build/exercises
    [ $# -eq 0 ] || {
        { echo 'case " $* " in *_stub.cpp*) exit ;; esac'; echo "$1"; } >compiler
        sed "s|\"compile\": \[\"[^\"]*\"|\"compile\": [\"sh\", \"$folder/compiler\"|" \
            "$real_build/exercises/commands.json" >build/exercises/commands.json
    }
}

# In the background, in `running`; with Ctrl-C as it is on a terminal, where the system can do that.
start_course() {
    FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        env $default_signals "$program" "$@" >said 2>&1 &
    running=$!
    trap 'kill $running 2>/dev/null' EXIT
}
default_signals=
! env --default-signal=INT true 2>/dev/null || default_signals=--default-signal=INT

# wait_until COMMAND…: ends the test where it is not so after many looks, some ten minutes: on a busy
# machine everything takes its time.
wait_until() {
    for _ in $(seq 6000); do
        ! "$@" || return 0
        sleep 0.1
    done
    fail "waited in vain for: $*"
}

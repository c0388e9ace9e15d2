# What teachers copy from docs/teaching: with a kit whose `course` is the course program on a fixture.

. "$(dirname "$0")/class.sh"

# kit IN: a folder kit there.
kit() {
    mkdir -p "$1/kit"
    cat >"$1/kit/course" <<END
#!/bin/sh
[ "\$1" != setup ] || exit 0
for word; do shift; [ "\$word" = --yes ] || set -- "\$@" "\$word"; done
export FIXTURE_SOURCE='$folder/source' FIXTURE_BUILD='$folder/build' FIXTURE_CMAKE=true FIXTURE_CTEST=false
exec '$program' "\$@"
END
    chmod +x "$1/kit/course"
}

test_gradescope_gets_its_results() {
    kit autograder/source
    mkdir -p autograder/submission autograder/results bin
    printf '#!/bin/sh\n' >bin/apt-get
    chmod +x bin/apt-get
    export AUTOGRADER="$folder/autograder"
    expect 0 env PATH="$folder/bin:$PATH" sh "$source/docs/teaching/setup.sh"
    cp $solved autograder/submission/velocity_now.cpp
    expect 0 sh "$source/docs/teaching/run_autograder"
    says autograder/results/results.json '"score": 1'
    says autograder/results/results.json '"max_score": 1'
    says autograder/results/results.json '"status": "passed"'
    cp "$mistake" autograder/submission/velocity_now.cpp
    EXERCISES='velocity_now 1.2' expect 0 sh "$source/docs/teaching/run_autograder"
    is "$(grep -c '"score": 0' autograder/results/results.json)" 2
    says autograder/results/results.json 'This is the central difference'
    rm autograder/submission/velocity_now.cpp
    EXERCISES=velocity_now expect 0 sh "$source/docs/teaching/run_autograder"
    says autograder/results/results.json 'nothing was handed in'
    cp $solved autograder/submission/main.cpp
    EXERCISES=velocity_now expect 0 sh "$source/docs/teaching/run_autograder"
    says autograder/results/results.json '"score": 1'
    expect 0 sh "$source/docs/teaching/run_autograder"
    says autograder/results/results.json 'No file has the name of an exercise'
    rm -r autograder/submission
    expect 1 sh "$source/docs/teaching/run_autograder"
    EXERCISES=velocity_nwo expect 1 sh "$source/docs/teaching/run_autograder"
    [ ! -e autograder/results/results.json ] || fail 'results of another run'
}

test_classroom_passes_and_fails() {
    needs_isolation
    kit .
    mkdir -p submission/exercises/01_derivatives
    command=$(sed -n 's/^ *command: //p' "$source/docs/teaching/classroom.yml")
    cp $solved submission/exercises/01_derivatives/velocity_now.cpp
    expect 0 sh -c "$command"
    cp "$mistake" submission/exercises/01_derivatives/velocity_now.cpp
    expect 1 sh -c "$command"
    says out 'This is the central difference'
    rm submission/exercises/01_derivatives/velocity_now.cpp
    expect 1 sh -c "$command"
}

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"

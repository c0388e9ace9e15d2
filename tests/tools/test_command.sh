# Tests of `course test`, with a real ctest on a handful of small tests.

here=$(dirname "$0")
. "$here/expect.sh"
. "$here/fixture.sh"

# tests NAME=STATUS…: what ctest finds in the build folder; 77 is a skip.
tests() {
    for test; do
        printf 'add_test("%s" sh -c "echo words of %s; exit %s")\n' \
            "${test%=*}" "${test%=*}" "${test#*=}"
        printf 'set_tests_properties("%s" PROPERTIES SKIP_RETURN_CODE 77)\n' "${test%=*}"
    done >build/CTestTestfile.cmake
}

test_a_failing_test_shows_its_words() {
    tests one=0 two=0
    expect 0 course test
    says out '100% tests passed, 0 tests failed out of 2'
    says calls 'quick_tests docs'
    tests one=0 'number two=5'
    expect 1 course test
    says out 'words of number two'
    silent_on out 'words of one'
}

test_skipped_checks_are_counted_with_the_command_that_helps() {
    tests one=0 'pages in a browser=77' 'memory checker=77'
    expect 0 course test
    says out 'Skipped: 2, because this machine lacks what they need; ./course setup --all installs it'
    says out 'memory checker (Skipped)'
    expect 1 course test --all
    says err 'course: 2 skipped, which --all counts as failed'
}

# label NAME LABELS
label() { echo "set_tests_properties(\"$1\" PROPERTIES LABELS \"$2\")" >>build/CTestTestfile.cmake; }

test_long_tests_are_left_to_all_and_to_release() {
    tests one=0 'headers stand alone=5' 'Windows: by wine=5'
    label 'headers stand alone' long
    label 'Windows: by wine' release
    expect 0 course test
    silent_on out 'words of headers'
    says out './course test --all runs the tests that take longer'
    expect 1 course test --all
    says calls 'all docs kit'
    says out 'words of headers'
    silent_on out 'words of Windows'
    expect 1 course test --release
    says out 'words of Windows'
}

test_no_test_or_a_failed_build_is_a_failure() {
    tests
    expect 1 course test
    tests one=0
    echo 1 >build_status
    expect 1 course test
    silent_on out 'Test #1'
    says err 'course: the build failed'
}

ctest=$6
begin "$@"
new_fixture "$4" "$5"
"$function"

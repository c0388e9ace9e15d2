# Tests of tools/cmake/compile_what_changed.sh, with a compiler that notes when it compiles.

here=$(dirname "$0")
. "$here/expect.sh"

new_project() {
    command -v g++ >/dev/null || exit 77
    cat >compiler <<END
#!/bin/sh
case " \$* " in *' -E '*) ;; *) echo compiled >>'$folder/calls' ;; esac
exec g++ "\$@"
END
    chmod +x compiler
    printf '// what f does\ninline int f() { return 1; }\n' >f.hpp
    printf '#include "f.hpp"\nconst char* words() { return "// no comment"; }\nint main() { return f(); }\n' >main.cpp
    : >calls
    compile
    is "$(lines calls)" 1
}
compile() {
    expect 0 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler "$@" -MD -MT main.o -MF main.d \
        -o main.o -c main.cpp
}
# compiles NUMBER: so often it was compiled since the last look.
compiles() {
    is "$(lines calls)" "$1"
    : >calls
}

test_a_comment_compiles_nothing() {
    new_project
    : >calls
    for change in 's/what/all that/' '1i// one line more' 's|$|  // more|'; do
        sed -i "$change" f.hpp
        rm main.d
        : >before
        compile
        compiles 0
        [ main.o -nt before ] || [ ! before -nt main.o ] || fail 'the object looks old'
        says main.d f.hpp
    done
}

test_what_is_more_than_a_comment_is_compiled() {
    new_project
    : >calls
    sed -i 's/return 1/return 7/' f.hpp
    compile
    compiles 1
    g++ main.o -o main && ./main && fail 'not the new one'
    sed -i 's|// no comment|// another|' main.cpp
    compile
    compiles 1
    sed -i 's/return 7/return __LINE__/' f.hpp
    compile
    compiles 1
    sed -i '1i// one line more' f.hpp  # moves __LINE__
    compile
    compiles 1
    compile -DX=1
    compiles 1
    compile -DX=1
    compiles 0
    compile -O1
    compiles 1
    printf '\nexec g++ "$@"  # another compiler\n' >>compiler
    compile -O1
    compiles 1
    rm main.o
    compile -O1
    compiles 1
}

# A program that says where a function is called: in main.cpp, beside a library that everything includes.
new_caller() {
    mkdir -p library support study
    printf '// what f does\ninline int f() { return 0; }\n' >library/f.hpp
    printf '// who calls?\ninline int caller(int line = __builtin_LINE()) { return line; }\n' >support/caller.hpp
    if [ "${1-}" = std ]; then
        printf '#include <source_location>\nusing Place = std::source_location;\n\
inline int caller(Place place = Place::current()) { return place.line(); }\n' >support/caller.hpp
    fi
    printf '#pragma once\ninline int beside() { return caller(); }\n' >study/beside.hpp
    cat >study/main.cpp <<'END'
#include <stdio.h>
#include "f.hpp"
#include "caller.hpp"
#include "beside.hpp"
// the call
int main() { return printf("%d %d", caller(), beside()) * f(); }
END
    : >calls
    compile_caller
    compiles 1
    calls_from 6 2
}
compile_caller() {
    expect 0 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler -std=c++20 -Ilibrary -Isupport "$@" -MD -MT main.o \
        -MF main.d -o main.o -c "$folder/study/main.cpp"
}
calls_from() {
    g++ main.o -o main || fail 'no program'
    is "$(./main || :)" "$1 $2"
}

test_a_call_that_has_moved_is_compiled() {
    new_project
    for kind in builtin std; do
        new_caller $kind
        # No line of a call moves by what is said in the library, or at the end of a line.
        sed -i '1i// one line more' library/f.hpp
        compile_caller
        compiles 0
        sed -i 's|// the call|// a call|' study/main.cpp
        compile_caller
        compiles 0
        # In the source, by a comment, a long comment, a blank line; and in a header beside it.
        sed -i '1i// one line more' study/main.cpp
        compile_caller
        compiles 1
        calls_from 7 2
        { seq 20 | sed 's|^|// |'; cat study/main.cpp; } >longer
        cp longer study/main.cpp
        compile_caller
        compiles 1
        calls_from 27 2
        sed -i '5i\\' study/main.cpp
        compile_caller
        compiles 1
        calls_from 28 2
        sed -i '2i// one line more' study/beside.hpp
        compile_caller
        compiles 1
        calls_from 28 3
        compile_caller
        compiles 0
    done
}

# Several sources compiled as one, which includes them from elsewhere (CMake's unity builds).
test_a_call_that_has_moved_in_one_of_many_is_compiled() {
    new_project
    new_caller
    mkdir -p Unity
    printf '#include "%s"\n' "$folder/study/main.cpp" >Unity/unity_0_cxx.cxx
    compile_many
    compiles 1
    calls_from 6 2
    sed -i '1i// one line more' library/f.hpp
    compile_many
    compiles 1  # in a folder of the project like any other, as nobody knows which is the sources'
    compile_many
    compiles 0
    sed -i '1i// one line more' study/main.cpp
    compile_many
    compiles 1
    calls_from 7 2
    sed -i 's/, beside()/, 2/; s/caller()/7/' study/main.cpp
    sed -i '/caller.hpp/d; /beside.hpp/d' study/main.cpp
    compile_many
    compiles 1
    sed -i '1i// one line more' library/f.hpp  # nobody asks
    compile_many
    compiles 0
}
compile_many() {
    expect 0 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler -std=c++20 -I"$folder/library" -I"$folder/support" -MD -MT main.o \
        -MF main.d -o main.o -c "$folder/Unity/unity_0_cxx.cxx"
}

test_a_line_that_has_moved_within_what_asks_is_compiled() {
    new_project
    new_caller
    printf '// asks itself\ninline int own() { return __builtin_LINE(); }\n' >library/f.hpp
    sed -i 's/caller(), beside()) [*] f()/own(), beside())/' study/main.cpp
    compile_caller
    compiles 1
    calls_from 2 2
    sed -i '1i// one line more' library/f.hpp
    compile_caller
    compiles 1
    calls_from 3 2
}

# A header compiled beforehand is an object of its own: its list of what it has read does not stand in those of others.
test_what_is_read_beforehand_counts() {
    new_project
    printf '// asks\ninline int caller(int line = __builtin_LINE()) { return line; }\n' >early.hpp
    echo '#include "early.hpp"' >ready.hxx
    : >ready.hxx.cxx
    : >calls
    printf 'int words() { return 0; }\nint main() { return caller(); }\n' >main.cpp
    compile_both
    compiles 2
    sed -i '1i// one line more' early.hpp  # which asks for lines, its own count
    compile_both
    compiles 2
    sed -i 's|// asks|// it asks|' early.hpp
    compile_both
    compiles 0
    sed -i '1i// one line more' main.cpp
    compile_both
    compiles 0
    compile_both "-DNEAR" "$folder/main.cpp"  # beside the source lines count
    compiles 2
    sed -i '1i// one line more' main.cpp
    compile_both "-DNEAR" "$folder/main.cpp"
    compiles 1
    sed -i 's/return line/return line + 100/' early.hpp
    compile_both "-DNEAR" "$folder/main.cpp"
    compiles 2
    g++ main.o -o main || fail 'no program'
    ./main || is $? 104
}
compile_both() {
    set -- "${1--DALONE}" "${2-main.cpp}"
    expect 0 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler "$1" -x c++-header -include "$folder/ready.hxx" \
        -MD -MT ready -MF ready.d -o "$folder/ready.hxx.gch" -c "$folder/ready.hxx.cxx"
    expect 0 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler "$1" -Winvalid-pch -include "$folder/ready.hxx" \
        -MD -MT main.o -MF main.d -o main.o -c "$2"
}

test_what_fails_is_tried_again() {
    new_project
    : >calls
    sed -i 's/return 1;/return 1/' f.hpp
    expect 1 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler -o main.o -c main.cpp
    says err 'error: expected'
    compiles 1
    sed -i 's/return 1/return 1;/' f.hpp
    compile
    compiles 1
    rm f.hpp
    expect 1 sh "$source/tools/cmake/compile_what_changed.sh" ./compiler -o main.o -c main.cpp
    says err 'f.hpp: No such file'
}

begin "$@"
"$function"

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

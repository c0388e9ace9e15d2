# A machine of fakes: $folder/bin is all there is on PATH, $folder/usr all there is of headers.
# What is asked of apt-get, sudo and cmake is kept in $folder/calls.

# What stands there is a link to the real one: it must go first.
fake() { rm -f "bin/$1"; printf '#!/bin/sh\n%s\n' "$2" >"bin/$1"; chmod +x "bin/$1"; }

# new_machine USER_ID: with apt-get, apt-cache and nothing that the course needs.
new_machine() {
    mkdir -p bin usr checkout/tools apt tmp
    cp "$source/course" checkout/course
    cp "$source/tools/set_up.sh" checkout/tools
    for tool in sh cat sed grep tail head tee env mkdir mktemp rm mv touch chmod readlink tr cp find uname flock; do
        ln -s "$(command -v $tool)" bin/$tool
    done
    : >calls
    fake id "echo $1"
    # apt-get install NAME leaves $folder/apt/NAME's files in place.
    fake apt-get "echo \"apt-get \$*\" >>'$folder/calls'
[ ! -e '$folder/apt_fails' ] || { echo 'E: Unable to fetch some archives'; exit 100; }
for word; do last=\$word; case \$word in
    install) installing=yes ;; update) installing= ;; -*) ;;
    *) [ -z \"\$installing\" ] || [ ! -e '$folder/apt/'\$word ] || {
        echo \"Setting up \$word (1.0) ...\"; . '$folder/apt/'\$word; } ;;
esac; done"
    fake apt-cache "case \$1 in
policy) case \$2 in
    catch2) echo '  Candidate: '\$(cat '$folder/catch2_version') ;;
    *) echo '  Candidate: 6.4.1+dfsg1-3' ;;
    esac ;;
madison) echo ' catch2 | 2.13.10-1 | http://mirror.example/debian bookworm/main amd64 Packages' ;;
esac"
    echo 3.7.1-1 >catch2_version
    # What each leaves is what tools/set_up.sh looks for.
    sed -n 's/^\([a-z0-9+.-]*\)  *have_\(one\|file\|platform\) \([^ ]*\).*/\1 \3/p' "$source/tools/set_up.sh" >"$folder/offered"
    cat >>"$folder/offered" <<'END'
g++ g++
catch2 include/catch2/catch_all.hpp
libsundials-dev include/arkode/arkode_erkstep.h
libc++-dev lib/llvm-14/include/c++/v1
libc++abi-dev lib/llvm-14/include/c++/v1
libc++-dev-wasm32 lib/llvm-14/include/wasm32-wasi/c++/v1
END
    while read -r package what; do
        case $what in
        */*) echo "mkdir -p '$folder/usr/${what%/*}'; : >'$folder/usr/$what'" ;;
        *) echo ": >'$folder/bin/$what'; chmod +x '$folder/bin/$what'" ;;
        esac >"apt/$package"
    done <"$folder/offered"
    echo "printf '#!/bin/sh\necho $folder/usr/clang\n' >'$folder/bin/clang++'
mkdir -p '$folder/usr/clang/lib/linux'; : >'$folder/usr/clang/lib/linux/libclang_rt.asan-x86_64.a'" >apt/libclang-rt-dev
    echo "cp '$folder/cmake_3.25.1' '$folder/bin/cmake'" >apt/cmake
    make_cmake 3.25.1
}

# have PACKAGE…: it is there from the beginning.
have() { for package; do sh "$folder/apt/$package"; done; }
have_all() {
    have g++ cmake ninja-build libeigen3-dev catch2 gnuplot-nox doxygen doxygen-awesome-css \
        libjs-katex libjs-lunr libcli11-dev nlohmann-json3-dev valgrind libc++-dev-wasm32
}

# A CMake that configures by leaving a cache, and builds a course program that tells its arguments.
make_cmake() {
    cat >"cmake_$1" <<END
#!/bin/sh
[ "\$1" != --version ] || { echo "cmake version $1"; exit; }
echo "cmake \$*" >>'$folder/calls'
case \$1 in
-S) [ ! -e '$folder/configure_fails' ] || { echo 'CMake Error: no'; exit 1; }
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=\$2" >"\$4/CMakeCache.txt"
    echo 'build course' >"\$4/build.ninja" ;;
--build) [ ! -e '$folder/build_fails' ] || { echo 'error: no'; exit 1; }
    mkdir -p "\$2/tools/course"
    printf '#!/bin/sh\necho "handed over: \$*"\nexit 7\n' >"\$2/tools/course/course"
    chmod +x "\$2/tools/course/course" ;;
esac
END
    chmod +x "cmake_$1"
}

# sudo that lets everything through (yes) or nothing (no).
have_sudo() {
    fake sudo "echo \"sudo \$*\" >>'$folder/calls'
[ $1 = yes ] || exit 1
case \$1 in -v) exit ;; -n) shift ;; esac
\"\$@\""
    ln -s "$(command -v true)" bin/true
}

# The script, with this machine's things only.
course() { env -i PATH="$folder/bin" TMPDIR="$folder/tmp" COURSE_PLACES="$folder/usr" COURSE_PACKAGES="$folder/packages" \
    "$folder/checkout/course" "$@"; }

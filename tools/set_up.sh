# What the course needs, whether it is there, and how it is installed. ./course reads this file where something
# may be missing; it has set root, build and kit, and has the words say, stop and on_terminal.

# What the course needs: the Debian package, and how to see that it (or its like) is there.
needs='
g++                  have_compiler
cmake                have_cmake 3 25
ninja-build          have_one ninja ninja-build
libeigen3-dev        have_file include/eigen3/Eigen/Core
catch2               have_catch2
gnuplot-nox          have_one gnuplot
doxygen              have_one doxygen
doxygen-awesome-css  have_file share/doxygen-awesome-css/doxygen-awesome.css
libjs-katex          have_file share/javascript/katex/katex.min.js
libjs-lunr           have_file share/javascript/lunr/lunr.min.js
libcli11-dev         have_file include/CLI/CLI.hpp
nlohmann-json3-dev   have_file include/nlohmann/json.hpp
valgrind             have_one valgrind
'
# What lets the site's panels move: wished for where the site is made, and done without where a system has none.
wishes='
clang                    have_wasm
lld                      have_wasm
wasi-libc                have_wasm
libc++-dev-wasm32        have_wasm
libclang-rt-dev-wasm32   have_wasm
'
# The other desks of tests/same_bits: arm64, Windows, 32 bits, and the C++ library of macOS and its like.
desks='
libc++-dev                 have_libcxx
libc++abi-dev              have_libcxx
nodejs                     have_one node nodejs
g++-aarch64-linux-gnu      have_desk aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
qemu-user                  have_desk qemu-aarch64 qemu-user
g++-i686-linux-gnu         have_desk i686-linux-gnu-g++ g++-i686-linux-gnu
g++-mingw-w64-x86-64-posix have_desk x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
wine                       have_desk wine wine
'
# What only some checks need, and the libraries that chapter 7 measures beside ours: installed by --all,
# skipped by the tests where it is not there.
extras="
clang                have_one clang++
libclang-rt-dev      have_sanitizers_of clang++
chromium             have_one chromium google-chrome
chromium-driver      have_one chromedriver
poppler-utils        have_one pdftotext
clang-format         have_one clang-format
python3-selenium     have_file lib/python3/dist-packages/selenium/__init__.py
libboost-dev         have_file include/boost/numeric/odeint.hpp
libgsl-dev           have_file include/gsl/gsl_odeiv2.h
libsundials-dev      have_sundials
libbullet-dev        have_file include/bullet/BulletDynamics/Dynamics/btRigidBody.h
libode-dev           have_file include/ode/ode.h
$desks"
# What grade needs, to shut strangers' code away.
isolation='
bubblewrap           have_one bwrap
'
# Where headers and the like may be, besides what the reader tells CMake.
places=${COURSE_PLACES:-/usr/local /usr /opt/homebrew}
places="$(echo "${CMAKE_PREFIX_PATH:-}" | tr ':;' '  ') $places"

# ---- What is there? ----------------------------------------------------------------------------

have_one() { for name; do command -v "$name" >/dev/null && return; done; return 1; }
have_file() { for place in $places; do [ -e "$place/$1" ] && return; done; return 1; }
# shellcheck disable=SC2086  # CXX may carry options
have_compiler() { set -- ${CXX:-c++}; have_one "$1" c++ g++ clang++; }
# Of a learner's edition: of the kind that it was made with, unless the reader names one (CMakeLists.txt).
have_compiler_of_kit() { [ -n "${CXX:-}" ] && have_compiler || have_one "$1"; }
have_cmake() {
    found=$(cmake --version 2>/dev/null | sed -n '1s/[^0-9]*\([0-9]*\)\.\([0-9]*\).*/\1 \2/p')
    [ -n "$found" ] && { [ "${found% *}" -gt "$1" ] ||
        { [ "${found% *}" -eq "$1" ] && [ "${found#* }" -ge "$2" ]; }; }
}
# C++ for WebAssembly stands where Clang's version says.
have_wasm() {
    for place in $places; do
        set -- "$place"/lib/llvm-*/include/wasm32-wasi/c++/v1
        [ ! -e "$1" ] || return 0
    done
    return 1
}
# A compiler for another processor: not wished for on other machines than these, nor where the system has no such package.
have_desk() {
    have_one "$1" || [ "$(uname -m)" != x86_64 ] || [ "$(candidate "$2")" = '(none)' ]
}
have_libcxx() {
    for place in $places; do
        set -- "$place"/lib/llvm-*/include/c++/v1
        [ ! -e "$1" ] || return 0
    done
    return 1
}
have_sanitizers_of() {
    set -- "$("$1" -print-resource-dir 2>/dev/null)"/lib/*/libclang_rt.asan*
    [ -e "$1" ]
}
# Catch2 3 and no older one; or the copy that CMake has fetched.
have_catch2() {
    have_file include/catch2/catch_all.hpp || [ -e "$build/_deps/catch2-src/CMakeLists.txt" ]
}

# SUNDIALS 6; a system that has another version is left as it is.
have_sundials() {
    have_file include/arkode/arkode_erkstep.h || case $(candidate libsundials-dev) in
    6.*) return 1 ;;
    esac
}
# The version of the package $1 that apt-get would install.
candidate() { apt-cache policy "$1" 2>/dev/null | sed -n 's/^ *Candidate: //p'; }

# The packages of the list $1 that are not there, on one line.
missing() {
    echo "$1" | while read -r package look; do
        [ -z "$package" ] || $look || printf '%s ' "$package"
    done
}

# The wishes that are not there and that this system has, or may have: one without lists of packages is not asked.
missing_wishes() {
    [ -z "$kit" ] && [ ! -e "$build/panels_stand_still" ] || return 0
    wish=$(missing "$wishes")
    [ -z "$wish" ] || have_one apt-get || {
        say_panels_stand_still "there is no apt-get here to install what they need, in Debian $wish"
        return
    }
    for package in $wish; do
        case "$(candidate "$package")/$(candidate gnuplot-nox)" in
        '(none)'/* | /?*) say_panels_stand_still "this system has no package $package"; return ;;
        esac
    done
    printf '%s' "$wish"
}
# Once for a build folder.
say_panels_stand_still() {
    say "the site's panels stand still: $1"
    mkdir -p "$build" && : >"$build/panels_stand_still"
}
panels_stand_still() { say_panels_stand_still "$1. This lets them move: $apt_install $(missing "$wishes")"; }

# ---- Installing --------------------------------------------------------------------------------

apt_install='apt-get install --yes --no-install-recommends'

# Runs apt-get with the arguments given, its words kept in $log. Shows it at work: on a terminal in
# one line, elsewhere by a line for each package that we named.
apt() {
    { $sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes \
        -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" </dev/null 2>&1; echo "status $?"; } | tee -a "$log" |
    while read -r line; do
        name=${line#Setting up }
        if [ -t 2 ]; then
            printf '\r\033[K  %.70s' "$line" >&2
        elif [ "$name" != "$line" ]; then
            case " $wanted" in *" ${name%% *} "*) say "  ${name% ...}" ;; esac
        fi
    done
    [ ! -t 2 ] || printf '\r\033[K' >&2
    [ "$(tail -n 1 "$log")" = 'status 0' ]
}

# Is there a Catch2 3 among the packages of this system?
offers_catch2() {
    case $(candidate catch2) in
    '' | [012].* | '(none)') return 1 ;;
    esac
}

# Debian 12 itself has Catch2 2; its backports have Catch2 3. We take it from there, on the mirror
# that this machine uses for Catch2 2, by a source list of our own: the machine's is not touched.
catch2_from_backports() {
    ! have_file include/catch2/catch.hpp || return 1  # somebody uses Catch2 2: leave it alone
    # shellcheck disable=SC2046  # its words: catch2 | version | mirror suite/main …
    set -- $(apt-cache madison catch2 2>/dev/null | tail -n 1)
    [ $# -ge 6 ] || return 1
    mirror=$5 suite=${6%/*}
    own=$(mktemp -d) && mkdir "$own/lists" && chmod 755 "$own" "$own/lists" || return 1
    keys=/usr/share/keyrings/debian-archive-keyring.gpg
    [ -e $keys ] && keys="[signed-by=$keys]" || keys=
    echo "deb $keys $mirror $suite-backports main" >"$own/sources.list"
    set -- -o Dir::Etc::SourceList="$own/sources.list" -o Dir::Etc::SourceParts=- \
        -o Dir::State::Lists="$own/lists" -o Dir::Cache="$own"
    say "Catch2 3 comes from $suite-backports; your list of package sources stays as it is"
    apt "$@" update && apt "$@" install --no-remove -t "$suite-backports" catch2
    status=$?
    $sudo rm -rf "$own"
    return $status
}

# Installs what is needed alone, after the wishes have failed with it.
without_wishes() {
    [ -n "$wished" ] || return 1
    panels_stand_still 'apt-get failed'
    packages=${packages%"$wished"}
    # shellcheck disable=SC2086  # a list of words
    [ -z "$packages" ] || apt install --no-install-recommends $packages
}

# No right to install: says which command to give somebody who has it.
refuse() {
    packages=$wanted
    offers_catch2 || packages=$(echo "$wanted" | sed 's/catch2 //')  # CMake fetches it
    say "$1. This command installs what is missing:"
    if have_one sudo; then
        echo "  sudo apt-get update; sudo $apt_install ${packages% }" >&2
    else
        echo "  su -c 'apt-get update; $apt_install ${packages% }'" >&2
    fi
    exit 3
}

# Installs the packages in $wanted.
install() {
    if ! have_one apt-get; then
        say "this machine lacks what Debian calls: ${wanted% }"
        stop 3 "There is no apt-get here to install it; install it by hand and start again"
    fi
    if [ "$wanted" = 'catch2 ' ] && [ "$(id -u)" -ne 0 ]; then
        say 'there is no Catch2 3 here; CMake fetches its source'
        return
    fi

    say "this machine lacks: ${wanted% }"
    if [ "$(id -u)" -eq 0 ]; then
        sudo=
    elif have_one sudo; then
        sudo=sudo
    elif [ "$wanted" = "$wished" ]; then
        panels_stand_still 'you are not root, so I cannot install what they need'
        return
    else
        refuse 'you are not root, so I cannot install it'
    fi
    if on_terminal && [ "$yes" = no ]; then
        printf 'course: install it now with apt-get? [Y/n] ' >&2
        read -r answer || answer=n
        case $answer in
        '' | [yY]*) ;;
        *)
            [ "$wanted" != "$wished" ] || { panels_stand_still 'nothing was installed'; return; }
            refuse 'nothing was installed'
            ;;
        esac
    fi
    if [ -n "$sudo" ]; then
        if on_terminal; then sudo -v; else sudo -n true 2>/dev/null; fi || {
            [ "$wanted" != "$wished" ] || { panels_stand_still 'sudo does not let me install what they need'; return; }
            refuse 'sudo does not let me install it'
        }
    fi

    log=$(mktemp)
    say 'installing it, and what it needs in turn; this takes a minute or two'
    apt update || say 'could not bring the lists of packages up to date; trying with the old ones'
    packages=$wanted
    offers_catch2 || packages=$(echo "$wanted" | sed 's/catch2 //')
    # shellcheck disable=SC2086  # a list of words
    [ -z "$packages" ] || apt install --no-install-recommends $packages || without_wishes ||
        stop 3 "apt-get failed: $(sed -n 's/^E: //p' "$log" | head -n 1) (all that it said: $log)"
    case $wanted in *"catch2 "*)
        have_catch2 || catch2_from_backports ||
            say 'no package of Catch2 3 could be installed; CMake will fetch its source instead' ;;
    esac
    left=$(missing "$list" | sed 's/catch2 //')
    [ -z "$left" ] || stop 3 "still missing or too old: $left(all that apt-get said: $log)"
    rm -f "$log"
}

# Sees to it that all is there that the command needs; `installed` says whether anything had to be. The words are
# those given to ./course, the command first.
set_up() {
    command=$1
    list=$needs
    [ -z "$kit" ] || {
        grep -q '"compiler": "Clang"' "$root/kit/kit.json" && made_by='clang clang++' || made_by='g++ g++'
        list=$(echo "$needs" | sed "s/^g++ .*/${made_by% *} have_compiler_of_kit ${made_by#* }/" |
            grep -v -e '^catch2' -e '^doxygen' -e '^libjs-katex' -e '^libjs-lunr' -e '^valgrind')
    }
    without=$list
    [ "$command" != grade ] || list=$list$isolation
    yes=no
    for word; do
        case "$command $word" in
        *' --') break ;;
        *' --yes' | *' -y') yes=yes ;;
        'grade --trust') list=$without ;;
        'setup --all' | 'test --all' | 'test --release') list=$list$isolation$extras ;;
        esac
    done
    installed=no
    wished=
    case $command in tour | test | setup | kit) wished=$(missing_wishes) ;; esac
    wanted=$(missing "$list")$wished
    [ -z "$wanted" ] || { install; installed=yes; }
}

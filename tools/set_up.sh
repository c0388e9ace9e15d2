# What the course needs, and how it is installed. ./course reads this file when something may be missing; it has set root,
# build and kit, and defines say, stop and on_terminal.

# Debian packages, each with the test that it, or something equivalent, is there.
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
# Packages that compile the site's panels for the browser. Without them the panels stand still.
for_panels='
clang                    have_libcxx include/wasm32-wasi/c++/v1
lld                      have_libcxx include/wasm32-wasi/c++/v1
wasi-libc                have_libcxx include/wasm32-wasi/c++/v1
libc++-dev-wasm32        have_libcxx include/wasm32-wasi/c++/v1
libclang-rt-dev-wasm32   have_libcxx include/wasm32-wasi/c++/v1
'
# Other platforms for tests/same_bits: arm64, Windows, 32 bits, and libc++, which macOS uses.
platforms='
libc++-dev                 have_libcxx include/c++/v1
libc++abi-dev              have_libcxx include/c++/v1
nodejs                     have_one node nodejs
g++-aarch64-linux-gnu      have_platform aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
qemu-user                  have_platform qemu-aarch64 qemu-user
g++-i686-linux-gnu         have_platform i686-linux-gnu-g++ g++-i686-linux-gnu
g++-mingw-w64-x86-64-posix have_platform x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
wine                       have_platform wine wine
'
# Packages for some tests, and the libraries that chapter 7 compares with ours. --all installs them; tests that need a
# missing one are skipped.
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
$platforms"
# What grade needs to isolate submissions.
isolation='
bubblewrap           have_one bwrap
'
# Where headers may be, besides CMAKE_PREFIX_PATH.
places=${COURSE_PLACES:-/usr/local /usr /opt/homebrew}
places="$(echo "${CMAKE_PREFIX_PATH:-}" | tr ':;' '  ') $places"

# ---- What is there? ----------------------------------------------------------------------------

have_one() { for name; do command -v "$name" >/dev/null && return; done; return 1; }
have_file() { for place in $places; do [ -e "$place/$1" ] && return; done; return 1; }
# shellcheck disable=SC2086  # CXX may carry options
have_compiler() { set -- ${CXX:-c++}; have_one "$1" c++ g++ clang++; }
# A learner's edition needs a compiler of the kind that made it, unless the reader names one (CMakeLists.txt).
have_compiler_of_kit() { [ -n "${CXX:-}" ] && have_compiler || have_one "$1"; }
have_cmake() {
    found=$(cmake --version 2>/dev/null | sed -n '1s/[^0-9]*\([0-9]*\)\.\([0-9]*\).*/\1 \2/p')
    [ -n "$found" ] && { [ "${found% *}" -gt "$1" ] ||
        { [ "${found% *}" -eq "$1" ] && [ "${found#* }" -ge "$2" ]; }; }
}
# libc++ is in a folder with Clang's version.
have_libcxx() {
    headers=$1
    for place in $places; do
        set -- "$place"/lib/llvm-*/"$headers"
        [ ! -e "$1" ] || return 0
    done
    return 1
}
# A compiler for another processor: only needed on x86-64, and only if the system has such a package.
have_platform() {
    have_one "$1" || [ "$(uname -m)" != x86_64 ] || [ "$(candidate "$2")" = '(none)' ]
}
have_sanitizers_of() {
    set -- "$("$1" -print-resource-dir 2>/dev/null)"/lib/*/libclang_rt.asan*
    [ -e "$1" ]
}
# Catch2 3 and no older one; or the copy that CMake has fetched.
have_catch2() {
    have_file include/catch2/catch_all.hpp || [ -e "$build/_deps/catch2-src/CMakeLists.txt" ]
}

# SUNDIALS 6; another version of the system counts as there.
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

# The missing packages for panels, if this system has them all, or has no lists of packages yet.
missing_for_panels() {
    [ -z "$kit" ] && [ ! -e "$build/panels_stand_still" ] && have_one apt-get || return 0
    lacking=$(missing "$for_panels")
    for package in $lacking; do
        case "$(candidate "$package")/$(candidate gnuplot-nox)" in '(none)'/* | /?*) return ;; esac
    done
    printf '%s' "$lacking"
}

# ---- Installing --------------------------------------------------------------------------------

apt_install='apt-get install --yes --no-install-recommends'

# Runs apt-get with these arguments; its output goes to $log. Shows progress: on a terminal in one line, elsewhere in a
# line for each package that we named.
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

# Does this system have a package of Catch2 3?
offers_catch2() {
    case $(candidate catch2) in
    '' | [012].* | '(none)') return 1 ;;
    esac
}

# Debian 12 has Catch2 2; its backports have Catch2 3. It is installed from there, from the mirror that this machine uses,
# by a source list of our own: the machine's own list stays as it is.
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

# Without the right to install: prints the command for somebody who has it. If only packages for panels are missing, says
# so once per build folder and goes on.
refuse() {
    [ "$wanted" != "$wanted_for_panels" ] || {
        say "the site's panels stand still: $1. This lets them move: $apt_install $wanted"
        mkdir -p "$build" && : >"$build/panels_stand_still"
        return
    }
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
    else
        refuse 'you are not root, so I cannot install it'
        return
    fi
    if on_terminal && [ "$yes" = no ]; then
        printf 'course: install it now with apt-get? [Y/n] ' >&2
        read -r answer || answer=n
        case $answer in
        '' | [yY]*) ;;
        *) refuse 'nothing was installed'; return ;;
        esac
    fi
    if [ -n "$sudo" ]; then
        if on_terminal; then sudo -v; else sudo -n true 2>/dev/null; fi || {
            refuse 'sudo does not let me install it'
            return
        }
    fi

    log=$(mktemp)
    say 'installing it, and what it needs in turn; this takes a minute or two'
    apt update || say 'could not bring the lists of packages up to date; trying with the old ones'
    packages=$wanted
    offers_catch2 || packages=$(echo "$wanted" | sed 's/catch2 //')
    # shellcheck disable=SC2086  # a list of words
    [ -z "$packages" ] || apt install --no-install-recommends $packages ||
        { [ "$wanted" = "$wanted_for_panels" ] && refuse 'apt-get failed'; } ||
        stop 3 "apt-get failed: $(sed -n 's/^E: //p' "$log" | head -n 1) (all that it said: $log)"
    case $wanted in *"catch2 "*)
        have_catch2 || catch2_from_backports ||
            say 'no package of Catch2 3 could be installed; CMake will fetch its source instead' ;;
    esac
    left=$(missing "$list" | sed 's/catch2 //')
    [ -z "$left" ] || stop 3 "still missing or too old: $left(all that apt-get said: $log)"
    rm -f "$log"
}

# Installs what the command lacks. Called with the arguments of ./course; sets `installed` to yes if anything was missing.
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
    wanted_for_panels=
    case $command in tour | test | setup | kit) wanted_for_panels=$(missing_for_panels) ;; esac
    wanted=$(missing "$list")$wanted_for_panels
    [ -z "$wanted" ] || { install; installed=yes; }
}

# Words for the tests in this folder. Each test is a function, called as
#   sh SCRIPT FUNCTION FOLDER SOURCE …
# and runs in an empty FOLDER.

fail() {
    printf 'FAILED: %s\n' "$*"
    [ ! -e out ] || { echo '--- standard output'; cat out; echo '--- standard error'; cat err; }
    exit 1
}

# expect STATUS COMMAND…: the command ends with this status. Keeps what it says in `out` and `err`.
expect() {
    status=$1
    shift
    "$@" >out 2>err </dev/null && got=0 || got=$?
    [ "$got" -eq "$status" ] || fail "exit status $got instead of $status: $*"
}

# says FILE TEXT: the file has a line with this text. silent_on does not.
says() { grep -qF -e "$2" "$1" || fail "$1 does not say: $2"; }
silent_on() { ! grep -qF -e "$2" "$1" || fail "$1 says: $2"; }
is() { [ "$1" = "$2" ] || fail "'$1' instead of '$2'"; }
lines() { grep -c '' "$1"; }

begin() {
    function=$1 folder=$2 source=$3
    rm -rf "$folder"
    mkdir -p "$folder"
    cd "$folder" || exit 1
    folder=$(pwd -P)
}

# A panel as a program.

refused() {
    line=$1
    shift
    expect 2 "$panel" "$@"
    is "$(cat err)" "panel: $line"
    is "$(cat out)" ''
}

test_bad_words_are_refused() {
    known='steps, grab, drag, let_go, clock, omega_h, x, v, cloud'
    refused "omega=1: is none of $known" omega=1
    refused "--help: is none of $known" --help
    refused ": is none of $known" ''
    refused 'omega_h=3: must be a number from 0.01 to 2.2' omega_h=3
    refused 'omega_h=nan: must be a number from 0.01 to 2.2' omega_h=nan
    refused 'omega_h=: must be a number from 0.01 to 2.2' omega_h=
    refused 'omega_h=1x: must be a number from 0.01 to 2.2' omega_h=1x
    refused 'steps=-1: steps must be a whole number from 0 to 1e9' steps=-1
    refused 'steps=1.5: steps must be a whole number from 0 to 1e9' steps=1.5
    refused 'grab=1: must be grab=x,y' grab=1
    refused 'clock=0: clock must be a number of ms above zero' clock=0
    refused '--still: needs the name of a file' --still
    refused 'nowhere/a.svg: cannot be written' --still nowhere/a.svg
}

test_the_same_words_end_on_the_same_bits() {
    expect 0 "$panel" omega_h=0.5 steps=100
    mv out first
    expect 0 "$panel" omega_h=0.5 steps=60 steps=40
    cmp -s out first || fail 'the same steps end elsewhere'
    expect 0 "$panel" omega_h=0.5 steps=101
    ! cmp -s out first || fail 'another step changes nothing'
}

test_what_blows_up_says_when() {
    expect 0 "$panel" omega_h=2.2 steps=60
    says out 'explicit Euler blew up at step '
    says out 'semi-implicit Euler blew up at step '
    silent_on out 'explicit Euler blew up at step 60'
    expect 0 "$panel" omega_h=1.9 steps=10000
    silent_on out 'semi-implicit'' Euler blew up'
}

. "$(dirname "$0")/../tools/expect.sh"
panel=$4
begin "$@"
"$function"

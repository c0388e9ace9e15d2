# Does the script that looks for leaks find them?

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# A kit with nothing but what is handed out on purpose.
new_kit() {
    mkdir -p kit/site kit/kit kit/exercises
    cp -r "$source/chapters" "$source/include" kit
    cp "$source/README.md" kit
}

test_each_planted_leak_is_found() {
    room=tests/exercises/01_derivatives/velocity_now
    # A solution in place of a stub; an answer of short lines; a line of a mistake in a comment.
    cp "$source/solutions/01_derivatives/velocity_now.cpp" kit/exercises
    sed -n '/\[answer\]/,/\[answer\]/p' "$source/solutions/01_derivatives/best_gap.cpp" |
        grep -v answer | tr '\n' ' ' >kit/notes.txt
    line=$(sed -n 's/^[+]\(.*return.*\)/\1/p' "$source/tests/exercises/04_verlet/tighten_rope/mistakes.diff" |
        awk 'length > 40' | head -n 1)
    [ -n "$line" ] || fail 'no line to plant'
    echo "// once it was   $line" >>kit/include/timestep/state.hpp
    # A hidden test on a page, and its expressions in a program; an archive.
    sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; s/"/\&quot;/g; s/(/<span class="b">(<\/span>/g
         s/^/<a id="l00001"><\/a><span class="lineno">    1<\/span>\&#160; /' \
        "$source/$room/properties.cpp" >kit/site/properties_8cpp_source.html
    cp "$with_strings" kit/kit/check
    : >kit/more.tar.gz
    expect 1 "$leaks" "$source" kit
    for file in exercises/velocity_now.cpp notes.txt include/timestep/state.hpp site/properties_8cpp_source.html kit/check \
        more.tar.gz; do
        says out "kit/$file: "
    done
    says out ': 6 files leak'
}

leaks=$4 with_strings=$5
begin "$@"
command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; }
new_kit
"$function"

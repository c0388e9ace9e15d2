# Does the program that looks for leaks find them? Each test plants one.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# A kit with nothing but what is handed out on purpose.
new_kit() {
    mkdir -p kit/site kit/kit
    cp -r "$source/chapters" "$source/include" kit
    cp "$source/README.md" kit
}

# planted FILE: it is found, and named.
planted() {
    expect 1 "$leaks" "$source" kit
    says out "kit/$1: "
}

room=tests/exercises/01_derivatives/velocity_now

test_there_is_none_where_none_was_planted() {
    expect 0 "$leaks" "$source" kit
    says out ': 0 files leak'
}

test_a_solution_in_place_of_a_stub() {
    mkdir -p kit/exercises
    cp "$source/solutions/01_derivatives/velocity_now.cpp" kit/exercises
    planted exercises/velocity_now.cpp
}

test_an_answer_of_short_lines() {
    sed -n '/\[answer\]/,/\[answer\]/p' "$source/solutions/01_derivatives/best_gap.cpp" |
        grep -v answer | tr '\n' ' ' >kit/notes.txt
    planted notes.txt
}

test_a_line_of_a_mistake_in_a_comment() {
    line=$(sed -n 's/^[+]\(.*return.*\)/\1/p' "$source/tests/exercises/04_verlet/tighten_rope/mistakes.diff" |
        awk 'length > 40' | head -n 1)
    [ -n "$line" ] || fail 'no line to plant'
    echo "// once it was   $line" >>kit/include/timestep/state.hpp
    planted include/timestep/state.hpp
}

test_a_hidden_test_on_a_page() {
    sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; s/"/\&quot;/g; s/(/<span class="b">(<\/span>/g
         s/^/<a id="l00001"><\/a><span class="lineno">    1<\/span>\&#160; /' \
        "$source/$room/properties.cpp" >kit/site/properties_8cpp_source.html
    planted site/properties_8cpp_source.html
}

test_a_program_with_the_expressions_of_a_hidden_test() {
    cp "$with_strings" kit/kit/check
    planted kit/check
}

test_what_is_packed() {
    head -c 500 "$source/LICENSE" >kit/more.tar.gz
    planted more.tar.gz
}

leaks=$4 with_strings=$5
begin "$@"
new_kit
"$function"

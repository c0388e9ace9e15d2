# cmake -DIN=words.txt -DOUT=words_txt.cpp -P words.cmake: the text as C++. Each section is a literal of its own, as some
# compilers end one at 16 KB.
file(READ "${IN}" text)
string(REPLACE "\n[" "\n)words\"\n  R\"words([" text "${text}")
file(WRITE "${OUT}" "namespace timestep {\nextern const char* const words_txt;\nconst char* const words_txt = R\"words(${text})words\";\n}\n")

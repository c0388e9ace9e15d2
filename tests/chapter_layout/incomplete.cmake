# Takes one thing after another out of a chapter: the configuration must fail, and say what is
# missing where.
include("${CMAKE_CURRENT_LIST_DIR}/fixture.cmake")

set_fixture()
set(room "${fixture}/chapters/01_small")
set(about "{\"title\": \"Small\", \"question\": \"Why?\", \"needs\": [], \"builds_on\": [],
 \"claims\": [\"N01\"], \"picture\": \"one.svg\", \"figures\": [\"one.svg\"]}\n")

# The chapter, whole. The configuration looks at the names of its files, not into them.
function(furnish)
  file(WRITE "${room}/about.json" "${about}")
  file(WRITE "${room}/chapter.md" "# Small\n")
  file(WRITE "${room}/small.cpp" "int main() {}\n")
  file(WRITE "${room}/figures.gp" "load style\n")
  file(WRITE "${room}/study/study.cpp" "int main() {}\n")
  file(WRITE "${room}/study/figures.gp" "load style\n")
  file(WRITE "${fixture}/tests/chapters/01_small.cpp" "TEST_CASE(\"small\", \"[N01]\") {}\n")
endfunction()

macro(must_fail what words)
  configure(-DTIMESTEP_TESTS=OFF -DTIMESTEP_DOCS=OFF)
  string(FIND "${output}" "${words}" place)
  if(status EQUAL 0)
    message(SEND_ERROR "${what}: the configuration succeeds")
  elseif(place EQUAL -1)
    message(SEND_ERROR "${what}: must say \"${words}\", but says: ${output}")
  endif()
  furnish()
endmacro()

furnish()
configure(-DTIMESTEP_TESTS=OFF -DTIMESTEP_DOCS=OFF)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the whole chapter must be configured, but: ${output}")
endif()

foreach(file chapters/01_small/about.json chapters/01_small/chapter.md chapters/01_small/small.cpp
             chapters/01_small/figures.gp chapters/01_small/study/study.cpp
             chapters/01_small/study/figures.gp tests/chapters/01_small.cpp)
  file(REMOVE "${fixture}/${file}")
  must_fail("without ${file}" "chapter 01_small: ${file} is missing")
endforeach()

file(WRITE "${fixture}/tests/chapters/01_small.cpp" "int nothing;\n")
must_fail("a test file without a test" "tests/chapters/01_small.cpp holds no TEST_CASE")

foreach(key title question needs builds_on claims picture figures)
  string(JSON without REMOVE "${about}" ${key})
  file(WRITE "${room}/about.json" "${without}")
  must_fail("about.json without ${key}" "chapters/01_small/about.json: ${key} is missing")
  string(JSON wrong SET "${about}" ${key} 7)
  file(WRITE "${room}/about.json" "${wrong}")
  must_fail("about.json with ${key} = 7" "chapters/01_small/about.json: ${key} must be ")
endforeach()
foreach(mistake
    "title|\"\"|title must be words"
    "picture|\"two.svg\"|picture is two.svg, must be one of figures"
    "figures|[]|figures is empty"
    "figures|[\"one.png\"]|figures names one.png, must be name.svg or name.gif"
    "figures|[\"sub/one.svg\"]|figures names sub/one.svg, must be"
    "needs|[\"boost\"]|needs names boost"
    "builds_on|[\"02_none\"]|builds_on names 02_none, which is no chapter")
  string(REPLACE "|" ";" mistake "${mistake}")
  list(GET mistake 0 key)
  list(GET mistake 1 value)
  list(GET mistake 2 words)
  string(JSON wrong SET "${about}" ${key} "${value}")
  file(WRITE "${room}/about.json" "${wrong}")
  must_fail("${key} = ${value}" "chapters/01_small/about.json: ${words}")
endforeach()
file(WRITE "${room}/about.json" "{ \"title\": ")
must_fail("a torn about.json" "chapters/01_small/about.json: is not JSON")

# A claim of the talks is one chapter's.
file(COPY "${room}/" DESTINATION "${fixture}/chapters/02_more")
file(RENAME "${fixture}/chapters/02_more/small.cpp" "${fixture}/chapters/02_more/more.cpp")
file(COPY_FILE "${fixture}/tests/chapters/01_small.cpp" "${fixture}/tests/chapters/02_more.cpp")
must_fail("a claim of two chapters" "chapters/02_more/about.json: claims names N01, which chapters/01_small claims")
file(REMOVE_RECURSE "${fixture}/chapters/02_more")

foreach(name small 1_small 01-small 01_Small)
  file(MAKE_DIRECTORY "${fixture}/chapters/${name}")
  must_fail("a folder ${name}" "chapters/${name}: a chapter's folder is named NN_name")
  file(REMOVE_RECURSE "${fixture}/chapters/${name}")
endforeach()

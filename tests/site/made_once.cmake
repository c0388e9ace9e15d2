# Is the target docs done when it is done? Called as
#   cmake -DBUILD=folder -DPAGE=index.html -P made_once.cmake
file(TIMESTAMP "${PAGE}" before "%s%f")
execute_process(COMMAND ${CMAKE_COMMAND} --build "${BUILD}" --target docs
  RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
file(TIMESTAMP "${PAGE}" after "%s%f")
if(NOT status EQUAL 0 OR NOT before STREQUAL after)
  message(FATAL_ERROR "The site was made again, though nothing had changed:\n${words}")
endif()

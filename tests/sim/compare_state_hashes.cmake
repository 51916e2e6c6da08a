# Runs the program that prints state hashes and compares what it prints with the expected list.
#   PROGRAM   the program
#   EXPECTED  the file with the expected lines
if(NOT EXISTS ${PROGRAM})
  message(FATAL_ERROR "${PROGRAM} is not built; expected after `cmake --build BUILD --target builds_apart`")
endif()
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE actual RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${PROGRAM} failed: ${failed}")
endif()
file(READ ${EXPECTED} expected)
if(NOT actual STREQUAL expected)
  message(FATAL_ERROR "The states differ.\nexpected (${EXPECTED}):\n${expected}\nactual:\n${actual}\n"
                      "If the method was meant to change, accept the new states: ${PROGRAM} > ${EXPECTED}")
endif()
message(STATUS "the states are the same, bit for bit")

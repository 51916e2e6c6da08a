# Runs the program that prints state hashes and compares what it prints with the expected list.
#   PROGRAM    the program; or, to build it first into BUILD_DIR:
#   COMPILER   g++ or clang++    LEVEL  O0 or O3    SOURCE_DIR  the project
#   EXPECTED   the file with the expected lines
if(NOT PROGRAM)
  file(GLOB sources ${SOURCE_DIR}/sim/*.cpp ${SOURCE_DIR}/sim/solvers/*.cpp
       ${SOURCE_DIR}/sim/solvers/bounded/*.cpp)
  set(include ${BUILD_DIR}/include)
  file(MAKE_DIRECTORY ${include})
  file(CREATE_LINK ${SOURCE_DIR}/sim ${include}/sim SYMBOLIC)
  set(PROGRAM ${BUILD_DIR}/state_hashes)
  if(LEVEL STREQUAL "O0")
    set(level_flags -O0 -g)
  else()
    set(level_flags -O3 -DNDEBUG)
  endif()
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -ffp-contract=off ${level_flags} -I${include} ${sources}
            ${SOURCE_DIR}/tests/sim/state_hashes.cpp -lhwy -o ${PROGRAM}
    RESULT_VARIABLE failed ERROR_VARIABLE errors)
  if(failed)
    message(FATAL_ERROR "${COMPILER} -${LEVEL} cannot build the program (is it installed? run ./setup.sh):\n${errors}")
  endif()
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

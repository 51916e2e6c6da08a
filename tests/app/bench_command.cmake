cmake_minimum_required(VERSION 3.25)
# Runs the benchmark on its smallest cell; the table, the JSON and the pictures have to be there.
file(REMOVE_RECURSE ${DIR})
execute_process(
  COMMAND ${PROGRAM} bench --sizes 1028 --scenes shaken --bounds 0.02,0.5 --engines strong --seconds 0.1
          --output ${DIR}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT result EQUAL 0 OR NOT output MATCHES "shaken, 1028 triangles.*50 %  strong .*2 %  strong .*wrote ${DIR}/bench.pdf")
  message(FATAL_ERROR "exit code ${result}\n${output}${errors}")
endif()
file(READ ${DIR}/bench.json json)
string(JSON frames GET "${json}" heats 0 runs 0 frames)
string(JSON bound GET "${json}" heats 0 cells 0 bound)
string(JSON kept GET "${json}" heats 0 cells 0 kept)
if(NOT frames EQUAL 6 OR NOT bound EQUAL 0.5 OR NOT kept)
  message(FATAL_ERROR "found ${frames} frames, ${bound}, ${kept}:\n${json}")
endif()
file(READ ${DIR}/bench.png begin LIMIT 8 HEX)
file(READ ${DIR}/bench.pdf page HEX)
if(NOT begin STREQUAL "89504e470d0a1a0a" OR NOT page MATCHES "^255044462d.*2525454f460a$")
  message(FATAL_ERROR "the pictures are not complete")
endif()
execute_process(COMMAND ${PROGRAM} bench --sizes 1028 --seconds 0.02 --engines strong --json
  RESULT_VARIABLE result OUTPUT_VARIABLE json)
string(JSON scene ERROR_VARIABLE wrong GET "${json}" heats 0 scene)
if(NOT scene STREQUAL "hanging")
  message(FATAL_ERROR "--json printed no JSON: ${wrong}\n${json}")
endif()

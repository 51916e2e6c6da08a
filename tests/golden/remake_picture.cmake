# Draws ARGUMENTS with TAUT, then draws again from the picture alone, in another folder; COMPARE has to find
# the pixels equal, and the second picture has to carry the same record.
file(REMOVE_RECURSE ${OUTPUT_DIR})
file(MAKE_DIRECTORY ${OUTPUT_DIR}/elsewhere)
execute_process(COMMAND ${TAUT} render ${ARGUMENTS} --output first.png
                WORKING_DIRECTORY ${OUTPUT_DIR} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${TAUT} render ../first.png
                WORKING_DIRECTORY ${OUTPUT_DIR}/elsewhere ERROR_VARIABLE warnings COMMAND_ERROR_IS_FATAL ANY)
if(warnings)
  message(FATAL_ERROR "${warnings}")
endif()
set(again ${OUTPUT_DIR}/elsewhere/first-again.png)
execute_process(COMMAND ${COMPARE} ${OUTPUT_DIR}/first.png ${again} ${OUTPUT_DIR} 0 0 0
                RESULT_VARIABLE different)
if(different)
  message(FATAL_ERROR "the pictures differ: ${OUTPUT_DIR}/side_by_side.png")
endif()

# All that is recorded but the command line is the same; lists of lines hold brackets, so they stay texts.
function(read_record file record)
  file(STRINGS ${file} lines LENGTH_MINIMUM 8 REGEX "^[a-z_]+ = |^[0-9a-f]+$")
  if(NOT lines MATCHES "frame_rate = 60")
    message(FATAL_ERROR "${file} says little about itself: ${lines}")
  endif()
  set(${record} "${lines}" PARENT_SCOPE)
endfunction()
read_record(${OUTPUT_DIR}/first.png first)
read_record(${again} second)
if(NOT first STREQUAL second)
  message(FATAL_ERROR "the records differ:\n${first}\n${second}")
endif()

# Changes since are said: here the shape of the garment.
if(CHANGED_GARMENT)
  file(READ ${CHANGED_GARMENT} garment)
  file(WRITE ${OUTPUT_DIR}/garment.obj "${garment}")
  execute_process(COMMAND ${TAUT} render garment.obj --frames 0 --resolution 64,64 --output made.png
                  WORKING_DIRECTORY ${OUTPUT_DIR} COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "\nv (-?)0\\." "\nv \\11." garment "${garment}")
  file(WRITE ${OUTPUT_DIR}/garment.obj "${garment}")
  execute_process(COMMAND ${TAUT} render made.png WORKING_DIRECTORY ${OUTPUT_DIR}
                  ERROR_VARIABLE warnings COMMAND_ERROR_IS_FATAL ANY)
  if(NOT warnings MATCHES "the cloth is not where it was")
    message(FATAL_ERROR "no word about the changed garment: ${warnings}")
  endif()
endif()

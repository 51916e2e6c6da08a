# Draws ARGUMENTS with TAUT through every backend into OUTPUT_DIR; COMPARE has to find the pixels equal.
file(REMOVE_RECURSE ${OUTPUT_DIR})
file(MAKE_DIRECTORY ${OUTPUT_DIR})
foreach(backend osmesa egl)
  execute_process(
    COMMAND ${TAUT} render ${ARGUMENTS} --backend ${backend} --output ${OUTPUT_DIR}/${backend}.png
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "taut render --backend ${backend} failed: ${failed}")
  endif()
endforeach()
execute_process(COMMAND ${COMPARE} ${OUTPUT_DIR}/osmesa.png ${OUTPUT_DIR}/egl.png ${OUTPUT_DIR} 0 0 0
                RESULT_VARIABLE different)
if(different)
  message(FATAL_ERROR "the pictures differ: ${OUTPUT_DIR}/side_by_side.png")
endif()

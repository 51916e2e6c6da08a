# Draws ARGUMENTS with TAUT into OUTPUT_DIR and compares the picture with BASELINE through COMPARE.
file(REMOVE_RECURSE ${OUTPUT_DIR})
file(MAKE_DIRECTORY ${OUTPUT_DIR})
execute_process(COMMAND ${TAUT} render ${ARGUMENTS} --output ${OUTPUT_DIR}/actual.png RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "taut render failed: ${failed}")
endif()
execute_process(COMMAND ${COMPARE} ${BASELINE} ${OUTPUT_DIR}/actual.png ${OUTPUT_DIR}/difference.png
                RESULT_VARIABLE different)
if(different)
  message(FATAL_ERROR "the picture differs from its baseline")
endif()

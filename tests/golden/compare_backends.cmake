# Draws ARGUMENTS with TAUT through every backend into OUTPUT_DIR; the files have to be equal.
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
file(SHA256 ${OUTPUT_DIR}/osmesa.png osmesa)
file(SHA256 ${OUTPUT_DIR}/egl.png egl)
if(NOT osmesa STREQUAL egl)
  message(FATAL_ERROR "the pictures differ: ${OUTPUT_DIR}/osmesa.png, ${OUTPUT_DIR}/egl.png")
endif()

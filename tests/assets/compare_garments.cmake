# Runs the tool and compares every file it makes with the committed one, byte for byte.
file(REMOVE_RECURSE ${MADE})
execute_process(COMMAND ${TOOL} ${PATTERN} ${MADE} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${TOOL} failed: ${failed}")
endif()
foreach(size 10600 5280 1028)
  foreach(file tshirt_${size}.obj tshirt_${size}.landmarks.toml)
    execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${MADE}/${file} ${COMMITTED}/${file}
      RESULT_VARIABLE different)
    if(different)
      message(SEND_ERROR "${MADE}/${file} is not what is committed. If the change is meant: look at the new "
        "garment, copy it to ${COMMITTED} and bring the table in assets/README.md up to date.")
    endif()
  endforeach()
endforeach()

# Runs a tool that writes files into a folder, its last argument, and compares each with the committed one, byte for
# byte. TOOL is a command, FILES are names, both lists with commas; WHAT is said where they differ.
file(REMOVE_RECURSE ${MADE})
file(MAKE_DIRECTORY ${MADE})
string(REPLACE "," ";" TOOL "${TOOL}")
string(REPLACE "," ";" FILES "${FILES}")
execute_process(COMMAND ${TOOL} ${MADE} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${TOOL} failed: ${failed}")
endif()
foreach(file ${FILES})
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${MADE}/${file} ${COMMITTED}/${file}
    RESULT_VARIABLE different)
  if(different)
    message(SEND_ERROR "${MADE}/${file} is not what is committed. If the change is meant: look at the new ${WHAT}, "
      "copy it to ${COMMITTED} and bring assets/README.md up to date.")
  endif()
endforeach()

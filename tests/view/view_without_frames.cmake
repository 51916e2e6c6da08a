# A script that ends before its first frame shows what a window without a script shows.
#   cmake -DPROGRAM=... -DDIR=... -P view_without_frames.cmake
file(REMOVE_RECURSE ${DIR})
file(WRITE ${DIR}/script.txt [=[["taut-session", 2]
["scene", "pinned-9x9-5"]
]=])
foreach(picture scripted plain)
  if(picture STREQUAL scripted)
    set(what --script ${DIR}/script.txt)
  else()
    set(what pinned-9x9-5)
  endif()
  execute_process(COMMAND ${PROGRAM} view --headless ${what} --screenshot ${DIR}/${picture}.png
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${DIR}/scripted.png ${DIR}/plain.png
                COMMAND_ERROR_IS_FATAL ANY)

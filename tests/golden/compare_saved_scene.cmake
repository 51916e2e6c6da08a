# Plays SESSION, which saves SCENE, and compares what the window shows with what `taut render` makes of the
# scene: no pixel may differ.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${OUTPUT_DIR})
file(MAKE_DIRECTORY ${OUTPUT_DIR})
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${OUTPUT_DIR} RESULT_VARIABLE failed OUTPUT_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "failed: ${ARGN}\n${said}")
  endif()
endfunction()
run(${TAUT} view --headless --script ${SESSION} --screenshot window.png)
run(${TAUT} render ${SCENE}-1.toml --output rendered.png)
run(${COMPARE} window.png rendered.png ${OUTPUT_DIR} 0 0 0)
run(${TAUT} render ${SCENE}-1.toml --output other.png --set "start.checkpoint=\"\"" --set wind.speed=${OTHER_WIND}
    --set solver.contact=false)
execute_process(COMMAND ${COMPARE} window.png other.png ${OUTPUT_DIR} 0 0 0 WORKING_DIRECTORY ${OUTPUT_DIR}
                RESULT_VARIABLE told_apart OUTPUT_QUIET)
if(NOT told_apart)
  message(FATAL_ERROR "another wind makes no difference: this test would see nothing")
endif()

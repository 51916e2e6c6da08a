# Draws ARGUMENTS with TAUT (`taut render`, with VIEW `taut view --headless`, with INSPECT `taut inspect`, or with
# FIGURE that one of `judge_claims`, CLAIMS) into OUTPUT_DIR and compares the picture with BASELINE through COMPARE.
# A failure says what differs and how to accept it, and stands in FAILURES_PAGE until the test passes.
# With MUST_DIFFER it is the other way round: the picture has to be told from the baseline.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/failures_page.cmake)

get_filename_component(baseline_name ${BASELINE} NAME_WE)
set(actual ${OUTPUT_DIR}/actual.png)
set(accept "tests/golden/accept.sh ${BUILD_DIR} ${NAME}")
list(JOIN ARGUMENTS " " command)
if(FIGURE)
  set(command "judge_claims ${command}")
elseif(VIEW)
  set(command "taut view --headless ${command}")
elseif(INSPECT)
  set(command "taut inspect ${command}")
else()
  set(command "taut render ${command}")
endif()

# In `folder`; relative names, so that the picture's record holds no folder of this machine.
function(run program folder)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${program} ${ARGN} WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed)
  if(failed)
    add_failure("${program} ${ARGV2} failed: ${failed}" "")
    message(FATAL_ERROR "${program} ${ARGV2} failed: ${failed}")
  endif()
endfunction()

# The renderer that drew the pictures of the run that left `stats`.
function(read_renderer stats result)
  file(STRINGS ${stats} run LIMIT_COUNT 1)
  string(JSON renderer GET "${run}" versions gl_renderer)
  set(${result} "${renderer}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${OUTPUT_DIR})
if(FIGURE)
  run(${CLAIMS} ${OUTPUT_DIR} ${ARGUMENTS} --output .)
  file(RENAME ${OUTPUT_DIR}/${FIGURE}.png ${actual})
elseif(VIEW)
  run(${TAUT} ${OUTPUT_DIR} view --headless ${ARGUMENTS} --screenshot actual.png)
elseif(INSPECT)
  run(${TAUT} ${OUTPUT_DIR} inspect ${ARGUMENTS} --json --picture actual.png)
else()
  run(${TAUT} ${OUTPUT_DIR} render ${ARGUMENTS} --output actual.png --stats run.jsonl)
endif()
if(IS_PLOT)
  set(renderer "no OpenGL")
elseif(FIGURE OR VIEW OR INSPECT)
  # They do not say it: a small picture does.
  run(${TAUT} ${OUTPUT_DIR}/probe render cloth-fall --frames 0 --resolution 16,16 --stats run.jsonl)
  read_renderer(${OUTPUT_DIR}/probe/run.jsonl renderer)
else()
  read_renderer(${OUTPUT_DIR}/run.jsonl renderer)
endif()
file(WRITE ${OUTPUT_DIR}/renderer.txt "${renderer}\n")

if(NOT EXISTS ${BASELINE} AND MUST_DIFFER)
  message(FATAL_ERROR "There is no baseline ${BASELINE}; its own test says how to make it.")
endif()
if(NOT EXISTS ${BASELINE})
  add_failure("There is no baseline yet. The candidate:" actual.png)
  message("There is no baseline ${BASELINE}.\n"
    "Look at the candidate ${actual} and accept it:\n  ${accept}")
  message(FATAL_ERROR "no baseline")
endif()

# Another rasteriser draws other pixels. A build farm must not skip for that: it would test nothing.
set(baseline_renderer "unknown")
string(REGEX REPLACE "\\.png$" ".renderer.txt" renderer_file ${BASELINE})
if(EXISTS ${renderer_file})
  file(READ ${renderer_file} baseline_renderer)
  string(STRIP "${baseline_renderer}" baseline_renderer)
endif()
if(NOT baseline_renderer STREQUAL renderer AND NOT "$ENV{CI}" STREQUAL "true")
  remove_failure()
  message("SKIPPED: drawn by '${renderer}', the baseline by '${baseline_renderer}'; CI=true compares them anyway")
  return()
endif()

execute_process(COMMAND ${COMPARE} ${BASELINE} ${actual} ${OUTPUT_DIR} ${LIMIT}
                RESULT_VARIABLE different OUTPUT_VARIABLE difference ERROR_VARIABLE errors)
if(NOT different MATCHES "^[01]$")
  message(FATAL_ERROR "the pictures cannot be compared: ${different} ${difference}${errors}")
endif()
if(MUST_DIFFER)
  if(NOT different)
    message(FATAL_ERROR "the picture passes for ${baseline_name}, although it shows something else: ${command}")
  endif()
  # Little, or it is not the small change that was told but another picture altogether.
  set(small_change 255 1 2)
  execute_process(COMMAND ${COMPARE} ${BASELINE} ${actual} ${OUTPUT_DIR} ${small_change}
                  RESULT_VARIABLE is_other_picture)
  if(is_other_picture)
    message(FATAL_ERROR "this is another picture than ${baseline_name}, not a small change of it: ${command}\n"
      "${difference}")
  endif()
  message("told from ${baseline_name}, as it has to be:\n${difference}")
  return()
endif()
if(NOT different)
  remove_failure()
  return()
endif()

file(COPY_FILE ${BASELINE} ${OUTPUT_DIR}/expected.png)
set(pictures expected.png actual.png)
if(EXISTS ${OUTPUT_DIR}/difference.png)
  list(APPEND pictures difference.png)
endif()
if(REASON)
  string(APPEND difference "The limit is another than that of other pictures: ${REASON}\n")
endif()
add_failure("${difference}" "${pictures}")
message("The picture differs from its baseline.\n${difference}"
  "expected, actual, difference x16: ${OUTPUT_DIR}/side_by_side.png\n"
  "all failures: ${FAILURES_PAGE}\n"
  "If the picture was meant to change, look at it and accept it:\n  ${accept}")
message(FATAL_ERROR "the picture differs from its baseline")

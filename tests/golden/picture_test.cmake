set(picture_failures_page ${CMAKE_BINARY_DIR}/picture-failures.html)

function(taut_internal_picture_test test name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "BASELINE;REASON" "LIMIT;DEFINITIONS;ARGUMENTS")
  add_test(NAME ${test}
    COMMAND ${CMAKE_COMMAND}
            -DNAME=${name} -DTAUT=$<TARGET_FILE:taut> -DCLAIMS=$<TARGET_FILE:judge_claims>
            -DCOMPARE=$<TARGET_FILE:compare_pictures> "-DARGUMENTS=${arg_ARGUMENTS}" "-DLIMIT=${arg_LIMIT}" "-DREASON=${arg_REASON}" ${arg_DEFINITIONS}
            -DBASELINE=${CMAKE_CURRENT_SOURCE_DIR}/baselines/${arg_BASELINE}.png
            -DOUTPUT_DIR=${CMAKE_CURRENT_BINARY_DIR}/${name}
            -DBUILD_DIR=${CMAKE_BINARY_DIR} -DFAILURES_PAGE=${picture_failures_page}
            -P ${CMAKE_CURRENT_SOURCE_DIR}/run_picture_test.cmake)
  set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()

# taut_add_picture_test(NAME [LIMIT channel fraction mean REASON "..."] arguments of `taut render`...): the real
# binary draws, and the picture is compared with baselines/NAME.png within PictureLimit (picture_difference.hpp)
# or LIMIT, which has to say why.
function(taut_add_picture_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "REASON" "LIMIT")
  list(LENGTH arg_LIMIT numbers)
  if(arg_LIMIT AND (NOT arg_REASON OR NOT numbers EQUAL 3))
    message(FATAL_ERROR "picture test ${name}: LIMIT needs three numbers and a REASON")
  endif()
  taut_internal_picture_test(picture.${name} ${name} BASELINE ${name} LIMIT ${arg_LIMIT}
    REASON "${arg_REASON}" ARGUMENTS ${arg_UNPARSED_ARGUMENTS})
  set_property(DIRECTORY APPEND PROPERTY TAUT_PICTURE_TESTS ${name})
endfunction()

# taut_add_command_test(NAME COMMAND arguments...): the same with the picture of another command of taut: view, what its
# window shows, inspect, fit, or simulate, of a run that is blocked.
function(taut_add_command_test name command)
  taut_internal_picture_test(picture.${name} ${name} BASELINE ${name} DEFINITIONS -DSUBCOMMAND=${command} ARGUMENTS ${ARGN})
  set_property(DIRECTORY APPEND PROPERTY TAUT_PICTURE_TESTS ${name})
endfunction()

# taut_add_figure_test(NAME FIGURE [PLOT] arguments of `judge_claims`...): the same with a whole figure; PLOT: nothing in it is drawn by OpenGL.
function(taut_add_figure_test name figure)
  cmake_parse_arguments(PARSE_ARGV 2 arg "PLOT" "" "")
  taut_internal_picture_test(picture.${name} ${name} BASELINE ${name}
    DEFINITIONS -DFIGURE=${figure} -DIS_PLOT=${arg_PLOT} ARGUMENTS ${arg_UNPARSED_ARGUMENTS})
  set_property(DIRECTORY APPEND PROPERTY TAUT_PICTURE_TESTS ${name})
endfunction()

# taut_add_changed_data_test(NAME BASELINE FIGURE TABLE PROGRAM [PLOT] arguments...): FIGURE has to look different
# once awk has changed one of the tables it is drawn from.
function(taut_add_changed_data_test name baseline figure table program)
  cmake_parse_arguments(PARSE_ARGV 5 arg "PLOT" "" "")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}_data)
  set(tables ${CMAKE_CURRENT_SOURCE_DIR}/figures)
  file(GLOB all_tables CONFIGURE_DEPENDS ${tables}/*.csv)
  add_custom_command(OUTPUT ${folder}/${table}.csv DEPENDS ${all_tables}
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${tables} ${folder}
    COMMAND awk -F , -v OFS=, ${program} ${tables}/${table}.csv > ${folder}/${table}.csv
    VERBATIM)
  add_custom_target(${name}_data ALL DEPENDS ${folder}/${table}.csv)
  taut_internal_picture_test(picture_tests.see_${name} ${name} BASELINE ${baseline}
    DEFINITIONS -DMUST_DIFFER=ON -DFIGURE=${figure} -DIS_PLOT=${arg_PLOT}
    ARGUMENTS --only ${figure} --data ${folder} ${arg_UNPARSED_ARGUMENTS})
endfunction()

# taut_add_changed_picture_test(NAME BASELINE arguments...): the picture has to differ from baselines/BASELINE.png,
# though not by much.
function(taut_add_changed_picture_test name baseline)
  taut_internal_picture_test(picture_tests.see_${name} ${name} BASELINE ${baseline}
    DEFINITIONS -DMUST_DIFFER=ON ARGUMENTS ${ARGN})
endfunction()

# taut_add_moved_garment_test(NAME BASELINE CONDITION): the garment of scene BASELINE with the vertices moved by
# 0.5 mm along z for which the condition holds ($2, $3, $4 are x, y, z) has to look different.
function(taut_add_moved_garment_test name baseline condition)
  set(moved ${CMAKE_CURRENT_BINARY_DIR}/${name}.obj)
  set(garment ${CMAKE_CURRENT_SOURCE_DIR}/garments/${baseline}.obj)
  add_custom_command(OUTPUT ${moved} DEPENDS ${garment}
    COMMAND awk "/^v / && ${condition} { $4 = sprintf(\"%.9g\", $4 + 0.0005) } { print }" ${garment} > ${moved}
    VERBATIM)
  add_custom_target(${name}_garment ALL DEPENDS ${moved})
  taut_add_changed_picture_test(${name} ${baseline}
    ${CMAKE_CURRENT_SOURCE_DIR}/scenes/${baseline}.toml ${small} --set garment.file=${moved})
endfunction()

# The list accept.sh works through, and a target that draws all pictures and accepts them.
function(taut_finish_picture_tests)
  get_property(names DIRECTORY PROPERTY TAUT_PICTURE_TESTS)
  list(JOIN names "\n" lines)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/picture_tests.txt "${lines}\n")
  add_custom_target(accept_pictures
    COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${CMAKE_BINARY_DIR} -R "^picture[.]" --output-on-failure || true
    COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/accept.sh ${CMAKE_BINARY_DIR} --all
    DEPENDS taut compare_pictures
    USES_TERMINAL
    VERBATIM)
endfunction()

# One page of all picture tests that fail. Every failing test leaves a piece of it in its folder, and the page
# is put together anew each time, because tests run side by side and come and go.

set(page_head [=[<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Pictures that differ</title>
<style>
body { font: 15px/1.5 sans-serif; margin: 2em; max-width: 110em; }
figure { display: inline-block; margin: 0 1em 1em 0; } figcaption { color: #555; }
img { image-rendering: pixelated; border: 1px solid #ccc; max-width: 100%; }
.swap { position: relative; } .swap img + img { position: absolute; left: 0; top: 0; opacity: 0; }
.swap:hover img + img { opacity: 1; }
pre, code { background: #f4f4f2; padding: .2em .4em; } pre { padding: .8em; overflow-x: auto; }
</style>
<h1>Pictures that differ from their baselines</h1>
<p>Each test below drew a picture with the program and compared it with the baseline in
<code>tests/golden/baselines</code>. The difference is shown 16 times as large as it is; black is equal. If
you did not mean to change a picture, the change is a fault. If you did, look at it here, run the command below
it from the root of the sources, and commit the new baseline together with what caused it.
A test that passes again leaves this page.</p>
]=])

function(escape_html text result)
  string(REPLACE "&" "&amp;" text "${text}")
  string(REPLACE "<" "&lt;" text "${text}")
  string(REPLACE ">" "&gt;" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

function(write_page)
  get_filename_component(page_folder ${FAILURES_PAGE} DIRECTORY)
  file(LOCK ${FAILURES_PAGE}.lock GUARD FUNCTION TIMEOUT 60)
  get_filename_component(all_tests ${OUTPUT_DIR} DIRECTORY)
  file(GLOB pieces ${all_tests}/*/failure.html)
  if(NOT pieces)
    file(REMOVE ${FAILURES_PAGE})
    return()
  endif()
  set(page "${page_head}")
  foreach(piece ${pieces})
    file(READ ${piece} text)
    string(APPEND page "${text}")
  endforeach()
  file(WRITE ${FAILURES_PAGE} "${page}")
endfunction()

# `pictures` are names in OUTPUT_DIR; links are relative, so that the build folder can be moved or uploaded.
function(add_failure text pictures)
  get_filename_component(page_folder ${FAILURES_PAGE} DIRECTORY)
  file(RELATIVE_PATH folder ${page_folder} ${OUTPUT_DIR})
  escape_html("${text}" text)
  escape_html("${command}" escaped_command)
  set(piece "<h2>${NAME}</h2>\n<p>Drawn with <code>${escaped_command}</code></p>\n")
  foreach(picture ${pictures})
    get_filename_component(caption ${picture} NAME_WE)
    string(APPEND piece "<figure><a href=\"${folder}/${picture}\"><img src=\"${folder}/${picture}\" "
      "alt=\"${caption}\"></a><figcaption>${caption}</figcaption></figure>\n")
  endforeach()
  if("expected.png" IN_LIST pictures)
    string(APPEND piece "<figure class=\"swap\"><img src=\"${folder}/expected.png\" alt=\"expected\">"
      "<img src=\"${folder}/actual.png\" alt=\"actual\"><figcaption>expected; actual under the pointer</figcaption></figure>\n")
  endif()
  string(APPEND piece "<pre>${text}</pre>\n")
  if(pictures)
    string(APPEND piece "<p>To accept it: <code>${accept}</code></p>\n")
  endif()
  file(WRITE ${OUTPUT_DIR}/failure.html "${piece}")
  write_page()
endfunction()

function(remove_failure)
  file(REMOVE ${OUTPUT_DIR}/failure.html)
  write_page()
endfunction()

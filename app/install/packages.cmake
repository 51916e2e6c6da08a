# Packages: `cpack -G DEB` makes those for Debian 12 of what is installed, one for each component, `cpack --config
# CPackSourceConfig.cmake` an archive of the sources, which needs no git to be built.
set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_CONTACT "The Taut authors <taut@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of garments that do not over-stretch")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library headers python addon)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(what
"Triangles of any garment model become springs that are corrected by a strong
constraint: in no frame is anything longer than its bound, and nothing crosses
anything.")
# Its own depends are libraries that are loaded while it runs, which the linker does not know of.
function(taut_package component name section text depends)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${what}\n${text}" PARENT_SCOPE)
endfunction()
set(of_library "libtaut1 (= ${PROJECT_VERSION})")
taut_package(program taut graphics
  "This is the program, which draws with and without a display." "${of_library}, libegl1, libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
taut_package(library libtaut1 libs
  "This is the library, with what reads models,\nand with scenes, garments, bodies and fabrics." "")
taut_package(headers libtaut-dev libdevel
  "These are the header for C and C++, what pkg-config and CMake ask for,\nand C# sources." "${of_library}")
taut_package(python python3-taut python
  "This is the module taut of Python." "${of_library}, python3")
taut_package(addon blender-taut graphics
  "This is the add-on as Blender installs it: /usr/share/taut/taut_cloth.zip." "${of_library}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, libosmesa6")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS snakemake)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS libosmesa6)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS mono-runtime)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-numpy)
set(CPACK_DEBIAN_ADDON_PACKAGE_RECOMMENDS blender)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_ADDON_PACKAGE_ARCHITECTURE all)
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
# CPack would add scripts that call ldconfig, which the trigger does: it leaves out those that it is to find and does not.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers
  ${PROJECT_BINARY_DIR}/debian/absent/postinst ${PROJECT_BINARY_DIR}/debian/absent/postrm)
# Debian's own files beside what every installation has.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)
set(CPACK_LIBRARY_ARCHITECTURE ${CMAKE_LIBRARY_ARCHITECTURE})
set(CPACK_PROJECT_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/build/;/\\\\.git/;/__pycache__/;\\\\.swp$")
include(CPack)

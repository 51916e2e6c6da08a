# Packages: `cpack -G DEB` makes one for Debian 12 of what is installed, `cpack --config CPackSourceConfig.cmake` an
# archive of the sources, which needs no git to be built.
set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_CONTACT "The Taut authors <taut@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of garments that do not over-stretch")
set(CPACK_PACKAGE_DESCRIPTION
"Triangles of any garment model become springs that are corrected by a strong
constraint: in no frame is anything longer than its bound, and nothing crosses
anything. With the program, which draws without a display, come the library
libtaut for C, C++, Python and C#, and an add-on for Blender.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# Libraries that are loaded while it runs, which the linker does not know of.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core, python3")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, libosmesa6, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "blender, mono-runtime")
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
# Debian's own files beside what every installation has.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)
set(CPACK_PROJECT_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/build/;/\\\\.git/;/__pycache__/;\\\\.swp$")
include(CPack)

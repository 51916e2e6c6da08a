# cmake -DSHADERS=a.vert;b.frag -DOUTPUT=x.cpp -P embed_shaders.cmake
# Writes a C++ file with the text of every shader, so that the program needs no files at run time.

set(text "// Generated from shaders/; edit those.\n#include \"renderer/gl/shader.hpp\"\n\n")
string(APPEND text "namespace taut::renderer {\n\nstd::span<const ShaderFile> embedded_shaders() {\n")
string(APPEND text "  static constexpr ShaderFile files[] = {\n")
foreach(shader IN LISTS SHADERS)
  get_filename_component(name ${shader} NAME)
  file(READ ${shader} source)
  string(APPEND text "      {\"${name}\", R\"glsl(${source})glsl\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace taut::renderer\n")
file(WRITE ${OUTPUT} "${text}")

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "renderer/context/context.hpp"
#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {
namespace {

constexpr ShaderFile good_vertex{"good.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n"};

std::string error_text(std::span<const ShaderFile> files, std::string_view fragment) {
  const auto context = create_context();
  try {
    const Program program(context->gl(), files, "good.vert", fragment);
  } catch (const ShaderError& error) {
    return error.what();
  }
  return "";
}

TEST(Program, ErrorNamesFileAndLine) {
  const std::array files{good_vertex,
                         ShaderFile{"bad.frag", "#version 330 core\nout vec4 c;\nvoid main() {\n  c = vec5(1);\n}\n"}};
  const std::string message = error_text(files, "bad.frag");
  EXPECT_NE(message.find("bad.frag:4"), std::string::npos) << message;
}

TEST(Program, MissingFileIsNamed) {
  EXPECT_EQ(error_text(std::span(&good_vertex, 1), "gone.frag"), "there is no shader file 'gone.frag'");
}

TEST(Context, UnknownNameIsRefusedWithTheKnownOnes) {
  try {
    create_context("directx");
    FAIL();
  } catch (const ContextError& error) {
    EXPECT_NE(std::string(error.what()).find("directx"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("osmesa"), std::string::npos);
  }
}

TEST(Context, SaysWhatItIs) { EXPECT_NE(create_context("osmesa")->renderer().find("llvmpipe"), std::string::npos); }

}  // namespace
}  // namespace taut::renderer

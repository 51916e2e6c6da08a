#include <gtest/gtest.h>

#include "app/models/garment_import.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

TEST(UnitOf3mf, IsWhatTheModelSays) {
  EXPECT_EQ(unit_of_model_part("<model unit=\"inch\">"), 0.0254);
  EXPECT_EQ(unit_of_model_part("<model\n unit = 'meter'\txml:lang=\"en\">"), 1.0);
  EXPECT_EQ(unit_of_model_part(
                "<?xml version=\"1.0\"?>\n<!-- <model unit=\"foot\"> -->\n<m:model a='>' unit=\"micron\">"),
            1e-6);
}

TEST(UnitOf3mf, IsAMillimetreWhereNoneIsNamed) {
  EXPECT_EQ(unit_of_model_part("<model xml:lang=\"en\" submit=\"inch\">"), 0.001);
  EXPECT_EQ(unit_of_model_part("<model>"), 0.001);
}

TEST(UnitOf3mf, IsUnknownWhereTheTextIsNoModel) {
  for (const char* text :
       {"", "<", "model", "<mesh unit=\"inch\">", "<model unit=\"furlong\">", "<!-- <model>"}) {
    EXPECT_EQ(unit_of_model_part(text), std::nullopt) << text;
  }
}

TEST(UnitOf3mf, IsUnknownWhereThereIsNoArchive) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(unit_of_3mf(folder.write("dress.3mf", "PK\003\004 and nothing else")), std::nullopt);
  EXPECT_EQ(unit_of_3mf(folder / "none.3mf"), std::nullopt);
}

}  // namespace
}  // namespace taut::app

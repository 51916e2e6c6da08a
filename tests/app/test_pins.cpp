#include <gtest/gtest.h>

#include "app/errors.hpp"
#include "app/scene/pins.hpp"
#include "sim/grid.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using Selectors = std::vector<PinSelector>;
using Vertices = std::vector<sim::Index>;

// 0 1 2
// 3 4 5
struct Pins : testing::Test {
  Pins() : mesh(sim::make_grid(settings)) {}

  Vertices select(const std::optional<Selectors>& pins) const {
    return select_pins(pins, {mesh, landmarks, &settings});
  }

  sim::GridSettings settings{.columns = 3, .rows = 2};
  sim::Mesh mesh;
  Landmarks landmarks;
};

TEST_F(Pins, NameCornersAndEdgesOfAGrid) {
  EXPECT_EQ(select(Selectors{"top-left", "top-right"}), (Vertices{0, 2}));
  EXPECT_EQ(select(Selectors{"bottom-left", "bottom-right"}), (Vertices{3, 5}));
  EXPECT_EQ(select(Selectors{"top-edge"}), (Vertices{0, 1, 2}));
  EXPECT_EQ(select(Selectors{"bottom-edge"}), (Vertices{3, 4, 5}));
}

TEST_F(Pins, AreTheUpperEdgeOfAGridWhereNoneAreGiven) {
  EXPECT_EQ(select(std::nullopt), (Vertices{0, 1, 2}));
}

TEST_F(Pins, CanBeNone) {
  EXPECT_TRUE(select(Selectors{}).empty());
}

TEST_F(Pins, CanBeVerticesAndPoints) {
  EXPECT_EQ(select(Selectors{sim::Index{4}, NearestTo{{0.4, -0.9, 0.1}}}), (Vertices{4, 5}));
}

TEST_F(Pins, OfAModelAreItsTopBand) {
  EXPECT_EQ(select_pins(std::nullopt, {mesh, landmarks}), (Vertices{0, 1, 2}));
}

TEST_F(Pins, RefuseWhatIsNotThere) {
  EXPECT_CONTAINS(test::message_of<InputError>([&] { select(Selectors{sim::Index{6}}); }),
                  "found vertex 6, expected a vertex from 0 to 5");
  EXPECT_CONTAINS(test::message_of<InputError>([&] { select(Selectors{"top-lef"}); }),
                  "did you mean 'top-left'?");
}

}  // namespace
}  // namespace taut::app

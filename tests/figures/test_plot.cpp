#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/drawing/drawing.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/runs/csv.hpp"

namespace taut::app {
namespace {

std::vector<std::string> tick_labels(const Axis& axis) {
  std::vector<std::string> labels;
  for (const Tick& tick : make_ticks(axis)) {
    if (!tick.label.empty()) {
      labels.push_back(tick.label);
    }
  }
  return labels;
}

using Labels = std::vector<std::string>;

TEST(Axis, LinearTicksAreRoundAndWithin) {
  EXPECT_EQ(tick_labels({"", 0.0, 10.0}), (Labels{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(tick_labels({"", -0.013, 0.031}), (Labels{"-0.01", "0.00", "0.01", "0.02", "0.03"}));
  EXPECT_EQ(tick_labels({"", 0.0, 20.0, false, " %"}), (Labels{"0 %", "5 %", "10 %", "15 %", "20 %"}));
}

TEST(Axis, LogarithmicTicksAreDecadesWithSmallOnesBetween) {
  const Axis axis{"", 1e-3, 1.0, true};
  EXPECT_EQ(tick_labels(axis), (Labels{"10⁻³", "10⁻²", "10⁻¹", "10⁰"}));
  const std::vector<Tick> ticks = make_ticks(axis);
  EXPECT_EQ(ticks.size(), 28U);
  EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end(), [](auto& a, auto& b) { return a.value < b.value; }));
  EXPECT_NEAR(ticks[1].value, 2e-3, 1e-12);
}

TEST(Axis, SmallDecadesAreWrittenInFullAndManyThinnedOut) {
  EXPECT_EQ(tick_labels({"", 0.1, 100.0, true}), (Labels{"0.1", "1", "10", "100"}));
  EXPECT_EQ(tick_labels({"", 1.0, 20.0, true}), (Labels{"1", "2", "5", "10", "20"}));
  EXPECT_LE(tick_labels({"", 1e-18, 1.0, true}).size(), 8U);
  EXPECT_EQ(tick_labels({"", 1.0, 9.0, true, "", {3.0, 7.0}}), (Labels{"3", "7"}));
}

TEST(Axis, PlacesValuesInProportionOrByTheirLogarithm) {
  EXPECT_NEAR(position_on({"", 2.0, 6.0}, 3.0), 0.25, 1e-12);
  EXPECT_NEAR(position_on({"", 0.01, 100.0, true}, 1.0), 0.5, 1e-12);
  EXPECT_GT(position_on({"", 0.01, 100.0, true}, 1e4), 1.0);
  EXPECT_FALSE(std::isfinite(position_on({"", 0.01, 100.0, true}, 0.0)));
}

TEST(Axis, WidensToWholeDecades) {
  const Axis axis = decades_around("m", {0.0, 3e-4, 0.2, -1.0});
  EXPECT_NEAR(axis.minimum, 1e-4, 1e-12);
  EXPECT_NEAR(axis.maximum, 1.0, 1e-12);
  EXPECT_TRUE(axis.logarithmic);
  EXPECT_GT(decades_around("", {1.0}).maximum, 1.0);
  EXPECT_GT(decades_around("", {}).maximum, decades_around("", {}).minimum);
}

TEST(Axis, WritesPowersAsPeopleDo) {
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(scientific(2.16e-8), "2.2 × 10⁻⁸");
  EXPECT_EQ(scientific(0.0), "0");
  EXPECT_EQ(scientific(1.868), "1.9");
}

TEST(Plot, DashesRunOnAroundCorners) {
  const std::vector<glm::vec2> corner = {{10.0F, 10.0F}, {40.0F, 10.0F}, {40.0F, 40.0F}};
  renderer::Canvas canvas(60, 60);
  draw_polyline(canvas, corner, {renderer::Colour{0.0F}, 4.0F, {5.0F, 2.0F}});
  const renderer::Image image = canvas.to_image();
  const auto is_dark = [&](int x, int y) { return image.at(x, y)[0] < 60; };
  EXPECT_TRUE(is_dark(20, 10));
  EXPECT_FALSE(is_dark(34, 10)) << "the gap after 20 pixels";
  EXPECT_TRUE(is_dark(39, 10)) << "the second dash turns the corner";
  EXPECT_TRUE(is_dark(39, 24));
  EXPECT_FALSE(is_dark(39, 32)) << "the gap after it";
  canvas.line(0.0F, 50.0F, 60.0F, 50.0F, renderer::Colour{0.0F}, 4.0F);
  const renderer::Image solid = canvas.to_image();
  for (int x = 1; x < 59; ++x) EXPECT_LT(solid.at(x, 50)[0], 60) << "dashes are of one line";
}

TEST(Plot, ThinningKeepsTheExtremes) {
  std::vector<glm::vec2> noise;
  for (int i = 0; i < 1000; ++i) {
    noise.emplace_back(static_cast<float>(i) / 100.0F, i == 555 ? 99.0F : static_cast<float>(i % 7));
  }
  const auto thin = thin_out(noise);
  EXPECT_LE(thin.size(), 40U);
  EXPECT_TRUE(std::any_of(thin.begin(), thin.end(), [](auto& p) { return p.y == 99.0F; }));
  EXPECT_EQ(thin.back(), noise.back());
}

TEST(Plot, CurveEndsAtTheDataAreaAndStandsWhereItsValuesSay) {
  Plot plot;
  plot.x = {"x", 0.0, 1.0};
  plot.y = {"y", 1.0, 100.0, true};
  plot.legend = LegendCorner::none;
  plot.curves = {
      {"", {{0.0, 10.0}, {0.5, 10.0}, {0.6, 0.0}, {0.7, 1e9}, {0.8, 1e99}}, {renderer::Colour{0.0F}, 6.0F, {}}}};
  const Area area{0.0F, 0.0F, 600.0F, 400.0F};
  renderer::Canvas canvas(600, 400);
  const Area data_area = compute_data_area(canvas, plot, area);
  draw_plot(canvas, plot, area);
  const renderer::Image image = canvas.to_image();
  const auto is_dark = [&](double x, double y) {
    return image.at(static_cast<int>(data_area.x_px + x * data_area.width_px),
                    static_cast<int>(data_area.y_px + (1.0 - y) * data_area.height_px))[0] < 60;
  };
  EXPECT_TRUE(is_dark(0.25, 0.5));
  EXPECT_FALSE(is_dark(0.75, 0.5)) << "a value with no place on the axis leaves a gap";
  for (int x = 0; x < 600; ++x) {
    EXPECT_GT(image.at(x, 2)[0], 200) << "nothing above the data_area";
  }
}

TEST(Plot, CrossesAreCrosses) {
  Plot plot;
  plot.curves = {{"", {{0.5, 0.5}}, {renderer::Colour{0.0F}, 0.0F, {2.0F}}, Marker::cross}};
  plot.legend = LegendCorner::none;
  const Area area{0.0F, 0.0F, 600.0F, 400.0F};
  renderer::Canvas canvas(600, 400);
  const Area data_area = compute_data_area(canvas, plot, area);
  draw_plot(canvas, plot, area, {.marker_px = 20.0F});
  const renderer::Image image = canvas.to_image();
  const auto is_dark = [&](float right_px, float down_px) {
    return image.at(static_cast<int>(data_area.x_px + 0.5F * data_area.width_px + right_px),
                    static_cast<int>(data_area.y_px + 0.5F * data_area.height_px + down_px))[0] < 60;
  };
  for (const float side : {-15.0F, 15.0F}) {
    EXPECT_TRUE(is_dark(side, 15.0F));
    EXPECT_TRUE(is_dark(side, -15.0F));
    EXPECT_FALSE(is_dark(side, 0.0F));
  }
}

TEST(Plot, PlotsAreArrangedRowByRow) {
  const PlotSheet sheet = {.columns = 2,
                           .left_px = 10.0F,
                           .right_px = 30.0F,
                           .top_px = 5.0F,
                           .width_px = 300.0F,
                           .height_px = 200.0F,
                           .gap_px = 20.0F,
                           .row_gap_px = 7.0F};
  const Area fourth = plot_area(sheet, 3);
  EXPECT_EQ(fourth.x_px, 330.0F);
  EXPECT_EQ(fourth.y_px, 5.0F + 200.0F + sheet.caption.height_px() + 7.0F);
  const Drawing drawing = draw_plot_sheet(std::vector<PlotPanel>(3), sheet);
  EXPECT_EQ(drawing.width_px, 660);
  EXPECT_EQ(drawing.height_px, static_cast<int>(2.0F * (fourth.y_px - 5.0F) + 10.0F));
}

TEST(Csv, QuotesWhatNeedsItAndReadsBackExactly) {
  CsvTable table("name,value");
  table.add("a,\"b\"", 0.1 + 0.2);
  EXPECT_EQ(table.text(), "name,value\n\"a,\"\"b\"\"\",0.30000000000000004\n");
  EXPECT_THROW(table.add("one"), std::invalid_argument);
  CsvTable blank("a,b");
  blank.add(NAN, 2);
  EXPECT_EQ(blank.text(), "a,b\n,2\n");
}

}  // namespace
}  // namespace taut::app

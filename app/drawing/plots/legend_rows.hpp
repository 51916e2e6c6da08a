#pragma once

#include <string>
#include <vector>

#include "app/drawing/plots/plot.hpp"

namespace taut::app {

/// The names of curves in the middle of a picture, in as many rows as its width asks for.
class LegendRows {
 public:
  /// The first row begins with `heading`: what the curves differ in.
  LegendRows(const std::string& heading, const std::vector<Curve>& curves, float width_px,
             const PlotStyle& style);

  /// 0 without curves.
  float height_px() const { return row_px_ * static_cast<float>(rows_.size()); }
  void draw(renderer::Canvas& canvas, float top_px) const;

 private:
  struct Entry {
    Curve curve;
    float width_px;
  };
  struct Row {
    std::vector<Entry> entries;
    float width_px = 0.0F;
  };

  std::string heading_;
  float heading_px_;  ///< its width
  PlotStyle style_;
  float between_px_;
  float row_px_;
  std::vector<Row> rows_;
};

}  // namespace taut::app

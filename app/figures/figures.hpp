#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/drawing/studio.hpp"
#include "app/figures/drawing.hpp"
#include "app/figures/experiments.hpp"

namespace taut::app {

/// Opens a studio when the first picture is to be drawn in it: diagrams and plots need none.
class StudioDoor {
 public:
  explicit StudioDoor(std::string backend) : backend_(std::move(backend)) {}

  Studio& open() {
    if (!studio_) {
      studio_ = std::make_unique<Studio>(backend_);
    }
    return *studio_;
  }
  /// Empty while none is open.
  std::string gl_renderer() const { return studio_ ? studio_->gl_renderer() : ""; }

 private:
  std::string backend_;
  std::unique_ptr<Studio> studio_;
};

/// A figure of the paper, or of what it argues.
struct Figure {
  std::string name;   ///< "fig2"
  std::string title;  ///< what it shows, for the report
  std::vector<Experiment> needs;
  Drawing (*draw)(const Results&, StudioDoor&);
  std::string (*csv)(const Results&) = nullptr;
  bool needs_frame_times = false;
};

Drawing draw_figure1(const Results& results, StudioDoor& studio);
Drawing draw_figure2(const Results& results, StudioDoor& studio);
Drawing draw_figure3(const Results& results, StudioDoor& studio);
Drawing draw_figure4(const Results& results, StudioDoor& studio);
Drawing draw_figure5(const Results& results, StudioDoor& studio);
Drawing draw_figure6(const Results& results, StudioDoor& studio);
Drawing draw_figure7(const Results& results, StudioDoor& studio);
std::string figure3_csv(const Results& results);
std::string figure6_csv(const Results& results);
std::string figure7_csv(const Results& results);

/// In the order of the paper.
const std::vector<Figure>& all_figures();
std::vector<std::string> figure_names();

}  // namespace taut::app

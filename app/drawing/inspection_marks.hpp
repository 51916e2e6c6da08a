#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "renderer/page/colour.hpp"

namespace taut::app {

/// Lines or dots of one meaning in the picture of an inspection.
struct InspectionMarks {
  std::string meaning;  ///< for the legend, with how many there are
  renderer::Colour colour{0.0F};
  float width_px = 1.0F;               ///< of lines, diameter of dots
  float opacity = 1.0F;                ///< of lines
  bool dots = false;                   ///< one point each; else two points for each line
  bool seen_through = false;           ///< drawn over surfaces that hide them: few and important
  std::vector<glm::vec3> points = {};  ///< metres, in the scene
};

struct MarkWidths {
  float spring_px = 1.0F;  ///< of structural springs
  float dot_px = 6.0F;
};

/// All that there are, those below first.
std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, const MarkWidths& widths);

}  // namespace taut::app

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/claims.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A figure as it was written.
struct DrawnFigure {
  std::string name;
  std::string title;
  renderer::Image picture;
};

struct Report {
  std::string html;
  std::string claims_json;
};

/// Everything has to be measured and every figure drawn.
Report make_report(const Results& results, std::span<const DrawnFigure> figures,
                   const std::string& gl_renderer);

/// One file that opens from anywhere: pictures are inside.
std::string report_html(std::span<const Claim> claims, std::span<const DrawnFigure> figures,
                        const Machine& machine);

/// All figures small on one picture, on `scale` times as many pixels each way as it has by itself.
renderer::Image contact_sheet(std::span<const DrawnFigure> figures, float scale = 1.0F);

/// The picture so wide.
renderer::Image scaled_to_width(const renderer::Image& picture, int width_px);

/// RFC 4648.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace taut::app

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/claims.hpp"
#include "app/report/promises.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A figure that was drawn.
struct DrawnFigure {
  std::string name;
  std::string title;
  renderer::Image picture;
};

/// The report as a page for people and as JSON.
struct Report {
  std::string html;
  std::string claims_json;
};

/// All experiments must have been made and all figures drawn.
Report make_report(const Results& results, std::span<const DrawnFigure> figures,
                   const std::string& gl_renderer);

/// The report as one HTML file. Pictures are embedded, so it opens from any folder.
std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const Machine& machine);

/// All figures, small, on one picture. `scale` multiplies its pixels each way.
renderer::Image contact_sheet(std::span<const DrawnFigure> figures, float scale = 1.0F);

/// The picture scaled to this width; its proportions stay.
renderer::Image scaled_to_width(const renderer::Image& picture, int width_px);

/// The bytes as base64 (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace taut::app

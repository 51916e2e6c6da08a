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

/// The moving picture at the top of the report.
struct Film {
  renderer::Image still;  ///< stands there where no film can be shown
  std::string mp4;        ///< the bytes of the file; empty: there is none
};

/// A film with more bytes is left out of the report, which is a page to be mailed.
inline constexpr std::size_t most_film_bytes = 450'000;

/// The report as a page for people and as JSON.
struct Report {
  std::string html;
  std::string claims_json;
};

/// All experiments must have been made and all figures drawn.
Report make_report(const Results& results, const Film& film, std::span<const DrawnFigure> figures,
                   const std::string& gl_renderer);

/// The film of a checked run and what was measured in it, as a figure of the page.
std::string film_html(const Film& film, const Recording& run);

/// The text below figure 8: who made each of its methods for what, and a table of what was measured.
std::string methods_html(const Results& results);

/// The report as one HTML file with `film_figure` at its top and `methods` below the figures. Pictures are
/// embedded, so it opens from any folder. The PDFs that it links to are expected beside it.
std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const Machine& machine,
                        const std::string& film_figure = "", const std::string& methods = "");

/// How pictures lie on a contact sheet.
struct SheetLayout {
  int columns = 3;
  int cell_px = 800;  ///< width of a picture
  float title_px = 30.0F;
};

/// All figures, small, on one picture, each in the column that is shortest so far. `scale` multiplies its
/// pixels each way.
renderer::Image contact_sheet(std::span<const DrawnFigure> figures, float scale = 1.0F,
                              const SheetLayout& layout = {});

/// The picture scaled to this width; its proportions stay.
renderer::Image scaled_to_width(const renderer::Image& picture, int width_px);

}  // namespace taut::app

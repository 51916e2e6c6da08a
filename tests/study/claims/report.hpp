#pragma once

#include "app/figures/figures.hpp"
#include "tests/study/claims/claims.hpp"

namespace taut::app {

/// Promises about the frames of a scene in a figure, with counts.
struct PromiseResult {
  std::string figure;  ///< "fig5"
  std::string scene;
  std::optional<double> bound;  ///< largest promised stretch, a fraction; empty: none is promised
  bool is_apart = false;        ///< promises that nothing crosses
  PromiseCounts counts;

  bool is_bound_kept() const;
  bool is_kept_apart() const { return counts.crossing_frames == 0; }
};

/// Returns the results of all scenes of figures 2 to 5 whose frames were checked.
std::vector<PromiseResult> promise_results(const Results& results);

/// Describes the promises and their results in a sentence or two.
std::string describe(const std::vector<PromiseResult>& results);

/// Returns the report as report_html() does. All experiments must be done and all figures drawn.
std::string make_report(const ClaimResults& results, const DrawnFigures& drawn);

/// Returns the text below figure 8: author and purpose of each method, and a table of measurements.
std::string methods_html(const ClaimResults& results);

/// Returns the report as one HTML file, with `methods` below the figures. `machine` describes the machine and the
/// program of the measurements. Pictures are embedded, so it opens from any folder. Its links expect the PDFs beside
/// it.
std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const std::string& machine = "",
                        const std::string& methods = "", const std::string& truth = "", const std::string& wind = "");

// Files of assets/report, embedded when the program is built.

/// HTML page of the report with its style. <!--machine-->, <!--claims-->, <!--promises-->, <!--figures-->,
/// <!--methods-->, <!--truth--> and <!--wind--> are replaced.
extern const char* const report_page;
/// Text below figure 8 as HTML. <!--rows--> is replaced by the table's rows.
extern const char* const methods_text;
/// Texts of the claims as TOML. {names} are replaced by the numbers of the rules.
extern const char* const claim_texts;

/// Returns the bytes as base64 (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace taut::app

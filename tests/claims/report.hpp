#pragma once

#include "app/figures/figures.hpp"
#include "tests/claims/claims.hpp"

namespace taut::app {

/// The machine and the program that numbers were measured with.
struct Machine {
  std::string processor;
  unsigned threads = 0;  ///< hardware threads
  std::string system;    ///< operating system
  double load = 0.0;     ///< processes that wanted a processor, averaged over the last minute
  std::string compiler;  ///< name and version
  std::string program;   ///< name and version
  std::string gl_renderer;
};

/// The promises about the frames of a figure, and the counts in them.
struct PromiseResult {
  std::string figure;  ///< "fig5"
  std::string scene;
  std::optional<double> bound;  ///< the largest stretch that is promised, a fraction; empty: none is
  bool is_apart = false;        ///< whether it is promised that nothing crosses
  PromiseCounts counts;

  bool is_bound_kept() const;
  bool is_kept_apart() const { return counts.crossing_frames == 0; }
};

/// The results of all scenes of figures 2 to 5 whose frames were checked.
std::vector<PromiseResult> promise_results(const Results& results);

/// In a sentence or two what was promised and what came of it.
std::string describe(const std::vector<PromiseResult>& results);

/// The report as a page for people and as JSON.
struct Report {
  std::string html;
  std::string claims_json;
};

/// All experiments must have been made and all figures drawn.
Report make_report(const ClaimResults& results, const DrawnFigures& drawn);

/// All claims, and what is promised, as one JSON object.
std::string claims_json(const std::vector<Claim>& claims, const std::vector<PromiseResult>& promises,
                        const Machine& machine);

/// The text below figure 8: who made each of its methods for what, and a table of what was measured.
std::string methods_html(const ClaimResults& results);

/// The report as one HTML file with `methods` below the figures. Pictures are
/// embedded, so it opens from any folder. The PDFs that it links to are expected beside it.
std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const Machine& machine, const std::string& methods = "",
                        const std::string& truth = "", const std::string& rests = "");

// assets/report, embedded when the program is built.

/// The HTML page of the report with its style. <!--machine-->, <!--claims-->,
/// <!--promises-->, <!--figures-->, <!--methods-->, <!--truth--> and <!--rests--> are replaced.
extern const char* const report_page;
/// The text below figure 8 as HTML. <!--rows--> is replaced by those of its table.
extern const char* const methods_text;
/// The texts of the claims as TOML. {names} are replaced by the numbers of the rules.
extern const char* const claim_texts;

/// The bytes as base64 (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace taut::app

#pragma once

#include "app/figures/figures.hpp"
#include "tests/study/reference/cases.hpp"
#include "tests/study/reference/measures.hpp"

namespace taut::app {

/// Comparison of cloth at rest by the incremental potential of tests/study/reference and by `bounded`.
struct RestComparison {
  std::string title;
  Recording reference, taut;    ///< shapes of both from the same start
  reference::Difference apart;  ///< between reference and taut
  reference::Drape by_reference, by_taut;
  double reference_j = 0.0, taut_j = 0.0;  ///< incremental potential of both shapes
  reference::Difference moved;             ///< movement of Taut's shape until the incremental potential is at rest
  reference::Difference from_taut;         ///< between the incremental potential's shapes from Taut's shape and from
                                           ///< the start
  double from_taut_j = 0.0;
  reference::Difference from_reference;  ///< between the potential's shape and Taut's shape that starts from it
  reference::Difference stiffer;         ///< between the potential's shapes with the rigidity and with a tenth more
  reference::Drape by_stiffer;
};

/// Returns the shape in which `bounded` brings the incremental potential's cloth to rest, with `physics` times its
/// rigidity. It starts from the case's start, or from `start`.
reference::Vector find_rest(const reference::RestCase& what, double physics = 1.0,
                            const std::optional<reference::Vector>& start = {});

/// Returns the stored shape of a case. Throws as reference::kept_rest does.
reference::Vector kept_rest(const reference::RestCase& what);

/// Compares two T-shirts and a cloth on a ball.
std::vector<RestComparison> compare_rests(const ProgressCallback& report);

/// Returns the drape coefficient as Cusick defines it for a disc: the shadow beyond the ball's, as a fraction of the
/// flat cloth beyond it.
double drape_coefficient(const reference::RestCase& what, const reference::Vector& shape);

/// Returns the figure "rest_shapes", shapes side by side. Its experiment has the same name.
Figure rest_figure(std::vector<RestComparison>& rests);
/// Returns the report's table of the comparisons as HTML.
std::string rest_html(std::span<const RestComparison> rests);

}  // namespace taut::app

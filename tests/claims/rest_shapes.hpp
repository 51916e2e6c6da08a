#pragma once

#include "app/figures/figures.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/measures.hpp"

namespace taut::app {

/// Cloth at rest by the incremental potential of tests/reference and by `bounded`.
struct RestComparison {
  std::string title;
  Recording reference, taut;    ///< both from the same start
  reference::Difference apart;  ///< of these
  reference::Drape by_reference, by_taut;
  double reference_j = 0.0, taut_j = 0.0;  ///< the incremental potential of both
  reference::Difference moved;             ///< by the incremental potential, from Taut's shape on until it is at rest
  reference::Difference from_taut;         ///< of where it comes to rest then and of where it does from the start
  double from_taut_j = 0.0;
  reference::Difference from_reference;  ///< of Taut's shape at rest if it begins in the other's, and of the other's
  reference::Difference stiffer;         ///< of the incremental potential's shapes with the rigidity and a tenth more
  reference::Drape by_stiffer;
};

/// Cloth as the incremental potential has it, but for a rigidity that is `physics` times as large, in the shape in
/// which `bounded` lets it rest. It begins where the case does, or in `start`.
reference::Vector rest_of(const reference::RestCase& what, double physics = 1.0,
                          const std::optional<reference::Vector>& start = {});

/// The kept shape of a case. Throws as reference::kept_rest does.
reference::Vector kept_rest(const reference::RestCase& what);

/// Two T-shirts, and a cloth on a ball.
std::vector<RestComparison> compare_rests(const ProgressCallback& report);

/// The shadow beyond the ball's, as a part of the cloth beyond it, as Cusick has it for a disc.
double drape_coefficient(const reference::RestCase& what, const reference::Vector& shape);

/// The figure "rest_shapes": shapes side by side. Its experiment has the same name.
Figure rest_figure(std::vector<RestComparison>& rests);
/// Tables of them for the report, as HTML.
std::string rest_html(std::span<const RestComparison> rests);

}  // namespace taut::app

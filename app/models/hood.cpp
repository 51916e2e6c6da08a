#include "app/models/hood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/models/support.hpp"

namespace taut::app {
namespace {

constexpr int levels = 50;          ///< at which the width of a part is measured
constexpr int shoulder_levels = 4;  ///< over which shoulders slope
constexpr double widening = 1.5;    ///< width below this slope by width above it, at least
// Fractions of a part's height.
constexpr double lowest_hood = 0.15;  ///< a lower one is a collar
constexpr double highest_hood = 0.5;  ///< what is higher is no hood but a bodice above a skirt
constexpr double neck_band = 0.03;    ///< height of the band that is held
/// height of the opening for the face, by that of the hood
constexpr double lowest_face = 0.5;
/// how far the border of a face reaches from front to back, of the hood at its height
constexpr double deepest_face = 0.6;

struct Span {
  double lower_m = std::numeric_limits<double>::infinity();
  double upper_m = -std::numeric_limits<double>::infinity();

  double width_m() const { return std::max(0.0, upper_m - lower_m); }
};

/// How far the part reaches at each level, from its top down.
std::vector<Span> spans_of(const sim::Mesh& mesh, const GarmentPart& part, int across) {
  const double step_m = part.range.size().y / levels;
  std::vector<Span> spans(levels);
  const auto add_edge = [&](const sim::Vec3& high, const sim::Vec3& low) {
    const auto first = static_cast<int>(std::ceil((part.range.upper.y - high.y) / step_m - 0.5));
    for (int k = std::max(0, first); k < levels; ++k) {
      const double level_m = part.range.upper.y - (k + 0.5) * step_m;
      if (level_m < low.y || high.y <= low.y) {
        break;
      }
      const double at_m = low[across] + (high[across] - low[across]) * (level_m - low.y) / (high.y - low.y);
      spans[k].lower_m = std::min(spans[k].lower_m, at_m);
      spans[k].upper_m = std::max(spans[k].upper_m, at_m);
    }
  };
  for (const sim::Index triangle : part.triangles) {
    const sim::Triangle& t = mesh.triangles[triangle];
    for (int k = 0; k < 3; ++k) {
      const sim::Vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
      a.y > b.y ? add_edge(a, b) : add_edge(b, a);
    }
  }
  return spans;
}

bool widens_below(const std::vector<Span>& spans, int level) {
  return level + shoulder_levels < levels && spans[level].width_m() > 0.0 &&
         spans[level + shoulder_levels].width_m() >= widening * spans[level].width_m();
}

/// The last level, from the top, above which the part widens as at shoulders; `levels` if there is none.
int neck_level(const std::vector<Span>& spans) {
  auto level = static_cast<int>(std::ceil(lowest_hood * levels));
  while (level < levels && !widens_below(spans, level)) {
    ++level;
  }
  while (widens_below(spans, level + 1)) {
    ++level;
  }
  return level;
}

/// Whether the opening is on one side at this height, as that of a face, and not around the part, as the top
/// of a bodice with straps.
bool is_on_one_side(const sim::Mesh& mesh, const GarmentPart& part, const Opening& opening, double height_m,
                    double band_m) {
  const int depth = 2 - part.across();
  const auto span_of = [&](const std::vector<sim::Index>& vertices) {
    Span span;
    for (const sim::Index v : vertices) {
      if (std::abs(mesh.positions[v].y - height_m) <= band_m) {
        span.lower_m = std::min(span.lower_m, mesh.positions[v][depth]);
        span.upper_m = std::max(span.upper_m, mesh.positions[v][depth]);
      }
    }
    return span.width_m();
  };
  return span_of(opening.vertices) <= deepest_face * span_of(part.vertices);
}

/// Whether the only wide opening above the neck is that of a face.
bool has_face(const sim::Mesh& mesh, const GarmentPart& part, double neck_m) {
  const double hood_m = part.range.upper.y - neck_m;
  const Opening* face = nullptr;
  for (const Opening& opening : part.openings) {
    if (opening.mean_height_m > neck_m && opening.length_m >= hood_m) {
      if (face != nullptr) {
        return false;
      }
      face = &opening;
    }
  }
  const double above_m = face == nullptr ? 0.0 : face->range.upper.y - std::max(neck_m, face->range.lower.y);
  return above_m >= lowest_face * hood_m &&
         is_on_one_side(mesh, part, *face, neck_m + 0.5 * hood_m, 0.2 * hood_m);
}

/// The band around the neck has to hold the part on both sides, and more than a vertex or two.
bool holds(const GarmentPart& part, const std::vector<sim::Index>& neck, const sim::Mesh& mesh) {
  constexpr std::size_t fewest = 6;
  sim::Extent range;
  for (const sim::Index v : neck) {
    range.add(mesh.positions[v]);
  }
  return neck.size() >= fewest && carries(part, range);
}

}  // namespace

std::vector<sim::Index> neck_below_hood(const sim::Mesh& mesh, const GarmentPart& part, int across) {
  const int level = neck_level(spans_of(mesh, part, across));
  const double height_m = part.range.size().y;
  const double neck_m = part.range.upper.y - (level + 0.5) * height_m / levels;
  std::vector<sim::Index> neck;
  if (level > highest_hood * levels || !has_face(mesh, part, neck_m)) {
    return neck;
  }
  for (const sim::Index v : part.vertices) {
    const double above_m = mesh.positions[v].y - neck_m;
    if (above_m >= 0.0 && above_m <= neck_band * height_m) {
      neck.push_back(v);
    }
  }
  return holds(part, neck, mesh) ? neck : std::vector<sim::Index>();
}

}  // namespace taut::app

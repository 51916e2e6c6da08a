#include "app/figures/experiments/samples/sample_garments.hpp"

#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <numbers>

namespace taut::app {
namespace {

/// The place of column c and row r. Points that coincide bit for bit are welded when the model is read, which
/// closes tubes and joins sheets.
using Surface = std::function<sim::Vec3(int column, int row)>;

enum class Faces { quads, triangles, turned_triangles };

void add_face(ModelArrays& model, std::initializer_list<sim::Index> corners) {
  model.corner_counts.push_back(static_cast<std::uint32_t>(corners.size()));
  model.corners.insert(model.corners.end(), corners);
}

// A noise that is the same everywhere, from 0 to 1.
double noise(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t mixed = (a * 73856093U) ^ (b * 19349663U);
  return static_cast<double>((mixed * 2654435761U) >> 8U) / static_cast<double>(1U << 24U);
}

void add_surface(ModelArrays& model, int columns, int rows, Faces faces, const Surface& place) {
  const auto first = static_cast<sim::Index>(model.positions.size());
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      model.positions.push_back(place(c, r));
    }
  }
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      const auto a = first + static_cast<sim::Index>(r * columns + c);
      const auto b = a + 1, d = a + static_cast<sim::Index>(columns), e = d + 1;
      if (faces == Faces::quads) {
        add_face(model, {a, b, e, d});
      } else if (noise(c, r) < 0.5) {
        add_face(model, {a, b, e});
        add_face(model, {a, e, d});
      } else {
        const bool is_turned = faces == Faces::turned_triangles;
        add_face(model, {a, is_turned ? d : b, is_turned ? b : d});
        add_face(model, {b, e, d});
      }
    }
  }
}

// Upright, its lower edge at the origin.
Surface sheet(int columns, int rows, double width_m, double height_m) {
  return [=](int c, int r) {
    return sim::Vec3(width_m * (static_cast<double>(c) / (columns - 1) - 0.5),
                     height_m * static_cast<double>(r) / (rows - 1), 0.0);
  };
}

// Around a vertical axis; its last column lies on its first.
Surface tube(int columns, int rows, const std::function<sim::Vec3(double share_of_height)>& radius_height) {
  return [=](int c, int r) {
    const double angle = 2.0 * std::numbers::pi * (c % (columns - 1)) / (columns - 1);
    const sim::Vec3 at = radius_height(static_cast<double>(r) / (rows - 1));
    return sim::Vec3(at.x * std::cos(angle), at.y, -at.x * std::sin(angle));
  };
}

Surface straight_tube(int columns, int rows, double lower_radius_m, double upper_radius_m, double height_m) {
  return tube(columns, rows, [=](double share) {
    return sim::Vec3(lower_radius_m + share * (upper_radius_m - lower_radius_m), share * height_m, 0.0);
  });
}

Surface moved(Surface surface, const sim::Vec3& by_m) {
  return [=](int c, int r) { return surface(c, r) + by_m; };
}

ModelArrays one_surface(int columns, int rows, Faces faces, const Surface& place) {
  ModelArrays model;
  add_surface(model, columns, rows, faces, place);
  return model;
}

ModelArrays irregular_sheet() {
  constexpr int columns = 14, rows = 18;
  return one_surface(columns, rows, Faces::triangles, [](int c, int r) {
    const double spread = c == 0 || r == 0 || c == columns - 1 || r == rows - 1 ? 0.0 : 0.02;
    return sheet(columns, rows, 0.6, 0.8)(c, r) +
           spread * sim::Vec3(noise(c, 100U + r) - 0.5, noise(c, 200U + r) - 0.5, noise(c, 300U + r) - 0.5);
  });
}

// Rows from 6 cm down to 2 mm.
ModelArrays graded_sheet() {
  constexpr int columns = 14, rows = 24;
  return one_surface(columns, rows, Faces::triangles, [](int c, int r) {
    return sim::Vec3(0.04 * (c - 6.5), 0.5 * (1.0 - std::pow(0.87, r)), 0.0);
  });
}

// Without any border: both of its poles are one point.
ModelArrays cushion() {
  constexpr int columns = 25, rows = 13;
  return one_surface(columns, rows, Faces::triangles, [](int c, int r) {
    const bool is_pole = r == 0 || r == rows - 1;
    return tube(columns, rows, [=](double share) {
      const double angle = std::numbers::pi * share;
      return sim::Vec3(is_pole ? 0.0 : 0.3 * std::sin(angle), -0.2 * std::cos(angle), 0.0);
    })(c, r);
  });
}

ModelArrays body_and_sleeves() {
  ModelArrays model;
  add_surface(model, 25, 14, Faces::triangles, straight_tube(25, 14, 0.28, 0.2, 0.6));
  for (const double side : {-1.0, 1.0}) {
    add_surface(model, 13, 10, Faces::triangles,
                moved(straight_tube(13, 10, 0.09, 0.11, 0.4), {0.5 * side, 0.2, 0.0}));
  }
  return model;
}

ModelArrays skirt_and_lining() {
  ModelArrays model;
  for (const double inwards_m : {0.0, 0.01}) {
    add_surface(model, 25, 12, Faces::quads, straight_tube(25, 12, 0.35 - inwards_m, 0.2 - inwards_m, 0.5));
  }
  return model;
}

// Three sheets that share one edge.
ModelArrays three_sheets() {
  constexpr int columns = 9, rows = 14;
  ModelArrays model;
  for (int wing = 0; wing < 3; ++wing) {
    const double angle = 2.0 * std::numbers::pi * wing / 3.0;
    add_surface(model, columns, rows, Faces::triangles, [=](int c, int r) {
      return sim::Vec3(0.04 * c * std::cos(angle), 0.05 * r, 0.04 * c * std::sin(angle));
    });
  }
  return model;
}

// One side and one border.
ModelArrays moebius_band() {
  constexpr int columns = 61, rows = 5;
  return one_surface(columns, rows, Faces::triangles, [](int c, int r) {
    const bool is_seam = c == columns - 1;
    const double angle = is_seam ? 0.0 : 2.0 * std::numbers::pi * c / (columns - 1);
    const double across_m = 0.04 * (is_seam ? rows / 2 - r : r - rows / 2);
    const double reach_m = 0.4 + across_m * std::cos(0.5 * angle);
    return sim::Vec3(reach_m * std::cos(angle), across_m * std::sin(0.5 * angle), reach_m * std::sin(angle));
  });
}

// Each cell with corners of its own, from whole numbers, so that those of neighbours coincide.
ModelArrays honeycomb() {
  constexpr int corners[6][2] = {{0, 1}, {1, 0}, {2, 1}, {2, 3}, {1, 4}, {0, 3}};
  ModelArrays model;
  for (int r = 0; r < 10; ++r) {
    for (int c = 0; c < 10; ++c) {
      const auto first = static_cast<sim::Index>(model.positions.size());
      for (const auto& [x, y] : corners) {
        model.positions.emplace_back(0.03 * (2 * c + r % 2 + x), 0.02 * (3 * r + y), 0.0);
      }
      add_face(model, {first, first + 1, first + 2, first + 3, first + 4, first + 5});
    }
  }
  return model;
}

}  // namespace

std::vector<SampleGarment> make_sample_garments() {
  return {
      {"sheet", "obj", "an open sheet of quads", one_surface(14, 18, Faces::quads, sheet(14, 18, 0.6, 0.8))},
      {"irregular", "ply", "irregular triangles", irregular_sheet()},
      {"graded", "off", "triangles from 6 cm down to 2 mm", graded_sheet()},
      {"skirt", "stl", "a tube of unconnected triangles",
       one_surface(25, 14, Faces::triangles, straight_tube(25, 14, 0.4, 0.18, 0.6))},
      {"turned", "obj", "triangles that face both ways",
       one_surface(14, 18, Faces::turned_triangles, sheet(14, 18, 0.6, 0.8))},
      {"cushion", "dae", "closed, without a border", cushion()},
      {"sleeves", "dae", "three parts that are not joined", body_and_sleeves()},
      {"lining", "fbx", "two layers", skirt_and_lining()},
      {"wings", "ply", "three sheets at one edge, non-manifold", three_sheets()},
      {"band", "stl", "a Möbius band, one-sided", moebius_band()},
      {"honeycomb", "obj", "hexagons", honeycomb()},
  };
}

}  // namespace taut::app

// Checks the files of the committed mannequins, whatever program made them: a tape measures the published girths on
// them.

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <set>

#include "app/verify/crossing_pairs.hpp"
#include "mannequin/body_file.hpp"
#include "mannequin/section.hpp"

namespace taut::test {
namespace {

using sim::Index;
using sim::Triangle;
using sim::Vec3;

const std::filesystem::path assets = TAUT_ASSETS_DIR;
constexpr double tape_tolerance_m = 1e-3;

class Mannequin : public testing::TestWithParam<const char*> {
 protected:
  Mannequin() : body(read_body(assets / "bodies" / (std::string("mannequin_") + GetParam() + ".glb"))) {
    const toml::table file = toml::parse_file((assets / "bodies/mannequin/measurements.toml").string());
    for (const auto& [name, value] : *file["mm"][GetParam()].as_table()) {
      measured[std::string(name.str())] = 1e-3 * value.value<double>().value();
    }
  }

  double m(const std::string& name) const { return measured.at(name); }
  double neck_point_m() const { return m("waistToFloor") + 0.959 * m("hpsToWaistBack"); }

  void expect_girth(const std::string& name, const Vec3& point, const Vec3& normal) const {
    EXPECT_NEAR(Section(body.mesh, point, normal).tight_tape_m(), m(name), tape_tolerance_m) << name;
  }
  void expect_girth(const std::string& name, double x, double height) const {
    expect_girth(name, {x, height, 0.0}, {0.0, 1.0, 0.0});
  }

  /// Height of the highest point of the surface in the plane at this x, in metres.
  double outline_m(double x) const {
    double highest = 0.0;
    for (const Triangle& t : body.mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = body.mesh.positions[t[k]];
        const Vec3& b = body.mesh.positions[t[(k + 1) % 3]];
        if ((a.x > x) != (b.x > x)) {
          highest = std::max(highest, glm::mix(a.y, b.y, (x - a.x) / (b.x - a.x)));
        }
      }
    }
    return highest;
  }

  BodyFile body;
  std::map<std::string, double> measured;
};

TEST_P(Mannequin, HasThePublishedGirthsAroundTheTrunk) {
  const double waist_m = m("waistToFloor");
  expect_girth("waist", 0.0, waist_m);
  expect_girth("hips", 0.0, waist_m - m("waistToHips"));
  expect_girth("seat", 0.0, waist_m - m("waistToSeat"));
  expect_girth("chest", 0.0, waist_m + m("hpsToWaistFront") - m("hpsToBust"));
  if (measured.contains("underbust")) {
    expect_girth("underbust", 0.0, waist_m + m("waistToUnderbust"));
  }
  const double head_factor = m("head") / 0.601;
  expect_girth("neck", 0.0, neck_point_m() + 0.045 * head_factor);
  expect_girth("head", 0.0, neck_point_m() + 0.185 * head_factor);
}

TEST_P(Mannequin, HasThePublishedGirthsAroundArmsAndLegs) {
  for (const std::string side : {"Left", "Right"}) {
    const Vec3 shoulder = body.places[body.joint(side + "Arm")];
    const Vec3 to_elbow = body.places[body.joint(side + "ForeArm")] - shoulder;
    const Vec3 along = glm::normalize(to_elbow);
    EXPECT_NEAR(glm::length(to_elbow), m("shoulderToElbow"), 1e-6);
    expect_girth("biceps", shoulder + 0.5 * to_elbow, along);
    expect_girth("wrist", shoulder + m("shoulderToWrist") * along, along);
    const double knee_x = body.places[body.joint(side + "Leg")].x;
    expect_girth("upperLeg", knee_x, m("waistToFloor") - m("waistToUpperLeg") - 0.02);
    expect_girth("knee", knee_x, m("waistToFloor") - m("waistToKnee"));
    expect_girth("ankle", knee_x, 0.093 * m("waistToFloor"));
  }
}

TEST_P(Mannequin, HasShouldersAsWideAndAsSteepAsPublished) {
  const double half_m = 0.5 * m("shoulderToShoulder");
  const double neck_m = 0.165 * m("neck");
  const double tan_13_degrees = std::tan(13.0 * std::acos(-1.0) / 180.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(outline_m(side * half_m), neck_point_m() - tan_13_degrees * (half_m - neck_m),
                tape_tolerance_m);
    const double inner_m = half_m - 0.11;
    const double slope = (outline_m(side * inner_m) - outline_m(side * half_m)) / (half_m - inner_m);
    EXPECT_NEAR(slope, tan_13_degrees, 0.05);
  }
}

TEST_P(Mannequin, StandsOnTheFloorAtTheOriginAndFacesTheFront) {
  Vec3 low(1e9);
  Vec3 high(-1e9);
  Vec3 soles(0.0);
  double count = 0.0;
  for (const Vec3& p : body.mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
    soles += p.y < 0.02 ? p : Vec3(0.0);
    count += p.y < 0.02 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(low.y, 0.0, 1e-6);
  EXPECT_NEAR(high.y, neck_point_m() + 0.272 * m("head") / 0.601, tape_tolerance_m);
  EXPECT_EQ(low.x, -high.x);
  EXPECT_NEAR(soles.z / count, 0.03, 0.03);
  EXPECT_GT(body.places[body.joint("LeftHand")].x, 0.5);
  EXPECT_GT(body.places[body.joint("LeftToeBase")].z, body.places[body.joint("LeftFoot")].z + 0.08);
  const Vec3 arm = body.places[body.joint("LeftForeArm")] - body.places[body.joint("LeftArm")];
  EXPECT_NEAR(std::atan2(-arm.y, arm.x) * 180.0 / std::acos(-1.0), 43.0, 0.01);
}

TEST_P(Mannequin, IsOneClosedSurfaceWithItsOutsideOut) {
  std::set<std::pair<Index, Index>> edges;
  std::vector<Index> part(body.mesh.positions.size());
  std::iota(part.begin(), part.end(), Index{0});
  const auto find = [&part](Index v) {
    while (part[v] != v) {
      v = part[v] = part[part[v]];
    }
    return v;
  };
  double six_volumes = 0.0;
  for (const Triangle& t : body.mesh.triangles) {
    const auto& p = body.mesh.positions;
    six_volumes += glm::dot(p[t[0]], glm::cross(p[t[1]], p[t[2]]));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "an edge twice in the same direction";
      part[find(t[k])] = find(t[(k + 1) % 3]);
    }
  }
  for (const auto& [a, b] : edges) {
    EXPECT_TRUE(edges.contains({b, a})) << "a border at vertex " << a;
  }
  for (Index v = 0; v < part.size(); ++v) {
    EXPECT_EQ(find(v), find(0)) << "another part at vertex " << v;
  }
  EXPECT_EQ(static_cast<long>(part.size()) - static_cast<long>(edges.size() / 2) +
                static_cast<long>(body.mesh.triangles.size()),
            2);
  EXPECT_GT(six_volumes / 6.0, 0.04);
  EXPECT_LT(six_volumes / 6.0, 0.13);
}

/// A vertex has two fans of triangles where two tips of a surface touch in it.
TEST_P(Mannequin, HasOneFanOfTrianglesAroundEveryVertex) {
  std::map<std::pair<Index, Index>, Index> third;
  std::vector<std::size_t> triangles_at(body.mesh.positions.size(), 0);
  for (const Triangle& t : body.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      third[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
      ++triangles_at[t[k]];
    }
  }
  for (Index v = 0; v < triangles_at.size(); ++v) {
    const auto start = third.lower_bound({v, 0});
    ASSERT_TRUE(start != third.end() && start->first.first == v) << "no triangle at vertex " << v;
    std::size_t steps = 1;
    for (Index next = start->second; next != start->first.second && steps <= triangles_at[v]; ++steps) {
      next = third.at({v, next});
    }
    EXPECT_EQ(steps, triangles_at[v]) << "vertex " << v;
  }
}

TEST_P(Mannequin, IsMeshedEvenly) {
  EXPECT_GE(body.mesh.triangles.size(), 5000U);
  EXPECT_LE(body.mesh.triangles.size(), 10500U);
  const double chin_m = body.places[body.joint("Head")].y - 0.04;
  double sum_m = 0.0;
  for (const Triangle& t : body.mesh.triangles) {
    const auto& p = body.mesh.positions;
    double min_length_m = 1.0;
    double max_length_m = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length_m = glm::length(p[t[(k + 1) % 3]] - p[t[k]]);
      min_length_m = std::min(min_length_m, length_m);
      max_length_m = std::max(max_length_m, length_m);
      sum_m += length_m;
    }
    // The mesh is finer on faces.
    EXPECT_GT(min_length_m, p[t[0]].y > chin_m ? 0.0015 : 0.006);
    EXPECT_LT(max_length_m, 0.05);
    const double height_m = glm::length(sim::doubled_area_vector(p, t)) / max_length_m;
    EXPECT_GT(height_m / max_length_m, 0.1) << "a needle at " << p[t[0]].x << " " << p[t[0]].y << " " << p[t[0]].z;
  }
  const double mean_m = sum_m / static_cast<double>(3 * body.mesh.triangles.size());
  EXPECT_GT(mean_m, 0.018);
  EXPECT_LT(mean_m, 0.03);
}

TEST_P(Mannequin, CrossesItselfNowhereAsStored) {
  const auto pairs = app::crossing_pairs({body.mesh.positions, body.mesh.triangles});
  EXPECT_TRUE(pairs.empty()) << pairs.size() << " pairs, the first at triangle " << pairs.front().first;
}

TEST_P(Mannequin, HasAMirrorImageForEveryVertexWithMirroredWeights) {
  std::map<std::array<double, 3>, std::size_t> at;
  for (std::size_t v = 0; v < body.mesh.positions.size(); ++v) {
    const Vec3& p = body.mesh.positions[v];
    at[{p.x, p.y, p.z}] = v;
  }
  const auto by_name = [this](std::size_t v, bool mirrored) {
    std::map<std::string, float> result;
    for (std::size_t i = 0; i < 4; ++i) {
      std::string name = body.names.at(body.joints[v][i]);
      if (mirrored && name.starts_with("Left")) {
        name = "Right" + name.substr(4);
      } else if (mirrored && name.starts_with("Right")) {
        name = "Left" + name.substr(5);
      }
      if (body.weights[v][i] != 0.0F) {
        result[name] += body.weights[v][i];
      }
    }
    return result;
  };
  for (std::size_t v = 0; v < body.mesh.positions.size(); ++v) {
    const Vec3& p = body.mesh.positions[v];
    const auto image = at.find({p.x == 0.0 ? 0.0 : -p.x, p.y, p.z});
    ASSERT_NE(image, at.end()) << "vertex " << v;
    const auto here = by_name(v, true);
    const auto there = by_name(image->second, false);
    ASSERT_EQ(here.size(), there.size()) << "vertex " << v;
    for (const auto& [name, weight] : here) {
      ASSERT_TRUE(there.contains(name)) << "vertex " << v << " " << name;
      ASSERT_NEAR(there.at(name), weight, 1e-6) << "vertex " << v << " " << name;
    }
  }
}

TEST_P(Mannequin, HasWeightsThatAddUpToOne) {
  for (std::size_t v = 0; v < body.weights.size(); ++v) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GE(body.weights[v][i], 0.0F);
      EXPECT_LT(body.joints[v][i], body.names.size());
      sum += body.weights[v][i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-6) << "vertex " << v;
  }
}

/// Vertices of a limb follow the limb's joint and no other.
TEST_P(Mannequin, MovesAllJoints) {
  std::vector<double> sums(body.names.size(), 0.0);
  for (std::size_t v = 0; v < body.weights.size(); ++v) {
    for (std::size_t i = 0; i < 4; ++i) {
      sums[body.joints[v][i]] += body.weights[v][i];
    }
  }
  EXPECT_EQ(body.names.size(), 22U);
  for (std::size_t j = 0; j < sums.size(); ++j) {
    EXPECT_GT(sums[j], 10.0) << body.names[j];
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Mannequin, testing::Values("male_40", "female_34", "female_42"),
                         [](const auto& size) { return std::string(size.param); });

}  // namespace
}  // namespace taut::test

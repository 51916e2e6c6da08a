#include "tailor/mannequin/weights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace taut::tailor {
namespace {

using Row = std::vector<double>;  // weight of every joint

constexpr double midline_m =
    0.03;                         // half the width in which the influence of the left joints becomes the right joints'
constexpr double reach_m = 0.04;  // distance from a limb beyond which a vertex does not follow it
constexpr double min_weight = 1e-3;  // smaller weights are dropped
constexpr int smoothing_rounds = 6;

double smooth_step(double from_minus_1_to_1) {
  const double s = std::clamp(0.5 * from_minus_1_to_1 + 0.5, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// Returns the distance in metres of a point on the left from the limb that follows the joint.
double limb_distance_m(const Body& body, const Joint& joint, const Vec3& left) {
  double distance = chain_distance_m(body.shape, joint.chain, left);
  for (const Joint& child : body.joints) {
    if (child.recipe.parent == joint.recipe.name && child.chain != joint.chain) {
      distance = std::min(distance, limb_distance_m(body, child, left));
    }
  }
  return distance;
}

/// Returns the fraction of the parent's influence that the joint takes over, without regard to other joints.
double share(const Body& body, const Joint& joint, Vec3 p) {
  const double side = joint.is_right ? -1.0 : 1.0;
  p.x *= side;
  const Vec3 from = p - Vec3(side * joint.place_m.x, joint.place_m.y, joint.place_m.z);
  double result = smooth_step(glm::dot(from, joint.recipe.hinge) / joint.recipe.width_m);
  if (joint.recipe.name.starts_with("Left")) {
    const double off_m = limb_distance_m(body, joint, p) - reach_m;
    result *= smooth_step(p.x / midline_m) * (1.0 - smooth_step(2.0 * off_m / reach_m));
  }
  return result;
}

/// Returns the joints' fractions. A point that follows a child follows its parent too: a hand hangs below the hinges of
/// the spine that it follows.
Row shares_at(const Body& body, const Vec3& p) {
  Row shares(body.joints.size(), 1.0);
  for (std::size_t j = shares.size() - 1; j > 0; --j) {
    shares[j] = share(body, body.joints[j], p);
  }
  for (std::size_t j = shares.size() - 1; j > 0; --j) {
    double& of_parent = shares[static_cast<std::size_t>(body.joints[j].parent)];
    of_parent = std::max(of_parent, shares[j]);
  }
  return shares;
}

Row weights_at(const Body& body, const Vec3& p) {
  const std::size_t count = body.joints.size();
  Row shares = shares_at(body, p);
  Row taken(count, 0.0);
  for (std::size_t j = 1; j < count; ++j) {
    taken[static_cast<std::size_t>(body.joints[j].parent)] += shares[j];
  }
  for (std::size_t j = 1; j < count; ++j) {
    const auto parent = static_cast<std::size_t>(body.joints[j].parent);
    shares[j] *= shares[parent] / std::max(taken[parent], 1.0);
  }
  for (std::size_t j = 0; j < count; ++j) {
    shares[j] *= 1.0 - std::min(taken[j], 1.0);
  }
  return shares;
}

void smooth(std::vector<Row>& rows, const sim::Mesh& mesh) {
  std::vector<Row> sums(rows.size(), Row(rows.front().size(), 0.0));
  std::vector<double> counts(rows.size(), 0.0);
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Row& next = rows[t[(k + 1) % 3]];
      std::transform(next.begin(), next.end(), sums[t[k]].begin(), sums[t[k]].begin(), std::plus<>());
      counts[t[k]] += 1.0;
    }
  }
  for (std::size_t v = 0; v < rows.size(); ++v) {
    for (std::size_t j = 0; j < rows[v].size(); ++j) {
      rows[v][j] = 0.5 * rows[v][j] + 0.5 * sums[v][j] / counts[v];
    }
  }
}

VertexWeights keep_strongest(const Row& row) {
  std::vector<std::uint8_t> order(row.size());
  std::iota(order.begin(), order.end(), std::uint8_t{0});
  std::stable_sort(order.begin(), order.end(), [&row](auto a, auto b) { return row[a] > row[b]; });
  auto kept = static_cast<std::size_t>(
      std::count_if(order.begin(), order.begin() + 4, [&row](auto j) { return row[j] > min_weight; }));
  // Left and right joints have the same weight on the midline, so both are kept or none.
  kept -= kept == 4 && row[order[3]] == row[order[4]] ? 1 : 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < kept; ++i) {
    sum += row[order[i]];
  }
  VertexWeights result;
  float others = 0.0F;
  for (std::size_t i = kept - 1; i > 0; --i) {
    result.joints[i] = order[i];
    result.weights[i] = static_cast<float>(row[order[i]] / sum);
    others += result.weights[i];
  }
  result.joints[0] = order[0];
  result.weights[0] = 1.0F - others;
  return result;
}

std::vector<std::size_t> images(const Body& body) {
  std::vector<std::size_t> result(body.joints.size());
  for (std::size_t j = 0; j < result.size(); ++j) {
    for (std::size_t i = 0; i < result.size(); ++i) {
      const bool sided = body.joints[j].recipe.name.starts_with("Left");
      if (body.joints[i].recipe.name == body.joints[j].recipe.name &&
          (body.joints[i].is_right != body.joints[j].is_right) == sided) {
        result[j] = i;
      }
    }
  }
  return result;
}

}  // namespace

std::vector<VertexWeights> make_weights(const Body& body, const FittedBody& fitted) {
  std::vector<Row> rows;
  for (const Vec3& p : fitted.whole.positions) {
    rows.push_back(weights_at(body, p));
  }
  for (int i = 0; i < smoothing_rounds; ++i) {
    smooth(rows, fitted.whole);
  }
  const std::vector<std::size_t> image = images(body);
  std::vector<VertexWeights> result;
  for (std::size_t v = 0; v < fitted.half.positions.size(); ++v) {
    Row& row = rows[v];
    if (fitted.half.positions[v].x == 0.0) {
      const Row before = row;
      for (std::size_t j = 0; j < row.size(); ++j) {
        row[j] = 0.5 * (std::min(before[j], before[image[j]]) + std::max(before[j], before[image[j]]));
      }
    }
    result.push_back(keep_strongest(row));
  }
  for (std::size_t v = 0; v < fitted.half.positions.size(); ++v) {
    if (fitted.half.positions[v].x != 0.0) {
      result.push_back(result[v]);
      for (std::size_t i = 0; i < 4; ++i) {
        result.back().joints[i] = static_cast<std::uint8_t>(image[result[v].joints[i]]);
      }
    }
  }
  return result;
}

}  // namespace taut::tailor

#include "app/models/support.hpp"

#include <algorithm>
#include <cmath>

namespace taut::app {
namespace {

// Fractions of a part's height, or of its size where that is said.
constexpr double shortest_opening = 0.2;    ///< length around, of the size; shorter ones are holes or faults
constexpr double lowest_top_opening = 0.6;  ///< mean height of a top opening above the part's lowest point
/// from its lowest to its highest point; a steeper one is not a top opening
constexpr double steepest_top_opening = 0.4;
// Fractions of the part's width, which is its larger size along x or z. What is held carries the part in
// balance if the centre of mass is within its reach, or as far beside it as this: a strip on one side does
// not.
constexpr double off_balance_across = 0.05;
/// towards front and back, where a garment may lean; it turns a little and hangs
constexpr double off_balance_in_depth = 0.25;
/// reach of an opening that can carry a part; a smaller one is a hole or lies within a collar
constexpr double narrowest_opening = 0.1;
/// to each side, within which an armhole comes; a cuff does not
constexpr double armhole_reach = 0.4;
constexpr double beside = 0.03;      ///< from the middle; a neckline is less far to one side
constexpr double uneven_pair = 0.1;  ///< difference in mean height between two openings that are a pair

bool is_wide(const GarmentPart& part, const Opening& opening) {
  return opening.range.size()[part.across()] >= narrowest_opening * part.width_m();
}

bool is_high_and_level(const GarmentPart& part, const Opening& opening) {
  const double height_m = part.range.size().y;
  return opening.mean_height_m >= part.range.lower.y + lowest_top_opening * height_m &&
         opening.range.size().y <= steepest_top_opening * height_m;
}

/// Whether the opening comes as near to the middle as an armhole does.
bool is_near_middle(const GarmentPart& part, const Opening& opening) {
  const int axis = part.across();
  const double inside_m = std::max(opening.range.lower[axis] - part.centre_m[axis],
                                   part.centre_m[axis] - opening.range.upper[axis]);
  return inside_m <= armhole_reach * part.width_m();
}

bool is_armhole(const GarmentPart& part, const Opening& opening) {
  return is_high_and_level(part, opening) && is_near_middle(part, opening);
}

/// How far the opening's middle is to one side, of the width.
double beside_middle(const GarmentPart& part, const Opening& opening) {
  const int axis = part.across();
  return (opening.range.middle()[axis] - part.centre_m[axis]) / part.width_m();
}

bool are_a_pair(const GarmentPart& part, const Opening& a, const Opening& b) {
  const double side_a = beside_middle(part, a), side_b = beside_middle(part, b);
  if (!(std::min(side_a, side_b) < -beside && std::max(side_a, side_b) > beside)) {
    return false;
  }
  sim::Extent held = a.range;
  held.add(b.range.lower);
  held.add(b.range.upper);
  return is_armhole(part, a) && is_armhole(part, b) && carries(part, held) &&
         std::abs(a.mean_height_m - b.mean_height_m) <= uneven_pair * part.range.size().y;
}

}  // namespace

std::vector<const Opening*> large_openings(const GarmentPart& part) {
  std::vector<const Opening*> large;
  for (const Opening& opening : part.openings) {
    if (opening.length_m >= shortest_opening * part.size_m()) {
      large.push_back(&opening);
    }
  }
  return large;
}

bool carries(const GarmentPart& part, const sim::Extent& held) {
  const auto reaches = [&](int axis, double slack) {
    return part.centre_m[axis] >= held.lower[axis] - slack * part.width_m() &&
           part.centre_m[axis] <= held.upper[axis] + slack * part.width_m();
  };
  return reaches(part.across(), off_balance_across) && reaches(2 - part.across(), off_balance_in_depth);
}

const Opening* top_opening(const GarmentPart& part) {
  const Opening* top = nullptr;
  const std::vector<const Opening*> large = large_openings(part);
  for (const Opening* opening : large) {
    const bool may_carry =
        is_high_and_level(part, *opening) && is_wide(part, *opening) && carries(part, opening->range);
    if (may_carry && (top == nullptr || opening->mean_height_m > top->mean_height_m)) {
      top = opening;
    }
  }
  return large.size() >= 2 ? top : nullptr;
}

const Opening* inner_opening(const GarmentPart& part) {
  const Opening* inner = nullptr;
  const std::vector<const Opening*> large = large_openings(part);
  for (const Opening* opening : large) {
    const bool may_carry = is_wide(part, *opening) && carries(part, opening->range);
    if (may_carry && (inner == nullptr || opening->length_m < inner->length_m)) {
      inner = opening;
    }
  }
  return large.size() >= 2 ? inner : nullptr;
}

bool has_sleeves(const GarmentPart& part) {
  const std::vector<const Opening*> large = large_openings(part);
  return std::any_of(large.begin(), large.end(),
                     [&](const Opening* opening) { return !is_near_middle(part, *opening); });
}

std::vector<sim::Index> pair_of_openings(const GarmentPart& part) {
  const std::vector<const Opening*> large = large_openings(part);
  std::vector<sim::Index> pair;
  double highest_m = 0.0;
  for (std::size_t i = 0; i < large.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double height_m = large[i]->mean_height_m + large[k]->mean_height_m - 2.0 * part.range.lower.y;
      if (are_a_pair(part, *large[i], *large[k]) && height_m > highest_m) {
        highest_m = height_m;
        pair = large[i]->vertices;
        pair.insert(pair.end(), large[k]->vertices.begin(), large[k]->vertices.end());
      }
    }
  }
  return pair;
}

}  // namespace taut::app

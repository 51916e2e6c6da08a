#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/page/image.hpp"

namespace taut::tests {

/// What may differ before two pictures count as different. The defaults pass every variation of the software
/// rasteriser that was tried and catch a cloth moved by 0.3 mm.
struct PictureLimit {
  int channel_difference = 2;          ///< of 255; a pixel counts when any channel differs by more
  double differing_fraction = 0.0001;  ///< of all pixels
  double mean_difference = 0.002;      ///< of 255, over all channels
};

struct DifferingPixel {
  int x_px = 0;
  int y_px = 0;
  int difference = 0;  ///< the largest over its channels
};

struct PictureDifference {
  bool same_size = false;
  std::size_t differing_pixels = 0;
  double differing_fraction = 0.0;
  double mean_difference = 0.0;
  std::vector<DifferingPixel> worst;  ///< at most ten, the largest difference first
};

/// Compares RGB pictures pixel by pixel.
PictureDifference compare(const renderer::Image& expected, const renderer::Image& actual,
                          const PictureLimit& limit);

bool passes(const PictureDifference& difference, const PictureLimit& limit);

/// Says in words what differs, the ten worst pixels included.
std::string describe(const PictureDifference& difference, const PictureLimit& limit);

/// How many times larger than they are differences are shown.
inline constexpr int difference_amplification = 16;

/// Black where both are equal. Both have to be of the same size.
renderer::Image amplified_difference(const renderer::Image& expected, const renderer::Image& actual);

/// Expected, actual and their amplified difference. Both have to be of the same size.
renderer::Image side_by_side(const renderer::Image& expected, const renderer::Image& actual);

}  // namespace taut::tests

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/page/png.hpp"

namespace taut::tests {

/// Limits on the difference of two pictures that pass. The defaults pass every tried variation of the software
/// rasteriser, and fail for a cloth moved by 0.3 mm. Processors of two makers differ by one level in some channels, and
/// by up to 0.0225 on average, because their approximate square roots differ.
struct PictureLimit {
  int channel_difference = 2;          ///< levels of 255; a pixel counts if a channel differs by more
  double differing_fraction = 0.0001;  ///< fraction of all pixels
  double mean_difference = 0.03;       ///< levels of 255, over all channels
};

/// A pixel in which two pictures differ.
struct DifferingPixel {
  int x_px = 0;
  int y_px = 0;
  int difference = 0;  ///< largest difference of its channels
};

/// Result of a comparison.
struct PictureDifference {
  bool same_size = false;
  std::size_t differing_pixels = 0;  ///< pixels beyond PictureLimit::channel_difference
  double differing_fraction = 0.0;
  double mean_difference = 0.0;       ///< levels of 255, over all channels of all pixels
  std::vector<DifferingPixel> worst;  ///< up to ten, the largest difference first
};

/// Compares two RGB pictures pixel by pixel.
PictureDifference compare(const renderer::Image& expected, const renderer::Image& actual, const PictureLimit& limit);

/// Returns a limit for pictures that should be alike: twice the largest fraction and mean by which the others differ
/// from the first, and at least the defaults. Throws std::invalid_argument for pictures of another size.
PictureLimit propose_limit(const renderer::Image& first, const std::vector<renderer::Image>& others);

/// Returns true if the sizes are equal and no limit is exceeded.
bool passes(const PictureDifference& difference, const PictureLimit& limit);

/// Describes the difference, with the ten worst pixels.
std::string describe(const PictureDifference& difference, const PictureLimit& limit);

/// Factor by which amplified_difference() multiplies differences.
inline constexpr int difference_amplification = 16;

/// Returns the absolute difference of two pictures of the same size, amplified. Black means equal.
renderer::Image amplified_difference(const renderer::Image& expected, const renderer::Image& actual);

/// Returns the expected picture, the actual picture and their amplified difference side by side. Both must have the
/// same size.
renderer::Image side_by_side(const renderer::Image& expected, const renderer::Image& actual);

}  // namespace taut::tests

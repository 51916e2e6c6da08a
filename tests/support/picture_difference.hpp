#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/page/png.hpp"

namespace taut::tests {

/// How much two pictures may differ and still pass. The defaults pass every variation of the software
/// rasteriser that was tried, and fail for a cloth moved by 0.3 mm. Processors of two makers differ by one
/// level in some channels and by up to 0.0225 on average, as their approximate square roots do.
struct PictureLimit {
  int channel_difference = 2;          ///< of 255; a pixel counts if a channel differs by more
  double differing_fraction = 0.0001;  ///< of all pixels
  double mean_difference = 0.03;       ///< of 255, over all channels
};

/// A pixel in which two pictures differ.
struct DifferingPixel {
  int x_px = 0;
  int y_px = 0;
  int difference = 0;  ///< of the channel that differs most
};

/// The result of a comparison.
struct PictureDifference {
  bool same_size = false;
  std::size_t differing_pixels = 0;  ///< pixels beyond PictureLimit::channel_difference
  double differing_fraction = 0.0;
  double mean_difference = 0.0;       ///< of 255, over all channels of all pixels
  std::vector<DifferingPixel> worst;  ///< at most ten, the largest difference first
};

/// Compares two RGB pictures pixel by pixel.
PictureDifference compare(const renderer::Image& expected, const renderer::Image& actual, const PictureLimit& limit);

/// Whether the sizes are equal and no limit is exceeded.
bool passes(const PictureDifference& difference, const PictureLimit& limit);

/// Returns the difference in words, with the ten worst pixels.
std::string describe(const PictureDifference& difference, const PictureLimit& limit);

/// Factor by which amplified_difference() multiplies differences.
inline constexpr int difference_amplification = 16;

/// The absolute difference of two pictures of the same size, amplified. Black means equal.
renderer::Image amplified_difference(const renderer::Image& expected, const renderer::Image& actual);

/// Expected picture, actual picture and their amplified difference. Both must have the same size.
renderer::Image side_by_side(const renderer::Image& expected, const renderer::Image& actual);

}  // namespace taut::tests

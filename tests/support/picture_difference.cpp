#include "support/picture_difference.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace taut::tests {
namespace {

constexpr std::size_t worst_pixels = 10;

int max_channel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int channel = 0; channel < 3; ++channel) {
    largest = std::max(largest, std::abs(int{a[channel]} - int{b[channel]}));
  }
  return largest;
}

void keep_worst(std::vector<DifferingPixel>& worst, const DifferingPixel& pixel) {
  const auto is_worse = [](const DifferingPixel& a, const DifferingPixel& b) {
    return a.difference > b.difference;
  };
  worst.insert(std::upper_bound(worst.begin(), worst.end(), pixel, is_worse), pixel);
  if (worst.size() > worst_pixels) {
    worst.pop_back();
  }
}

}  // namespace

PictureDifference compare(const renderer::Image& expected, const renderer::Image& actual,
                          const PictureLimit& limit) {
  PictureDifference result;
  result.same_size = expected.width_px == actual.width_px && expected.height_px == actual.height_px &&
                     expected.channels == 3 && actual.channels == 3;
  if (!result.same_size) {
    return result;
  }
  for (int y = 0; y < expected.height_px; ++y) {
    for (int x = 0; x < expected.width_px; ++x) {
      const int difference = max_channel_difference(expected.at(x, y), actual.at(x, y));
      result.differing_pixels += difference > limit.channel_difference;
      if (difference > 0) {
        keep_worst(result.worst, {x, y, difference});
      }
    }
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < expected.pixels.size(); ++k) {
    sum += std::abs(int{expected.pixels[k]} - int{actual.pixels[k]});
  }
  const double pixels = static_cast<double>(expected.width_px) * expected.height_px;
  result.differing_fraction = static_cast<double>(result.differing_pixels) / pixels;
  result.mean_difference = sum / (3.0 * pixels);
  return result;
}

PictureLimit propose_limit(const renderer::Image& first, const std::vector<renderer::Image>& others) {
  PictureLimit limit;
  for (const renderer::Image& other : others) {
    const PictureDifference difference = compare(first, other, limit);
    if (!difference.same_size) throw std::invalid_argument("the pictures have different sizes");
    limit.differing_fraction = std::max(limit.differing_fraction, 2.0 * difference.differing_fraction);
    limit.mean_difference = std::max(limit.mean_difference, 2.0 * difference.mean_difference);
  }
  return limit;
}

bool passes(const PictureDifference& difference, const PictureLimit& limit) {
  return difference.same_size && difference.differing_fraction <= limit.differing_fraction &&
         difference.mean_difference <= limit.mean_difference;
}

std::string describe(const PictureDifference& difference, const PictureLimit& limit) {
  std::ostringstream text;
  if (!difference.same_size) {
    text << "the pictures have different sizes\n";
    return text.str();
  }
  text << difference.differing_pixels << " pixels (" << 100.0 * difference.differing_fraction
       << " %) differ by more than " << limit.channel_difference << " of 255; at most "
       << 100.0 * limit.differing_fraction << " % may\n"
       << "mean difference " << difference.mean_difference << " of 255; at most " << limit.mean_difference
       << "\n";
  for (const DifferingPixel& pixel : difference.worst) {
    text << "  x " << pixel.x_px << "  y " << pixel.y_px << "  difference " << pixel.difference << "\n";
  }
  return text.str();
}

renderer::Image amplified_difference(const renderer::Image& expected, const renderer::Image& actual) {
  renderer::Image difference = renderer::make_image(expected.width_px, expected.height_px);
  for (std::size_t k = 0; k < expected.pixels.size(); ++k) {
    const int distance = std::abs(int{expected.pixels[k]} - int{actual.pixels[k]});
    difference.pixels[k] = static_cast<std::uint8_t>(std::min(255, difference_amplification * distance));
  }
  return difference;
}

renderer::Image side_by_side(const renderer::Image& expected, const renderer::Image& actual) {
  const renderer::Image difference = amplified_difference(expected, actual);
  renderer::Image sheet = renderer::make_image(3 * expected.width_px, expected.height_px);
  int left_px = 0;
  for (const renderer::Image* part : {&expected, &actual, &difference}) {
    for (int y = 0; y < part->height_px; ++y) {
      std::copy_n(part->at(0, y), 3 * part->width_px, sheet.at(left_px, y));
    }
    left_px += part->width_px;
  }
  return sheet;
}

}  // namespace taut::tests

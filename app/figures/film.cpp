#include "app/figures/film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/figures/print.hpp"
#include "app/output/video_writer.hpp"

namespace taut::app {
namespace {

constexpr PictureSize film_size = {640, 480};
constexpr std::size_t fewest_pictures = 60;
// In which it dissolves into its beginning.
constexpr std::size_t seam_pictures = 10;
constexpr int frame_px = 12;

double squared_distance(const Moment& a, const Moment& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    const sim::Vec3 apart = a.positions[v] - b.positions[v];
    sum += glm::dot(apart, apart);
  }
  return sum;
}

}  // namespace

std::span<const Moment> find_loop(std::span<const Moment> moments, std::size_t fewest) {
  std::span<const Moment> best = moments;
  double least = std::numeric_limits<double>::infinity();
  // With moments before it to dissolve into, where that leaves a choice.
  const std::size_t latest = moments.size() - std::min(moments.size(), fewest + 2);
  const std::size_t earliest = std::min(seam_pictures, latest / 2);
  for (std::size_t first = earliest; first + fewest + 1 < moments.size(); ++first) {
    for (std::size_t after = first + fewest; after + 1 < moments.size(); ++after) {
      // Of the next moments too: otherwise the cloth may turn back where the film starts again.
      const double jump = squared_distance(moments[first], moments[after]) +
                          squared_distance(moments[first + 1], moments[after + 1]);
      if (jump < least) {
        least = jump;
        best = moments.subspan(first, after - first);
      }
    }
  }
  return best;
}

std::vector<renderer::Image> dissolved(std::vector<renderer::Image> pictures, std::size_t before) {
  for (std::size_t i = 0; i < before; ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(before + 1);
    renderer::Image& picture = pictures[pictures.size() - before + i];
    std::transform(picture.pixels.begin(), picture.pixels.end(), pictures[i].pixels.begin(),
                   picture.pixels.begin(), [share](std::uint8_t from, std::uint8_t to) {
                     return static_cast<std::uint8_t>(std::lround((1.0 - share) * from + share * to));
                   });
  }
  pictures.erase(pictures.begin(), pictures.begin() + static_cast<std::ptrdiff_t>(before));
  return pictures;
}

void crop(std::vector<renderer::Image>& pictures) {
  renderer::Image& front = pictures.front();
  int left = front.width_px, right = 0, top = front.height_px, bottom = 0;
  for (const renderer::Image& picture : pictures) {
    for (int y = 0; y < picture.height_px; ++y) {
      for (int x = 0; x < picture.width_px; ++x) {
        const std::uint8_t* pixel = picture.at(x, y);
        if (std::min({pixel[0], pixel[1], pixel[2]}) < 250) {
          left = std::min(left, x);
          right = std::max(right, x + 1);
          top = std::min(top, y);
          bottom = std::max(bottom, y + 1);
        }
      }
    }
  }
  left = std::max(left - frame_px, 0);
  top = std::max(top - frame_px, 0);
  const int width = (std::min(right + frame_px, front.width_px) - left) / 2 * 2;
  const int height = (std::min(bottom + frame_px, front.height_px) - top) / 2 * 2;
  if (width <= 0 || height <= 0) {
    return;
  }
  for (renderer::Image& picture : pictures) {
    renderer::Image part = renderer::make_image(width, height, picture.channels);
    for (int y = 0; y < height; ++y) {
      std::copy_n(picture.at(left, top + y), width * picture.channels, part.at(0, y));
    }
    picture = std::move(part);
  }
}

std::vector<renderer::Image> draw_film(const Recording& recording, OffscreenRenderer& offscreen) {
  const std::span<const Moment> loop = find_loop(recording.moments, fewest_pictures);
  const auto first = static_cast<std::size_t>(loop.data() - recording.moments.data());
  const std::size_t before = std::min({seam_pictures, first, loop.size()});
  std::vector<PrintedMoment> moments;
  for (std::size_t m = first - before; m < first + loop.size(); ++m) {
    // The camera is nearer where it need not see the shadow.
    moments.push_back({.recording = &recording, .moment = &recording.moments[m], .has_floor = false});
  }
  std::vector<renderer::Image> pictures =
      dissolved(print_moments(offscreen, moments, film_size, 1.0F).pictures, before);
  crop(pictures);
  return pictures;
}

std::string write_film(const std::filesystem::path& file, std::span<const renderer::Image> pictures,
                       double frame_rate_hz) {
  try {
    VideoWriter video(file, {.width_px = pictures.front().width_px,
                             .height_px = pictures.front().height_px,
                             .frame_rate_hz = frame_rate_hz});
    for (const renderer::Image& picture : pictures) {
      video.add(picture);
    }
    video.finish();
    return read_text_file(file);
  } catch (const InputError& error) {
    fmt::print(stderr, "taut: warning: the report shows a picture instead of a film: {}\n", error.what());
    return "";
  }
}

}  // namespace taut::app

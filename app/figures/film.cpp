#include "app/figures/film.hpp"

#include <fmt/core.h>

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
  for (std::size_t first = 0; first + fewest + 1 < moments.size(); ++first) {
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

std::vector<renderer::Image> draw_film(const Recording& recording, OffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const Moment& moment : find_loop(recording.moments, fewest_pictures)) {
    // The camera is nearer where it need not see the shadow.
    moments.push_back({.recording = &recording, .moment = &moment, .has_floor = false});
  }
  return print_moments(offscreen, moments, film_size, 1.0F).pictures;
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

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/drawing/garment_painter.hpp"
#include "app/figures/experiments/recording.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// Times as long as it took that a film shows what happened. The caption in the report says so in words.
inline constexpr double film_slowness = 2.0;

/// The moments of a film that starts again at its end: at least `fewest`, or all if there are no more. They
/// are chosen so that the moment after the last is most like the first. The moments must have the same time
/// between them.
std::span<const Moment> find_loop(std::span<const Moment> moments, std::size_t fewest);

/// Returns the pictures without the first `before`, into which the last as many dissolve: nothing jumps where
/// they start again, and no shape is shown that was not simulated. There are at least twice as many.
std::vector<renderer::Image> dissolved(std::vector<renderer::Image> pictures, std::size_t before);

/// Cuts off what is white in all pictures, which have the same size, but for a narrow frame. Sides stay even
/// numbers.
void crop(std::vector<renderer::Image>& pictures);

/// Pictures of a film of about two seconds, made of the recording. Throws renderer::ContextError.
std::vector<renderer::Image> draw_film(const Recording& recording, OffscreenRenderer& offscreen);

/// Writes the pictures as MP4 and returns the bytes of the file. Without a working ffmpeg it warns and
/// returns an empty text.
std::string write_film(const std::filesystem::path& file, std::span<const renderer::Image> pictures,
                       double frame_rate_hz);

}  // namespace taut::app

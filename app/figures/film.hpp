#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/drawing/offscreen_renderer.hpp"
#include "app/figures/experiments/recording.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// Times as long as it took that a film shows what happened. The caption in the report says so in words.
inline constexpr double film_slowness = 2.0;

/// The moments of a film that starts again at its end: at least `fewest`, or all if there are no more. They
/// are chosen so that the moment after the last is most like the first. The moments must have the same time
/// between them.
std::span<const Moment> find_loop(std::span<const Moment> moments, std::size_t fewest);

/// Returns the moments of `loop`, a part of `moments`, with shapes that end where those before it lead:
/// towards its end they pass over into the moments that come before its first, as far as there are any, so
/// that nothing jumps where it starts again. What is passed over is drawn and not simulated.
std::vector<Moment> without_seam(std::span<const Moment> moments, std::span<const Moment> loop);

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

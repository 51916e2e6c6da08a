#pragma once

namespace taut::renderer {

/// A whole PNG file from rows without padding, to be freed with std::free; null when memory is short. Not for
/// two threads at a time. The level is libdeflate's, filter -1 chooses one for each row.
unsigned char* stb_encode_png(const unsigned char* pixels, int width_px, int height_px, int channels,
                              int level, int filter, int* size);

}  // namespace taut::renderer

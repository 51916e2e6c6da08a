#pragma once

#include "prelude.hpp"

namespace taut::app {

/// The bytes as base64 (RFC 4648, section 4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace taut::app

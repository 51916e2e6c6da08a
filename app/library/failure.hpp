#pragma once

#include <span>

#include "app/library/taut.h"

namespace taut::library {

/// Within a catch block: the result that stands for the exception, with its text, cut where it does not fit,
/// and a zero behind it. Throws nothing.
TautResult describe_failure(std::span<char> text) noexcept;

/// Writes a text, cut where it does not fit, and a zero behind it.
void put_text(const char* from, std::span<char> text) noexcept;

}  // namespace taut::library

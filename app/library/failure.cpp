#include "app/library/failure.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include "app/base/errors.hpp"
#include "app/library/arrays.hpp"
#include "sim/blocked_contact.hpp"
#include "sim/bytes.hpp"
#include "sim/simulation.hpp"

namespace taut::library {
namespace {

template <class... Errors>
bool is_any(const std::exception& error) {
  return (... || (dynamic_cast<const Errors*>(&error) != nullptr));
}

TautResult result_of(const std::exception& error) {
  if (is_any<app::UsageError, std::invalid_argument>(error)) {
    return TAUT_ERROR_ARGUMENT;
  }
  if (is_any<app::InputError, sim::BadBytes>(error)) {
    return TAUT_ERROR_INPUT;
  }
  if (is_any<app::PromiseBroken, sim::ContactBlocked>(error)) {
    return TAUT_ERROR_PROMISE;
  }
  if (is_any<sim::Diverged>(error)) {
    return TAUT_ERROR_DIVERGED;
  }
  return is_any<std::bad_alloc, std::length_error>(error) ? TAUT_ERROR_MEMORY : TAUT_ERROR_INTERNAL;
}

}  // namespace

void put_text(const char* from, std::span<char> text) noexcept {
  const std::size_t length = std::min(std::strlen(from), text.size() - 1);
  std::memcpy(text.data(), from, length);
  text[length] = '\0';
}

TautResult describe_failure(std::span<char> text) noexcept {
  try {
    throw;
  } catch (const std::exception& error) {
    put_text(error.what(), text);
    return result_of(error);
  } catch (...) {
    put_text("something was thrown that is no error", text);
    return TAUT_ERROR_INTERNAL;
  }
}

}  // namespace taut::library

#include "app/library/border.hpp"

#include <new>

#include "app/base/errors.hpp"
#include "sim/blocked_contact.hpp"
#include "sim/bytes.hpp"
#include "sim/simulation.hpp"

namespace taut::library {
namespace {

template <class... Errors> bool is_any(const std::exception& error) {
  return (... || (dynamic_cast<const Errors*>(&error) != nullptr));
}

TautResult result_of(const std::exception& error) {
  if (is_any<app::UsageError, std::invalid_argument>(error)) return TAUT_ERROR_ARGUMENT;
  if (is_any<app::InputError, sim::BadBytes>(error)) return TAUT_ERROR_INPUT;
  if (is_any<app::PromiseBroken, sim::ContactBlocked>(error)) return TAUT_ERROR_PROMISE;
  if (is_any<sim::Diverged>(error)) return TAUT_ERROR_DIVERGED;
  return is_any<std::bad_alloc, std::length_error>(error) ? TAUT_ERROR_MEMORY : TAUT_ERROR_INTERNAL;
}

struct Table {
  std::mutex mutex;
  std::uint64_t made = 0;
  std::map<std::uint64_t, std::shared_ptr<Held>> cloths;
};

/// Never destroyed: at the end of a program other threads may still hold cloths.
Table& table() {
  static Table* const only = new Table;
  return *only;
}

/// Maps each number but 0 to one of its own far from the others, so that made up ones are hardly ever hit
/// (Steele, Lea and Flood 2014).
std::uint64_t scattered(std::uint64_t number) {
  number = (number ^ (number >> 30U)) * 0xBF58476D1CE4E5B9U;
  number = (number ^ (number >> 27U)) * 0x94D049BB133111EBU;
  return number ^ (number >> 31U);
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

std::uint64_t keep(std::shared_ptr<Held> held) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const std::uint64_t id = scattered(++all.made);
  all.cloths.emplace(id, std::move(held));
  return id;
}

std::shared_ptr<Held> find(std::uint64_t id) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto found = all.cloths.find(id);
  return found == all.cloths.end() ? nullptr : found->second;
}

std::shared_ptr<Held> release(std::uint64_t id) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto found = all.cloths.find(id);
  if (found == all.cloths.end()) return nullptr;
  std::shared_ptr<Held> held = std::move(found->second);
  all.cloths.erase(found);
  return held;
}

}  // namespace taut::library

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "app/library/session.hpp"

namespace taut::library {

/// A cloth that a caller has.
struct Held {
  explicit Held(Session&& made) : session(std::move(made)) {}

  Session session;
  std::atomic<bool> is_busy = false;
  std::mutex error_mutex;  ///< as another thread may ask while this one fails
  char error[sizeof(TautError::text)] = {};
};

// The cloths that there are, by their numbers. It is the one thing that all cloths of a process share: a
// handle without it would be a pointer, and to follow one that is stale or made up is a crash. Numbers are
// never used twice.

/// Returns the number of the cloth from now on, never 0.
std::uint64_t keep(std::shared_ptr<Held> held);
/// Returns the cloth; null if there is none of this number.
std::shared_ptr<Held> find(std::uint64_t id);
/// The same, and forgets it.
std::shared_ptr<Held> release(std::uint64_t id);

}  // namespace taut::library

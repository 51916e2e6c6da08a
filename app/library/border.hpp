#pragma once

#include <cfenv>
#include <memory>

#include "app/library/failure.hpp"
#include "app/library/handles.hpp"
#include "app/library/taut.h"

namespace taut::library {

/// Rounding as the bits of a run need it, whatever the caller's program has chosen for itself.
class UsualRounding {
 public:
  UsualRounding() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~UsualRounding() { std::fesetenv(&callers_); }
  UsualRounding(const UsualRounding&) = delete;
  UsualRounding& operator=(const UsualRounding&) = delete;

 private:
  std::fenv_t callers_{};
};

/// Keeps a cloth to itself for a call.
class Turn {
 public:
  explicit Turn(Held& held) noexcept : held_(held), is_mine_(!held.is_busy.exchange(true)) {}
  ~Turn() {
    if (is_mine_) {
      held_.is_busy = false;
    }
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  bool is_mine() const { return is_mine_; }

 private:
  Held& held_;
  bool is_mine_;
};

/// The border: does it with the cloth, and makes a result of whatever is thrown.
template <class Work>
TautResult with(TautCloth cloth, const Work& work) noexcept {
  const std::shared_ptr<Held> held = find(cloth.id);
  if (!held) {
    return TAUT_ERROR_HANDLE;
  }
  const Turn turn(*held);
  if (!turn.is_mine()) {
    return TAUT_ERROR_BUSY;
  }
  const UsualRounding rounding;
  try {
    work(held->session);
    return TAUT_OK;
  } catch (...) {
    const std::lock_guard lock(held->error_mutex);
    return describe_failure(held->error);
  }
}

/// The same for calls without a cloth.
template <class Work>
TautResult guarded(const Work& work) noexcept {
  char text[sizeof(TautError::text)];
  try {
    work();
    return TAUT_OK;
  } catch (...) {
    return describe_failure(text);
  }
}

}  // namespace taut::library

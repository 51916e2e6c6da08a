#include "app/library/handles.hpp"

#include <map>
#include <mutex>
#include <utility>

namespace taut::library {
namespace {

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
  if (found == all.cloths.end()) {
    return nullptr;
  }
  std::shared_ptr<Held> held = std::move(found->second);
  all.cloths.erase(found);
  return held;
}

}  // namespace taut::library

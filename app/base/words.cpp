#include "app/base/words.hpp"

#include <fmt/format.h>

#include <cctype>

namespace taut::app {
namespace {

/// Number of first letters that may stand for a name.
constexpr std::size_t min_prefix_length = 3;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

/// Returns the first of `names` that begins with `name` (3 characters or more). Otherwise returns the name with the
/// smallest edit distance (Levenshtein 1966), at most a third of the length of `name`; empty if there is none.
std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  const auto is_begun = [&](const std::string& candidate) { return candidate.starts_with(name); };
  const auto begun = std::ranges::find_if(names, is_begun);
  if (begun != names.end() && name.size() >= min_prefix_length) return *begun;
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

std::string printable(std::string_view text) {
  std::string shown;
  unsigned char before = 0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    // These bytes end the control characters U+0080 to U+009F in UTF-8.
    const bool is_long_control = before == 0xC2 && byte >= 0x80 && byte <= 0x9F;
    const bool is_control = (byte < 0x20 && byte != '\n') || byte == 0x7F || is_long_control;
    shown += is_control ? fmt::format("\\x{:02x}", byte) : std::string(1, letter);
    before = byte;
  }
  if (shown.size() <= max_printed_bytes) return shown;
  const std::size_t half = max_printed_bytes / 2 - 40;
  return fmt::format("{} ... {} bytes more ... {}", shown.substr(0, half), shown.size() - 2 * half,
                     shown.substr(shown.size() - half));
}

std::string join(std::span<const std::string> names, std::string_view separator) {
  return fmt::format("{}", fmt::join(names, separator));
}

std::string did_you_mean(std::string_view name, std::span<const std::string> names) {
  const std::string suggestion = nearest_name(name, names);
  return suggestion.empty() ? "" : "; did you mean '" + suggestion + "'?";
}

std::string program_version() { return TAUT_VERSION; }

std::string compiler_version() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string describe_place(const glm::dvec3& place_m) {
  return fmt::format("[{:.5f}, {:.5f}, {:.5f}] m", place_m.x, place_m.y, place_m.z);
}

std::string describe_point(const glm::dvec3& point) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", point.x, point.y, point.z);
}

}  // namespace taut::app

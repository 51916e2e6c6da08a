#include <fmt/format.h>

#include <set>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/models/reading/import_confinement.hpp"
#include "app/models/reading/surface_colours.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

/// Limit on the number of files and folders that are searched.
constexpr std::size_t max_entries = std::size_t{1} << 16U;

std::string percent_encoded(const std::string& name, std::string_view plain) {
  std::string encoded;
  for (const char letter : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || plain.find(letter) != plain.npos;
    encoded += is_plain ? std::string(1, letter) : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  return encoded;
}

/// Returns the spellings of a name in the bytes of models: plain, in addresses, and in UTF-16.
std::set<std::string> spellings(const fs::path& name) {
  std::set<std::string> spelt = {name.string(), percent_encoded(name.string(), "-._~"),
                                 percent_encoded(name.string(), "-._~!$&'()*+,;=:@[]{}#^|")};
  try {
    const std::u16string wide = name.u16string();
    spelt.emplace(reinterpret_cast<const char*>(wide.data()), wide.size() * sizeof(char16_t));
  } catch (const std::exception&) {
    return spelt;  // a name that is no UTF-8 has no such spelling
  }
  return spelt;
}

std::size_t find_ending(std::string_view bytes) {
  const auto last = [&](std::size_t k) { return std::size_t{static_cast<unsigned char>(bytes[bytes.size() - k])}; };
  return 256 * last(2) + last(1);
}

/// Names of entries by their last two bytes, so that one pass finds all of them.
using Names = std::vector<std::vector<std::pair<std::string, std::size_t>>>;

Names index_names(const std::vector<fs::path>& entries) {
  Names names(65536);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    for (const std::string& name : spellings(entries[e].filename())) {
      if (name.size() >= 2) names[find_ending(name)].emplace_back(name, e);
    }
  }
  return names;
}

/// Adds the entries whose names occur in the text.
void find_names(const Names& names, const fs::path& text, std::set<std::size_t>& found) {
  constexpr std::uint64_t max_part_bytes = std::uint64_t{1} << 20U;
  constexpr std::size_t max_name_bytes = 1024;
  const SeekableFile file(text);
  std::string part;  // end of the part before, where a name may begin, and this part
  for (std::uint64_t at = 0, count = 0; at < file.size(); at += count) {
    count = std::min(file.size() - at, max_part_bytes);
    part.erase(0, part.size() - std::min(part.size(), max_name_bytes));
    part.resize(part.size() + count);
    file.read(at, std::span(part).last(count));
    for (std::size_t end = 2; end <= part.size(); ++end) {
      const std::string_view before(part.data(), end);
      for (const auto& [name, entry] : names[find_ending(before)]) {
        if (before.ends_with(name)) found.insert(entry);
      }
    }
  }
}

/// Returns the stem that files of one model share. Unreal's files have _a and _d behind it.
std::string shared_stem(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem.ends_with("_a") || stem.ends_with("_d") ? stem.substr(0, stem.size() - 2) : stem;
}

void append_entries(const fs::path& folder, std::vector<fs::path>& entries) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; entry != end && !error; entry.increment(error)) {
    if (entries.size() < max_entries) entries.push_back(entry->path());
  }
}

}  // namespace

std::vector<fs::path> named_files(const fs::path& named_model) {
  const fs::path model = fs::absolute(named_model);
  std::error_code error;
  std::vector<fs::path> files = {fs::canonical(model, error)}, texts = files, entries;
  if (!fs::is_regular_file(model, error)) return {};
  std::set<fs::path> known = {files.front(), fs::canonical(model.parent_path(), error)};
  append_entries(model.parent_path(), entries);
  for (bool names_more = true; std::exchange(names_more, false);) {
    std::set<std::size_t> found;
    for (std::size_t e = 0; e < entries.size(); ++e) {
      if (shared_stem(entries[e]) == shared_stem(model) || entries[e].filename() == "textures") found.insert(e);
    }
    const Names names = index_names(entries);
    for (const fs::path& text : texts) find_names(names, text, found);
    for (const std::size_t e : found) {
      const fs::path entry = fs::canonical(entries[e], error);
      if (error || !is_inside(entry, model.parent_path()) || !known.insert(entry).second) continue;
      const bool is_folder = fs::is_directory(entry, error), is_file = fs::is_regular_file(entry, error);
      const bool is_text = is_file && entry.extension() == ".mtl";
      if (is_folder) append_entries(entry, entries);
      if (is_file) files.push_back(entry);
      if (is_text) texts.push_back(entry);
      names_more = names_more || is_folder || is_text;
    }
  }
  return files;
}

}  // namespace taut::app

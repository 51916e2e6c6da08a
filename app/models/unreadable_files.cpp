#include <fstream>

#include "app/base/words.hpp"
#include "app/models/garment_import.hpp"

namespace taut::app {
namespace {

// The first bytes of a file: a format shows at its beginning, and a glTF's text is seldom longer.
constexpr std::size_t head_of_model_bytes = std::size_t{1} << 22;

std::string head_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(head_of_model_bytes, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool has_text(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The texts that stand behind "key": in JSON, in their order. Enough to tell what a glTF file needs, and it
/// takes one that is damaged.
std::vector<std::string> texts_behind(std::string_view json, std::string_view key) {
  std::vector<std::string> texts;
  const std::string quoted = '"' + std::string(key) + '"';
  for (std::size_t at = json.find(quoted); at != std::string_view::npos; at = json.find(quoted, at + 1)) {
    const std::size_t colon = json.find_first_not_of(" \t\r\n", at + quoted.size());
    if (colon == std::string_view::npos || json[colon] != ':') continue;
    const std::size_t begin = json.find_first_not_of(" \t\r\n", colon + 1);
    if (begin != std::string_view::npos && json[begin] == '"') {
      texts.emplace_back(json.substr(begin + 1, json.find('"', begin + 1) - begin - 1));
    }
  }
  return texts;
}

std::string why_not_gltf(const std::filesystem::path& path, const std::string& head) {
  const bool is_binary = head.starts_with("glTF") && head.size() > 4;
  const std::vector<std::string> versions = texts_behind(head, "version");
  const bool is_first =
      is_binary ? head[4] == 1
                : std::ranges::any_of(versions, [](const std::string& version) { return version.starts_with("1."); });
  if (is_first) return "it is glTF 1.0, which is not read; save it as glTF 2.0";
  if (has_text(head, "KHR_draco_mesh_compression")) {
    return "its meshes are compressed with Draco in a way that is not read; save it without compression";
  }
  for (const std::string& uri : texts_behind(head, "uri")) {
    std::error_code error;
    if (uri.ends_with(".bin") && !std::filesystem::exists(path.parent_path() / uri, error)) {
      return fmt::format("it needs the file '{}' beside it, which is not there", uri);
    }
  }
  return "";
}

}  // namespace

std::string why_unreadable(const std::filesystem::path& path) {
  const std::string head = head_of(path);
  const std::string extension = lower_case(path.extension().string());
  constexpr std::array usd = {".usd", ".usda", ".usdc", ".usdz"};
  if (std::ranges::find(usd, extension) != usd.end() || head.starts_with("#usda") || head.starts_with("PXR-USDC")) {
    return "it is USD, which is not read; save it as glTF, FBX or OBJ";
  }
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) {
    return "it is text in UTF-16; save it as UTF-8";
  }
  return extension == ".gltf" || extension == ".glb" ? why_not_gltf(path, head) : "";
}

}  // namespace taut::app

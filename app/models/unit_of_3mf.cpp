#include "app/models/unit_of_3mf.hpp"

#include <minizip/unzip.h>

#include <array>
#include <memory>
#include <string>

namespace taut::app {
namespace {

// A start tag is within the first of them, even behind a long comment.
constexpr std::size_t head_bytes = std::size_t{1} << 16;

struct CloseArchive {
  void operator()(void* archive) const { ::unzClose(archive); }
};

/// Goes to the part that holds the model; files name it so though they need not.
bool find_model_part(unzFile archive) {
  constexpr int any_case = 2;
  if (::unzLocateFile(archive, "3D/3dmodel.model", any_case) == UNZ_OK) {
    return true;
  }
  std::array<char, 1024> name{};
  for (int result = ::unzGoToFirstFile(archive); result == UNZ_OK; result = ::unzGoToNextFile(archive)) {
    if (::unzGetCurrentFileInfo64(archive, nullptr, name.data(), name.size() - 1, nullptr, 0, nullptr, 0) ==
            UNZ_OK &&
        std::string_view(name.data()).ends_with(".model")) {
      return true;
    }
  }
  return false;
}

/// The tag at the beginning, whose quoted values may hold anything; empty where it has no end.
std::string_view up_to_its_end(std::string_view xml) {
  char quote = '\0';
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (quote != '\0') {
      quote = xml[i] == quote ? '\0' : quote;
    } else if (xml[i] == '"' || xml[i] == '\'') {
      quote = xml[i];
    } else if (xml[i] == '>') {
      return xml.substr(0, i + 1);
    }
  }
  return {};
}

/// The start tag of the root element after what may come before it; empty where there is none.
std::string_view model_tag(std::string_view xml) {
  while (true) {
    const std::size_t open = xml.find('<');
    if (open == std::string_view::npos) {
      return {};
    }
    xml.remove_prefix(open);
    const bool is_comment = xml.starts_with("<!--");
    if (!is_comment && !xml.starts_with("<?") && !xml.starts_with("<!")) {
      return up_to_its_end(xml);
    }
    const std::string_view ending = is_comment ? "-->" : ">";
    const std::size_t end = xml.find(ending);
    if (end == std::string_view::npos) {
      return {};
    }
    xml.remove_prefix(end + ending.size());
  }
}

/// The value of `name` in a tag; nothing where it has no such attribute.
std::optional<std::string_view> attribute(std::string_view tag, std::string_view name) {
  constexpr std::string_view blanks = " \t\r\n";
  std::size_t at = tag.find_first_of(blanks);
  while (at != std::string_view::npos) {
    const std::size_t begin = tag.find_first_not_of(blanks, at);
    const std::size_t equals = tag.find('=', at);
    const std::size_t open = tag.find_first_of("\"'", equals);
    const std::size_t close = open < tag.size() ? tag.find(tag[open], open + 1) : open;
    if (equals >= tag.size() || close >= tag.size()) {
      break;
    }
    const std::string_view found = tag.substr(begin, tag.find_first_of(" \t\r\n=", begin) - begin);
    if (found == name) {
      return tag.substr(open + 1, close - open - 1);
    }
    at = close + 1;
  }
  return std::nullopt;
}

struct NamedUnit {
  std::string_view name;
  double metres;
};
constexpr std::array named_units = {NamedUnit{"micron", 1e-6},     NamedUnit{"millimeter", 0.001},
                                    NamedUnit{"centimeter", 0.01}, NamedUnit{"inch", 0.0254},
                                    NamedUnit{"foot", 0.3048},     NamedUnit{"meter", 1.0}};

}  // namespace

std::optional<double> unit_of_model_part(std::string_view xml) {
  const std::string_view tag = model_tag(xml);
  const std::string_view element = tag.substr(0, tag.find_first_of(" \t\r\n>"));
  if (element != "<model" && !element.ends_with(":model")) {
    return std::nullopt;
  }
  const std::string_view unit = attribute(tag, "unit").value_or("millimeter");
  for (const NamedUnit& named : named_units) {
    if (named.name == unit) {
      return named.metres;
    }
  }
  return std::nullopt;
}

std::optional<double> unit_of_3mf(const std::filesystem::path& path) {
  const std::unique_ptr<void, CloseArchive> archive(::unzOpen64(path.c_str()));
  if (!archive || !find_model_part(archive.get()) || ::unzOpenCurrentFile(archive.get()) != UNZ_OK) {
    return std::nullopt;
  }
  std::string head(head_bytes, '\0');
  std::size_t count = 0;
  while (count < head.size()) {
    const int read =
        ::unzReadCurrentFile(archive.get(), head.data() + count, static_cast<unsigned>(head.size() - count));
    if (read <= 0) {
      break;
    }
    count += static_cast<std::size_t>(read);
  }
  return unit_of_model_part(std::string_view(head).substr(0, count));
}

}  // namespace taut::app

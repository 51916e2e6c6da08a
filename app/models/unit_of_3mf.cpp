#include "app/models/unit_of_3mf.hpp"

#include <minizip/unzip.h>

#include <array>
#include <memory>
#include <pugixml.hpp>
#include <string>

namespace taut::app {
namespace {

// Bytes that are searched for the start tag. It lies within them even behind a long comment.
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

struct NamedUnit {
  std::string_view name;
  double metres;
};
constexpr std::array named_units = {NamedUnit{"micron", 1e-6},     NamedUnit{"millimeter", 0.001},
                                    NamedUnit{"centimeter", 0.01}, NamedUnit{"inch", 0.0254},
                                    NamedUnit{"foot", 0.3048},     NamedUnit{"meter", 1.0}};

}  // namespace

std::optional<double> unit_of_model_part(std::string_view xml) {
  pugi::xml_document document;
  // A file that is cut off at its end is an error, and read up to there all the same.
  document.load_buffer(xml.data(), xml.size());
  const pugi::xml_node root = document.document_element();
  const std::string_view element = root.name();
  if (element != "model" && !element.ends_with(":model")) {
    return std::nullopt;
  }
  const std::string_view unit = root.attribute("unit").as_string("millimeter");
  for (const NamedUnit& named : named_units) {
    if (named.name == unit) {
      return named.metres;
    }
  }
  return std::nullopt;
}

std::string head_of_3mf(const std::filesystem::path& path) {
  const std::unique_ptr<void, CloseArchive> archive(::unzOpen64(path.c_str()));
  if (!archive || !find_model_part(archive.get()) || ::unzOpenCurrentFile(archive.get()) != UNZ_OK) {
    return "";
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
  return head.substr(0, count);
}

std::optional<double> unit_of_3mf(const std::filesystem::path& path) {
  return unit_of_model_part(head_of_3mf(path));
}

}  // namespace taut::app

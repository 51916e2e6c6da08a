#include "app/models/reading/import_process.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

// A page has no processes and no assimp. Its model files contain the answers that taut-import gave when the page was
// built.
namespace taut::app {

ModelArrays read_model_in_process(const std::filesystem::path& path, const ImportLimits& /*limits*/,
                                  ReadParts /*parts*/) {
  const std::string bytes = read_text_file(path);
  std::uint64_t length = 0;
  constexpr std::size_t header = 1 + sizeof(length);
  if (bytes.size() >= header) std::memcpy(&length, bytes.data() + 1, sizeof(length));
  if (bytes.size() < header || length != bytes.size() - header ||
      bytes.front() != static_cast<char>(ImportAnswer::arrays)) {
    throw InputError("it is not what taut-import answers; in a page, give a garment as positions and faces");
  }
  return decode(bytes.substr(header));
}

TextureImage read_image(const std::filesystem::path& path) {
  throw InputError("found the image '{}', but a page reads no images", path.string());
}

}  // namespace taut::app

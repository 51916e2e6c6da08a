#include "app/scene/scene_format.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {

void require_one_garment(const toml::table& file, const Source& source) {
  const toml::node* garment = file.get("garment");
  const bool has_file = static_cast<bool>(file["garment"]["file"]);
  const bool has_grid = static_cast<bool>(file["garment"]["grid"]);
  if (has_file == has_grid) {
    fail(source, garment != nullptr ? line_of(*garment) : 0,
         std::string(has_file ? "both garment.file and [garment.grid] are" : "no garment is") +
             " given; expected one of [garment] file = \"...\" and [garment.grid]");
  }
}

// Here and not where it is read, which does not know who names it.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source,
                   int line) {
  try {
    require_file(named);
  } catch (const InputError& error) {
    fail(source, line, "garment." + key + ": " + error.what());
  }
}

void require_garment_of(const toml::table& file, const Source& source, const GarmentSource& named,
                        const GarmentSource& used) {
  for (const auto& [name, member] : garment_files) {
    const toml::node* key = file["garment"][name].node();
    if (key != nullptr && used.*member == named.*member) {
      require_named(name, named.*member, source, line_of(*key));
    }
  }
}

}  // namespace taut::app

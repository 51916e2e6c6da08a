#include "app/scene/scene_file.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {
namespace {

const Value* find(const ValueTable& table, const std::string& key) {
  for (const auto& [name, value] : table) {
    if (name == key) {
      return &value;
    }
  }
  return nullptr;
}

}  // namespace

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + text + ": expected KEY=VALUE, such as --set solver.substeps=40");
  }
  return {text.substr(0, equals), text.substr(equals + 1), "--set " + text};
}

void require_one_garment(const ValueTable& file, const Source& source) {
  const Value* garment = find(file, "garment");
  const ValueTable none;
  const ValueTable& keys = garment != nullptr && garment->table() != nullptr ? *garment->table() : none;
  const bool has_file = find(keys, "file") != nullptr;
  const bool has_grid = find(keys, "grid") != nullptr;
  if (has_file == has_grid) {
    fail(source, garment != nullptr ? garment->line : 0,
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

void require_garment_of(const ValueTable& file, const Source& source, const GarmentSource& named,
                        const GarmentSource& used) {
  const Value* section = find(file, "garment");
  for (const auto& [name, member] : garment_files) {
    const Value* key = section != nullptr ? find(*section->table(), name) : nullptr;
    if (key != nullptr && used.*member == named.*member) {
      require_named(name, named.*member, source, key->line);
    }
  }
}

void insert(ValueTable& table, const std::string& name, const Value& value) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    table.push_back({name, value});
    return;
  }
  const std::string section = name.substr(0, dot);
  if (find(table, section) == nullptr) {
    table.push_back({section, Value{ValueTable{}}});
  }
  for (auto& [key, inner] : table) {
    if (key == section) {
      insert(std::get<ValueTable>(inner.data), name.substr(dot + 1), value);
    }
  }
}

}  // namespace taut::app

#include "app/bodies/joint_names.hpp"

#include <cctype>

namespace taut::app {
namespace {

/// Names of parts that have no sides.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> middle_parts = {{
    {"hip", "hips"},          {"hips", "hips"},     {"pelvis", "hips"},     {"spine", "spine"},   {"spine0", "spine"},
    {"spine01", "spine"},     {"abdomen", "spine"}, {"torso", "spine"},     {"waist", "spine"},   {"spine1", "spine1"},
    {"spine02", "spine1"},    {"chest", "spine1"},  {"abdomen2", "spine1"}, {"spine2", "spine2"}, {"spine03", "spine2"},
    {"upperchest", "spine2"}, {"neck", "neck"},     {"neck01", "neck"},     {"neck1", "neck"},    {"head", "head"},
}};

/// Names of parts that there are on both sides.
constexpr std::array<std::pair<std::string_view, std::string_view>, 34> side_parts = {{
    {"shoulder", "shoulder"}, {"collar", "shoulder"}, {"clavicle", "shoulder"}, {"collarbone", "shoulder"},
    {"arm", "arm"},           {"uparm", "arm"},       {"upperarm", "arm"},      {"shldr", "arm"},
    {"forearm", "forearm"},   {"lowarm", "forearm"},  {"lowerarm", "forearm"},  {"elbow", "forearm"},
    {"hand", "hand"},         {"wrist", "hand"},      {"upleg", "upleg"},       {"thigh", "upleg"},
    {"upperleg", "upleg"},    {"hip", "upleg"},       {"leg", "leg"},           {"shin", "leg"},
    {"calf", "leg"},          {"lowleg", "leg"},      {"lowerleg", "leg"},      {"knee", "leg"},
    {"foot", "foot"},         {"ankle", "foot"},      {"toebase", "toebase"},   {"toe", "toebase"},
    {"toes", "toebase"},      {"ball", "toebase"},    {"toe0", "toebase"},      {"toe1", "toebase"},
    {"butt", "butt"},         {"buttock", "butt"},
}};

constexpr std::array<std::string_view, 10> main_parts = {"hips", "spine", "spine1", "arm",  "forearm",
                                                         "hand", "upleg", "leg",    "foot", "head"};

/// Blender puts the name of the armature before those of joints in Collada, "Armature" if nobody gave
/// another.
constexpr std::array<std::string_view, 5> prefixes = {"armature", "mixamorig", "bip", "def", "ccbase"};

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "mixamorig:LeftUpLeg" as "left", "up", "leg"; "RShin" as "r", "shin"; "thigh.L" as "thigh", "l".
std::vector<std::string> words_of(std::string_view name) {
  const std::size_t space = name.find_last_of(":|");
  name.remove_prefix(space == std::string_view::npos ? 0 : space + 1);
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    const bool starts =
        is_upper(c) && i > 0 &&
        (is_lower(name[i - 1]) || is_digit(name[i - 1]) || (i + 1 < name.size() && is_lower(name[i + 1])));
    if ((!is_word || starts) && !words.back().empty()) words.emplace_back();
    if (is_word) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  std::erase(words, "");
  return words;
}

/// A joint's name taken apart.
struct SidedName {
  std::string side;  ///< "left ", "right " or nothing
  std::string rest;
};

bool take_prefix(std::string& text, std::string_view prefix) {
  const bool has = text.starts_with(prefix);
  text.erase(0, has ? prefix.size() : 0);
  return has;
}

SidedName taken_apart(std::string_view name) {
  SidedName joint;
  for (const std::string& word : words_of(name)) {
    const bool is_left = word == "left" || word == "l";
    if (joint.side.empty() && (is_left || word == "right" || word == "r")) {
      joint.side = is_left ? "left " : "right ";
    } else {
      joint.rest += word;
    }
  }
  for (const std::string_view prefix : prefixes) {
    const std::string whole = joint.rest;
    if (take_prefix(joint.rest, prefix)) joint.rest.erase(0, joint.rest.find_first_not_of("0123456789"));
    joint.rest = joint.rest.empty() ? whole : joint.rest;
  }
  if (joint.side.empty() && take_prefix(joint.rest, "left")) {
    joint.side = "left ";
  } else if (joint.side.empty() && take_prefix(joint.rest, "right")) {
    joint.side = "right ";
  }
  return joint;
}

template <class Table> std::string_view look_up(const Table& table, const std::string& name) {
  const auto found = std::ranges::find_if(table, [&](const auto& row) { return row.first == name; });
  return found == table.end() ? std::string_view(name) : found->second;
}

}  // namespace

std::vector<std::string> parts_of_joints(std::span<const std::string> names) {
  std::vector<SidedName> joints;
  for (const std::string& name : names) joints.push_back(taken_apart(name));
  const bool has_elbows = std::ranges::any_of(joints, [](const SidedName& joint) { return joint.rest == "elbow"; });
  std::vector<std::string> parts;
  for (const SidedName& joint : joints) {
    const bool is_arm = has_elbows && joint.rest == "shoulder";
    const std::string_view part = joint.side.empty() ? look_up(middle_parts, joint.rest)
                                  : is_arm           ? "arm"
                                                     : look_up(side_parts, joint.rest);
    parts.push_back(joint.side + std::string(part));
  }
  return parts;
}

bool is_main_part(const std::string& part) {
  const std::string name = part.substr(part.find(' ') + 1);
  return std::ranges::find(main_parts, name) != main_parts.end();
}

}  // namespace taut::app

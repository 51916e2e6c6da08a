#include "app/scene/scene_bodies.hpp"

#include <algorithm>
#include <array>

#include "app/scene/motion_keys.hpp"
#include "app/scene/scene_format.hpp"
#include "app/scene/scene_lists.hpp"

// `access` of a key of a body that has the shape.
#define MEMBER_OF(Shape, member)                      \
  [](auto& b) -> auto& {                              \
    return std::get<sim::Shape>(b.body.shape).member; \
  }

namespace taut::app {
namespace {

constexpr Range friction = {.lowest = 0.0, .highest = 10.0};

/// The shapes as an entry has them before it is read, and their names in files.
const std::array<std::pair<const char*, sim::Shape>, 4> shapes = {{{"plane", sim::Plane{}},
                                                                   {"sphere", sim::Sphere{}},
                                                                   {"capsule", sim::Capsule{}},
                                                                   {"mesh", sim::BodyMesh{}}}};
constexpr const char* shape_names = "\"plane\" or \"sphere\" or \"capsule\" or \"mesh\"";

const char* name_of(const sim::Shape& shape) {
  return shapes[shape.index()].first;
}

struct BodyInScene {
  sim::Body body;
  BodySource source;
};

// Of a body 0 is a friction as good as any other.
Key<BodyInScene> friction_key() {
  auto read = [](const toml::node& value, const Source&, BodyInScene& entry) {
    entry.body.friction = finite_number(value);
    return entry.body.friction && friction.contains(*entry.body.friction);
  };
  auto write = [](const BodyInScene& entry) {
    return entry.body.friction ? Json(*entry.body.friction) : Json();
  };
  return {"friction", "",   describe("a number", friction), "Coulomb's coefficient; not set: cloth.friction",
          read,       write};
}

Key<BodyInScene> file_key(std::string name, std::filesystem::path BodySource::*member, std::string meaning) {
  auto read = [member](const toml::node& value, const Source& source, BodyInScene& entry) {
    const auto text = text_in(value);
    if (text && !text->empty()) {
      entry.source.*member = beside(source, *text);
    }
    return text && !text->empty();
  };
  auto write = [member](const BodyInScene& entry) {
    const std::filesystem::path& file = entry.source.*member;
    return file.empty() ? Json() : Json(std::filesystem::absolute(file).lexically_normal().string());
  };
  return {std::move(name), "", "a file name", std::move(meaning), read, write};
}

// The name of `motion` when it was PC2 alone.
Key<BodyInScene> former_frames_key() {
  Key<BodyInScene> key = file_key("frames", &BodySource::motion, "another name of motion");
  key.write = [](const BodyInScene&) { return Json(); };
  return key;
}

Key<BodyInScene> clip_key() {
  auto read = [](const toml::node& value, const Source&, BodyInScene& entry) {
    return store(text_in(value), entry.source.clip);
  };
  auto write = [](const BodyInScene& entry) {
    return entry.source.clip.empty() ? Json() : Json(entry.source.clip);
  };
  return {"clip",
          "",
          "a name",
          "which animation of the model is played; not set: the first; \"all\": all at once; \"none\": none",
          read,
          write};
}

Key<BodyInScene> dress_key() {
  Key<BodyInScene> key = whole_key<BodyInScene>(
      "dress", {.lowest = 0.0, .highest = 10000.0}, MEMBER(source.dress),
      "so many frames are simulated before frame 0, without gravity and wind, in "
      "which the body grows from its bones to its shape, into what it wears; a "
      "garment that lies elsewhere is moved to it first; it needs joints, or arms off its trunk",
      "frames");
  key.write = [](const BodyInScene& entry) {
    return entry.source.dress == 0 ? Json() : Json(entry.source.dress);
  };
  return key;
}

std::vector<Key<BodyInScene>> common_keys() {
  using B = BodyInScene;
  std::vector<Key<B>> keys = {
      {"shape", "", shape_names, "", [](const toml::node&, const Source&, B&) { return true; },
       [](const B& entry) { return Json(name_of(entry.body.shape)); }},
      text_key<B>("name", MEMBER(body.name), "for messages"),
      friction_key()};
  add_motion(keys, MEMBER(body.motion));
  return keys;
}

std::vector<Key<BodyInScene>> shape_keys(const sim::Shape& shape) {
  using B = BodyInScene;
  if (std::holds_alternative<sim::Plane>(shape)) {
    return {vector_key<B>("point", "m", MEMBER_OF(Plane, point_m), "any point of it"),
            vector_key<B>("normal", "", MEMBER_OF(Plane, normal), "points to the cloth's side, of any length",
                          {.may_be_zero = false})};
  }
  if (std::holds_alternative<sim::Sphere>(shape)) {
    return {vector_key<B>("centre", "m", MEMBER_OF(Sphere, centre_m), "of the ball"),
            number_key<B>("radius", "m", positive, MEMBER_OF(Sphere, radius_m), "of the ball")};
  }
  if (std::holds_alternative<sim::Capsule>(shape)) {
    return {vector_key<B>("start", "m", MEMBER_OF(Capsule, start_m), "one end"),
            vector_key<B>("end", "m", MEMBER_OF(Capsule, end_m), "the other end"),
            number_key<B>("start_radius", "m", positive, MEMBER_OF(Capsule, start_radius_m), "at the start"),
            number_key<B>("end_radius", "m", positive, MEMBER_OF(Capsule, end_radius_m), "at the end")};
  }
  return {file_key("file", &BodySource::file, "a closed 3D model, relative to the scene file"),
          number_key<B>("scale", "m", not_negative, MEMBER(source.scale),
                        "the model's unit of length; 0: what the file says, or else metres"),
          up_key<B>("up", MEMBER(source.up),
                    "the model's direction that is up; auto: what the file says, or else y"),
          file_key("motion", &BodySource::motion,
                   "where its vertices or joints are over time: a PC2, MDD or BVH file, or OBJ files, as a "
                   "folder or a pattern such as body-%04d.obj"),
          former_frames_key(),
          clip_key(),
          number_key<B>("frame_rate", "Hz", {.lowest = 0.0, .highest = 1e5}, MEMBER(source.frame_rate_hz),
                        "of the motion, and how often a clip is looked at; in between vertices go straight; "
                        "0: what the file says, or else 60"),
          number_key<B>("start", "s", not_negative, MEMBER(source.start_s),
                        "the time of the motion with which the run begins, rounded to a frame"),
          written_if(switch_key<B>("loop", MEMBER(source.loop),
                                   "the motion repeats after its last frame: from the earliest frame that is "
                                   "the same, or else its first; false: it stays in its last"),
                     [](const B& entry) { return entry.source.loop; }),
          dress_key()};
}

std::vector<Key<BodyInScene>> body_keys(const sim::Shape& shape) {
  std::vector<Key<BodyInScene>> keys = common_keys();
  for (Key<BodyInScene>& key : shape_keys(shape)) {
    keys.push_back(std::move(key));
  }
  return keys;
}

sim::Shape shape_of(const toml::table& entry, const Source& source) {
  const std::string expected = std::string("expected a shape, ") + shape_names;
  const toml::node* shape = entry.get("shape");
  if (shape == nullptr) {
    fail(source, line_of(entry), "an entry of bodies has no shape; " + expected);
  }
  for (const auto& [name, found] : shapes) {
    if (text_in(*shape) == name) {
      return found;
    }
  }
  fail(source, line_of(*shape), "bodies.shape: found " + to_text(*shape) + ", " + expected);
}

BodyInScene read_body(const toml::table& table, const Source& source) {
  BodyInScene entry{.body = {.shape = shape_of(table, source)}, .source = {}};
  const auto keys = body_keys(entry.body.shape);
  KeyReader(keys, source, entry).read(table);
  check_motion(source, line_of(table), entry.body.motion);
  if (auto* plane = std::get_if<sim::Plane>(&entry.body.shape)) {
    normalise(plane->normal);
  }
  if (std::holds_alternative<sim::BodyMesh>(entry.body.shape) && entry.source.file.empty()) {
    fail(source, line_of(table),
         "a body of shape \"mesh\" has no file; expected file = \"...\", a closed 3D model");
  }
  return entry;
}

bool read_bodies(const toml::node& value, const Source& source, Scene& scene) {
  if (!is_list_of_tables(value)) {
    return false;
  }
  scene.surroundings.bodies.clear();
  scene.body_sources.clear();
  for (const toml::node& item : *value.as_array()) {
    BodyInScene entry = read_body(*item.as_table(), source);
    scene.surroundings.bodies.push_back(std::move(entry.body));
    scene.body_sources.push_back(std::move(entry.source));
  }
  return true;
}

Json write_bodies(const Scene& scene) {
  Json list = Json::array();
  for (std::size_t k = 0; k < scene.surroundings.bodies.size(); ++k) {
    const BodyInScene entry{scene.surroundings.bodies[k],
                            k < scene.body_sources.size() ? scene.body_sources[k] : BodySource{}};
    list.push_back(write_entry(body_keys(entry.body.shape), entry));
  }
  return list;
}

std::vector<Key<MovingPinsInScene>> moving_pins_keys() {
  using P = MovingPinsInScene;
  std::vector<Key<P>> keys = {
      {"at", "", "a list as of pins.at", "vertices that are held and led",
       [](const toml::node& value, const Source&, P& entry) { return store(pins_in(value), entry.at); },
       [](const P& entry) { return entry.at.empty() ? Json() : json_of(entry.at); }}};
  add_motion(keys, MEMBER(motion));
  return keys;
}

bool read_moving_pins(const toml::node& value, const Source& source, Scene& scene) {
  if (!is_list_of_tables(value)) {
    return false;
  }
  const auto keys = moving_pins_keys();
  scene.moving_pins.clear();
  for (const toml::node& item : *value.as_array()) {
    const toml::table& table = *item.as_table();
    MovingPinsInScene& entry = scene.moving_pins.emplace_back();
    KeyReader(keys, source, entry).read(table);
    check_motion(source, line_of(table), entry.motion);
    if (entry.at.empty()) {
      fail(source, line_of(table),
           "an entry of pins.moving has no vertices; expected at = [...], a list as of pins.at");
    }
  }
  return true;
}

Json write_moving_pins(const Scene& scene) {
  Json list = Json::array();
  for (const MovingPinsInScene& entry : scene.moving_pins) {
    list.push_back(write_entry(moving_pins_keys(), entry));
  }
  return list;
}

}  // namespace

int Scene::dressing_frames() const {
  int most = 0;
  for (const BodySource& source : body_sources) {
    most = std::max(most, source.dress);
  }
  return most;
}

bool set_body_key(const std::string& name, const toml::node& value, const Source& source, Scene& scene) {
  constexpr std::string_view section = "body.";
  if (!name.starts_with(section)) {
    return false;
  }
  std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  scene.body_sources.resize(bodies.size());
  if (name == "body.file") {
    bodies.push_back({.shape = sim::BodyMesh{}});
    scene.body_sources.emplace_back();
  }
  const auto is_model = [](const sim::Body& body) {
    return std::holds_alternative<sim::BodyMesh>(body.shape);
  };
  const auto last = std::find_if(bodies.rbegin(), bodies.rend(), is_model);
  if (last == bodies.rend()) {
    fail(source, 0, name + ": the scene has no body that is a model; expected one, as --body FILE adds");
  }
  const auto k = static_cast<std::size_t>(bodies.rend() - last - 1);
  BodyInScene entry{bodies[k], scene.body_sources[k]};
  const std::vector<Key<BodyInScene>> keys = body_keys(entry.body.shape);
  KeyReader(keys, source, entry).read_value(name.substr(section.size()), value);
  if (name == "body.file") {
    entry.body.name = entry.source.file.stem().string();
  }
  bodies[k] = std::move(entry.body);
  scene.body_sources[k] = std::move(entry.source);
  return true;
}

Key<Scene> bodies_key() {
  return {"bodies", "", "a list of tables [[bodies]]", "what cloth cannot enter", read_bodies, write_bodies};
}

Key<Scene> moving_pins_key() {
  return {"pins.moving",
          "",
          "a list of tables [[pins.moving]]",
          "groups of vertices that are held, each led by a motion of its own, besides those of pins.at",
          read_moving_pins,
          write_moving_pins};
}

std::string moving_entries_help() {
  std::string text = "\nEach [[pins.moving]]:\n";
  for (const auto& key : moving_pins_keys()) {
    text += describe_key(key, MovingPinsInScene{});
  }
  text += "\nEach [[bodies]]:\n";
  for (const auto& key : common_keys()) {
    text += describe_key(key, BodyInScene{});
  }
  for (const auto& [name, shape] : shapes) {
    text += std::string("\nEach [[bodies]] with shape = \"") + name + "\" also:\n";
    for (const auto& key : shape_keys(shape)) {
      text += describe_key(key, BodyInScene{.body = {.shape = shape}, .source = {}});
    }
  }
  return text +
         "\nOn the command line, --set body.file=FILE adds a body with shape = \"mesh\", and --set "
         "body.KEY=VALUE "
         "sets\nany key of the last one; --body, --body-motion and others stand for them.\n";
}

}  // namespace taut::app

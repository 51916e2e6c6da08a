#include "app/scene/scene_format.hpp"

// Accessor of a member of a body's shape, for a key.
#define MEMBER_OF(Shape, member) \
  [](auto& b) -> auto& { return std::get<sim::Shape>(b.body.shape).member; }

namespace taut::app {
namespace {

constexpr Range body_length = {.lowest = 0.0, .highest = 1e4, .above_lowest = true};

constexpr Range friction = {.lowest = 0.0, .highest = 10.0};

std::optional<NearestTo> parse_nearest(const toml::node& value) {
  const toml::table* table = value.as_table();
  const toml::node* nearest_node = table != nullptr && table->size() == 1 ? table->get("nearest") : nullptr;
  const auto point = nearest_node != nullptr ? numbers_in<3>(*nearest_node) : std::nullopt;
  return point ? std::optional(NearestTo{{(*point)[0], (*point)[1], (*point)[2]}}) : std::nullopt;
}

std::optional<PinSelector> parse_pin(const toml::node& value) {
  if (const auto text = text_in(value)) return *text;
  if (const auto index = whole_number(value); index && *index >= 0 && *index < 0xFFFFFFFFLL) {
    return static_cast<sim::Index>(*index);
  }
  if (const auto nearest = parse_nearest(value)) return *nearest;
  return std::nullopt;
}

struct PinWriter {
  Json operator()(const std::string& name) const { return name; }
  Json operator()(sim::Index vertex) const { return vertex; }
  Json operator()(const NearestTo& nearest) const {
    const sim::Vec3& p = nearest.point_m;
    return Json::object({{"nearest", {p.x, p.y, p.z}}});
  }
};

std::optional<std::vector<PinSelector>> pins_in(const toml::node& value) {
  if (const auto text = text_in(value)) return std::vector<PinSelector>{*text};
  if (!value.is_array()) return std::nullopt;
  std::vector<PinSelector> pins;
  for (const toml::node& item : *value.as_array()) {
    const auto pin = parse_pin(item);
    if (!pin) return std::nullopt;
    pins.push_back(*pin);
  }
  return pins;
}

Json to_json_value(const std::vector<PinSelector>& pins) {
  return collect<Json>(pins, [](const PinSelector& pin) { return std::visit(PinWriter{}, pin); });
}

template <class T> Json write_list(const std::vector<Key<T>>& keys, const std::vector<T>& entries) {
  return collect<Json>(entries, [&](const T& entry) { return write_entry(keys, entry); });
}

/// Returns the keys of an entry of [[forces]].
std::vector<Key<sim::PointForce>> force_keys() {
  using F = sim::PointForce;
  return {whole_key<F>("vertex", {0, 4294967294.0}, MEMBER(vertex)), vector_key<F>("force", "N", MEMBER(force_n))};
}

std::optional<std::vector<sim::PathPoint>> path_in(const toml::node& value) {
  std::vector<sim::PathPoint> path;
  for (const toml::node& item : value.is_array() ? *value.as_array() : toml::array{}) {
    const auto row = numbers_in<4>(item);
    const auto is_far = [](double number) { return std::abs(number) > max_coordinate; };
    if (!row || std::ranges::any_of(*row, is_far)) return std::nullopt;
    if (!path.empty() && !((*row)[0] > path.back().time_s)) return std::nullopt;
    path.push_back({(*row)[0], {(*row)[1], (*row)[2], (*row)[3]}});
  }
  return path.empty() ? std::nullopt : std::optional(path);
}

/// Normalises a direction. A direction of length 1 keeps its bits, so that a written scene reads back as the same.
void normalise(sim::Vec3& direction) {
  constexpr double rounded_off = 4e-15;
  constexpr double min_squared = 1e-200;  // smaller squares lose their precision
  if (glm::dot(direction, direction) < min_squared) direction *= 1.0 / min_squared;
  if (std::abs(glm::dot(direction, direction) - 1.0) > rounded_off) direction = glm::normalize(direction);
}

template <class Part> void require_order(const char* part_name, const Part& part, const Source& source, int line) {
  if (!(part.until_s > part.from_s)) {
    fail(source, line,
         fmt::format("{0}.until: found {1:g} s, expected a time after {0}.from, {2:g} s", part_name, part.until_s,
                     part.from_s));
  }
}

/// Completes a motion after all its keys were read. Throws by `fail` if it ends before it begins.
void check_motion(const Source& source, int line, sim::RigidMotion& motion) {
  require_order("shift", motion.shift, source, line);
  require_order("spin", motion.spin, source, line);
  normalise(motion.spin.axis);
}

/// Makes a key for a path.
template <class T, class Access> Key<T> path_key(std::string name, std::string unit, Access access) {
  auto write = [](const std::vector<sim::PathPoint>& path) {
    Json list;
    for (const sim::PathPoint& point : path) {
      list.push_back({point.time_s, point.offset.x, point.offset.y, point.offset.z});
    }
    return list;
  };
  return member_key<T>(
      std::move(name), "s, " + unit, "a list of [time, x, y, z], the times rising", access,
      [](const toml::node& value, auto& path) { return store(path_in(value), path); }, write);
}

/// Adds the keys of a motion. `motion` returns the motion of an entry, const or not.
template <class T, class Access> void add_motion(std::vector<Key<T>>& keys, Access motion) {
#define MOTION(member) \
  [=](auto& entry) -> auto& { return motion(entry).member; }
  constexpr Range time = {.lowest = 0.0, .highest = 1e6};
  const auto shifts = [=](const T& e) { return motion(e).shift != sim::Shift{}; };
  const auto spins = [=](const T& e) { return motion(e).spin != sim::Spin{}; };
  const auto ends_shift = [=](const T& e) { return std::isfinite(motion(e).shift.until_s); };
  const auto ends_spin = [=](const T& e) { return std::isfinite(motion(e).spin.until_s); };
  keys.insert(
      keys.end(),
      {written_if(vector_key<T>("shift.velocity", "m/s", MOTION(shift.velocity_m_per_s)), shifts),
       written_if(number_key<T>("shift.from", "s", time, MOTION(shift.from_s)), shifts),
       written_if(number_key<T>("shift.until", "s", time, MOTION(shift.until_s)), ends_shift),
       written_if(vector_key<T>("spin.about", "m", MOTION(spin.about_m)), spins),
       written_if(direction_key<T>("spin.axis", MOTION(spin.axis)), spins),
       written_if(number_key<T>("spin.turns_per_second", "", {-1000.0, 1000.0}, MOTION(spin.turns_per_s)), spins),
       written_if(number_key<T>("spin.from", "s", time, MOTION(spin.from_s)), spins),
       written_if(number_key<T>("spin.until", "s", time, MOTION(spin.until_s)), ends_spin),
       path_key<T>("path", "m", MOTION(path))});
#undef MOTION
}

std::vector<Key<MovingPinsInScene>> moving_pins_keys() {
  using P = MovingPinsInScene;
  std::vector<Key<P>> keys = {member_key<P>(
      "at", "", "a list as of pins.at", MEMBER(at),
      [](const toml::node& value, auto& at) { return store(pins_in(value), at); },
      [](const auto& at) { return at.empty() ? Json() : to_json_value(at); })};
  add_motion(keys, MEMBER(motion));
  return keys;
}

/// Shapes with their names in files, in the state before an entry is read.
const std::array<std::pair<const char*, sim::Shape>, 4> shapes = {
    {{"plane", sim::Plane{}}, {"sphere", sim::Sphere{}}, {"capsule", sim::Capsule{}}, {"mesh", sim::BodyMesh{}}}};
constexpr const char* shape_names = "\"plane\" or \"sphere\" or \"capsule\" or \"mesh\"";

const char* to_name(const sim::Shape& shape) { return shapes[shape.index()].first; }

/// Makes a key that writes the full path of a file.
Key<BodyInScene> body_file_key(std::string name, std::filesystem::path BodySource::*member) {
  Key<BodyInScene> key = file_key<BodyInScene>(
      std::move(name), [member](auto& entry) -> auto& { return entry.source.*member; });
  key.write = [member](const BodyInScene& entry) {
    const std::filesystem::path& file = entry.source.*member;
    return file.empty() ? Json() : Json(std::filesystem::absolute(file).lexically_normal().string());
  };
  return key;
}

std::vector<Key<BodyInScene>> common_keys() {
  using B = BodyInScene;
  std::vector<Key<B>> keys = {{"shape", "", shape_names, [](const toml::node&, const Source&, B&) { return true; },
                               [](const B& entry) { return Json(to_name(entry.body.shape)); }},
                              text_key<B>("name", MEMBER(body.name)),
                              // The friction of a body may be 0, so 0 does not mean unset.
                              member_key<B>(
                                  "friction", "", describe("a number", friction), MEMBER(body.friction),
                                  [](const toml::node& value, std::optional<double>& member) {
                                    member = finite_number(value);
                                    return member && friction.contains(*member);
                                  },
                                  [](const std::optional<double>& member) { return member ? Json(*member) : Json(); })};
  add_motion(keys, MEMBER(body.motion));
  return keys;
}

std::vector<Key<BodyInScene>> shape_keys(const sim::Shape& shape) {
  using B = BodyInScene;
  if (std::holds_alternative<sim::Plane>(shape)) {
    return {vector_key<B>("point", "m", MEMBER_OF(Plane, point_m)),
            direction_key<B>("normal", MEMBER_OF(Plane, normal))};
  }
  if (std::holds_alternative<sim::Sphere>(shape)) {
    return {vector_key<B>("centre", "m", MEMBER_OF(Sphere, centre_m)),
            number_key<B>("radius", "m", body_length, MEMBER_OF(Sphere, radius_m))};
  }
  if (std::holds_alternative<sim::Capsule>(shape)) {
    return {vector_key<B>("start", "m", MEMBER_OF(Capsule, start_m)),
            vector_key<B>("end", "m", MEMBER_OF(Capsule, end_m)),
            number_key<B>("start_radius", "m", body_length, MEMBER_OF(Capsule, start_radius_m)),
            number_key<B>("end_radius", "m", body_length, MEMBER_OF(Capsule, end_radius_m))};
  }
  return {body_file_key("file", &BodySource::file),
          number_key<B>("scale", "m", not_negative, MEMBER(source.scale)),
          up_key<B>("up", MEMBER(source.up)),
          body_file_key("motion", &BodySource::motion),
          written_if(text_key<B>("clip", MEMBER(source.clip), "a name"),
                     [](const B& entry) { return !entry.source.clip.empty(); }),
          number_key<B>("frame_rate", "Hz", {.lowest = 0.0, .highest = 1e5}, MEMBER(source.frame_rate_hz)),
          number_key<B>("start", "s", not_negative, MEMBER(source.start_s)),
          written_if(switch_key<B>("loop", MEMBER(source.loop)), [](const B& entry) { return entry.source.loop; }),
          written_if(whole_key<B>("dress", {.lowest = 0.0, .highest = 10000.0}, MEMBER(source.dress), "frames"),
                     [](const B& entry) { return entry.source.dress != 0; })};
}

std::vector<Key<BodyInScene>> body_keys(const sim::Shape& shape) {
  std::vector<Key<BodyInScene>> keys = common_keys();
  const std::vector<Key<BodyInScene>> own_keys = shape_keys(shape);
  keys.insert(keys.end(), own_keys.begin(), own_keys.end());
  return keys;
}

sim::Shape parse_shape(const toml::table& entry, const Source& source) {
  const std::string expected = std::string("expected a shape, ") + shape_names;
  const toml::node* shape = entry.get("shape");
  if (shape == nullptr) fail(source, line_number(entry), "an entry of bodies has no shape; " + expected);
  for (const auto& [name, found] : shapes) {
    if (text_in(*shape) == name) return found;
  }
  fail(source, line_number(*shape), "bodies.shape: found " + to_text(*shape) + ", " + expected);
}

BodyInScene read_body(const toml::table& table, const Source& source) {
  BodyInScene entry{.body = {.shape = parse_shape(table, source)}};
  const auto keys = body_keys(entry.body.shape);
  KeyReader(keys, source, entry).read(table);
  check_motion(source, line_number(table), entry.body.motion);
  if (auto* plane = std::get_if<sim::Plane>(&entry.body.shape)) normalise(plane->normal);
  if (std::holds_alternative<sim::BodyMesh>(entry.body.shape) && entry.source.file.empty()) {
    fail(source, line_number(table),
         "a body of shape \"mesh\" has no file; expected file = \"...\", a closed 3D model");
  }
  return entry;
}

template <class T>
std::string entry_help(const std::string& title, const std::string& list, const std::vector<Key<T>>& keys,
                       const T& defaults) {
  std::string text = '\n' + title + ":\n";
  for (const Key<T>& key : keys) text += describe_key(key, defaults, list);
  return text;
}

}  // namespace

int Scene::dressing_frames() const {
  int max_frames = 0;
  for (const BodyInScene& entry : bodies) max_frames = std::max(max_frames, entry.source.dress);
  return max_frames;
}

std::vector<sim::Body> named_bodies(const Scene& scene) { return collect<sim::Body>(scene.bodies, &BodyInScene::body); }

bool set_body_key(const std::string& name, const toml::node& value, const Source& source, Scene& scene) {
  constexpr std::string_view section = "body.";
  if (!name.starts_with(section)) return false;
  if (name == "body.file") scene.bodies.push_back({.body = {.shape = sim::BodyMesh{}}});
  const auto last = std::find_if(scene.bodies.rbegin(), scene.bodies.rend(), [](const BodyInScene& entry) {
    return std::holds_alternative<sim::BodyMesh>(entry.body.shape);
  });
  if (last == scene.bodies.rend()) {
    fail(source, 0, name + ": the scene has no body that is a model; expected one, as --body FILE adds");
  }
  const std::vector<Key<BodyInScene>> keys = body_keys(last->body.shape);
  KeyReader(keys, source, *last).read_value(name.substr(section.size()), value);
  if (name == "body.file") last->body.name = last->source.file.stem().string();
  return true;
}

Key<Scene> pins_key() {
  return member_key<Scene>(
      "pins.at", "",
      "\"none\" or \"hanger\" or a list of landmark names, grid names (\"top-left\", ...), vertex numbers "
      "and { nearest = [x, y, z] }",
      MEMBER(pins),
      [](const toml::node& value, auto& pins) {
        return store(text_in(value) == "none" ? std::vector<PinSelector>{} : pins_in(value), pins);
      },
      [](const auto& pins) { return pins ? to_json_value(*pins) : Json(); });
}

Key<Scene> weld_key() {
  constexpr Range range = {0.0, 0.05};
  auto read = [range](const toml::node& value, std::optional<double>& weld_m) {
    const std::optional<double> number = finite_number(value);
    const bool is_right = (number && range.contains(*number)) || text_in(value) == "auto";
    weld_m = is_right ? number : weld_m;
    return is_right;
  };
  return member_key<Scene>("garment.weld", "m", "\"auto\" or " + describe("a number", range), MEMBER(garment.weld_m),
                           read, [](const std::optional<double>& weld_m) { return weld_m ? Json(*weld_m) : Json(); });
}

Key<Scene> gravity_path_key() {
  return path_key<Scene>("gravity.path", "m/s2", MEMBER(surroundings.forces.gravity_path));
}

Key<Scene> forces_key() {
  auto read = [](const toml::node& value, const Source& source, std::vector<sim::PointForce>& forces) {
    const auto keys = force_keys();
    forces.clear();
    return read_list(value,
                     [&](const toml::table& table) { KeyReader(keys, source, forces.emplace_back()).read(table); });
  };
  return member_key<Scene>("forces", "", "a list of tables [[forces]]", MEMBER(surroundings.forces.artificial_forces),
                           read, [](const auto& forces) { return write_list(force_keys(), forces); });
}

Key<Scene> bodies_key() {
  auto read = [](const toml::node& value, const Source& source, Scene& scene) {
    scene.bodies.clear();
    return read_list(value, [&](const toml::table& table) { scene.bodies.push_back(read_body(table, source)); });
  };
  auto write = [](const Scene& scene) {
    Json list = Json::array();
    for (const BodyInScene& entry : scene.bodies) list.push_back(write_entry(body_keys(entry.body.shape), entry));
    return list;
  };
  return {"bodies", "", "a list of tables [[bodies]]", read, write};
}

Key<Scene> moving_pins_key() {
  auto read = [](const toml::node& value, const Source& source, std::vector<MovingPinsInScene>& groups) {
    const auto keys = moving_pins_keys();
    groups.clear();
    return read_list(value, [&](const toml::table& table) {
      MovingPinsInScene& entry = groups.emplace_back();
      KeyReader(keys, source, entry).read(table);
      check_motion(source, line_number(table), entry.motion);
      if (entry.at.empty()) {
        fail(source, line_number(table),
             "an entry of pins.moving has no vertices; expected at = [...], a list as of pins.at");
      }
    });
  };
  return member_key<Scene>("pins.moving", "", "a list of tables [[pins.moving]]", MEMBER(moving_pins), read,
                           [](const auto& groups) { return write_list(moving_pins_keys(), groups); });
}

std::string list_entries_help() {
  std::string text = entry_help("Each [[forces]]", "forces.", force_keys(), sim::PointForce{}) +
                     entry_help("Each [[pins.moving]]", "pins.moving.", moving_pins_keys(), MovingPinsInScene{}) +
                     entry_help("Each [[bodies]]", "bodies.", common_keys(), BodyInScene{});
  for (const auto& [name, shape] : shapes) {
    text += entry_help(std::string("Each [[bodies]] with shape = \"") + name + "\" also",
                       std::string("bodies.") + name + '.', shape_keys(shape), BodyInScene{.body = {.shape = shape}});
  }
  return text +
         "\nOn the command line, --set body.file=FILE adds a body with shape = \"mesh\", and --set "
         "body.KEY=VALUE sets\nany key of the last one; --body, --body-motion and others stand for them.\n";
}

}  // namespace taut::app

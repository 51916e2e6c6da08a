#include "any_arrays.hpp"

#include <array>
#include <limits>

#include "app/bodies/body_loading.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::test {
namespace {

using namespace app;

class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  bool seldom() { return next() % 64 == 1; }
  /// An index below `limit`; seldom any number.
  std::uint32_t index(std::size_t limit) {
    return seldom() || limit == 0 ? next() * 0x01010101U : static_cast<std::uint32_t>(next() % limit);
  }
  double number() {
    constexpr std::array odd = {0.0,
                                -0.0,
                                1e-310,
                                1e-30,
                                1e9,
                                3e38,
                                1e300,
                                -1e38,
                                0.5,
                                1.0,
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()};
    return seldom() ? odd[next() % odd.size()] : (next() - 128) / 128.0;
  }
  sim::Vec3 point() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  glm::dmat4 transform() {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(point(), 1.0);
    if (next() % 4 == 0) m[static_cast<int>(next() % 4)][static_cast<int>(next() % 4)] = number();
    return m;
  }
  RigKeys keys() {
    RigKeys keys;
    for (std::size_t k = next() % 4; k-- > 0;) {
      keys.times_s.push_back(number());
      keys.values.emplace_back(point(), number());
    }
    if (seldom()) keys.times_s.push_back(0.0);
    return keys;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

void add_box(double at, double size, ModelArrays& model) {
  const auto first = static_cast<sim::Index>(model.positions.size());
  for (int v = 0; v < 8; ++v) {
    model.positions.emplace_back(at + (v & 1 ? size : 0.0), v & 2 ? size : 0.0, v & 4 ? size : 0.0);
  }
  for (const sim::Index corner : {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5}) {
    model.faces.corners.push_back(first + corner);
  }
  model.faces.corner_counts.insert(model.faces.corner_counts.end(), 6, 4);
}

void add_faces(Source& source, ModelArrays& model) {
  for (std::size_t boxes = source.next() % 3; boxes-- > 0;) add_box(source.number(), source.number(), model);
  for (std::size_t v = source.next() % 16; v-- > 0;) model.positions.push_back(source.point());
  for (std::size_t f = source.next() % 16; f-- > 0;) {
    const std::uint32_t count = source.seldom() ? source.next() : 3 + source.next() % 4;
    model.faces.corner_counts.push_back(count);
    for (std::uint32_t k = 0; k < count; ++k) model.faces.corners.push_back(source.index(model.positions.size()));
  }
  if (source.seldom() && !model.faces.corners.empty()) model.faces.corners.pop_back();
  if (source.next() % 2 == 0) {
    for (std::size_t v = model.positions.size(); v-- > 0;) {
      model.position_of_vertex.push_back(source.seldom() ? source.next() : static_cast<sim::Index>(v));
    }
  }
  for (std::size_t s = source.next() % 3; s-- > 0;) {
    model.faces.sections.push_back({source.index(model.faces.corner_counts.size() + 1), "g left"});
  }
}

void add_colours(Source& source, ModelArrays& model) {
  SurfaceColours& colours = model.colours;
  for (std::size_t m = source.next() % 3; m-- > 0;) {
    const std::uint32_t width = source.seldom() ? 1U << (source.next() % 32) : 1 + source.next() % 4;
    const std::uint32_t height = source.seldom() ? 1U << (source.next() % 32) : 1 + source.next() % 4;
    const std::size_t bytes = source.seldom() ? 0 : (std::size_t{4} * width * height) % 4096;
    colours.maps.push_back({width, height, std::make_shared<const std::vector<std::uint8_t>>(bytes, source.next())});
  }
  for (std::size_t m = source.next() % 3; m-- > 0;) {
    colours.materials.push_back({.name = "m",
                                 .base_colour = glm::vec3(source.point()),
                                 .map = source.next() % 2 == 0 ? no_map : source.index(colours.maps.size())});
  }
  if (source.next() % 2 == 0) {
    for (std::size_t k = 0; k < model.faces.corners.size(); ++k) {
      colours.corner_uv.emplace_back(static_cast<float>(source.number()), static_cast<float>(source.number()));
    }
  }
  for (std::size_t f = 0; !colours.materials.empty() && f < model.faces.corner_counts.size(); ++f) {
    colours.material_of_face.push_back(source.index(colours.materials.size()));
  }
}

void add_rig(Source& source, ModelArrays& model) {
  Rig& rig = model.rig;
  constexpr std::array names = {"root", "LeftUpLeg", "RightArm", "Head", "Hips"};
  for (std::size_t n = 0, count = 1 + source.next() % 5; n < count; ++n) {
    const sim::Index parent = n == 0 ? no_node : source.index(n);
    rig.nodes.push_back({names[source.next() % names.size()], parent, source.transform()});
  }
  const std::size_t vertices = model.positions.size(), first = vertices > 0 ? source.next() % vertices : 0;
  rig.parts = {{source.index(rig.nodes.size()), "a", 0, first, source.next() % 2 == 0},
               {source.index(rig.nodes.size()), "b", first, vertices - first, source.next() % 2 == 0}};
  rig.in_part = model.positions;
  for (std::size_t b = 1 + source.next() % 3; b-- > 0;) {
    rig.bones.push_back({source.index(rig.nodes.size()), source.transform()});
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    const bool is_skinned = rig.parts[v < first ? 0 : 1].is_skinned;
    if (is_skinned || source.seldom()) {
      rig.influences.push_back({v, source.index(rig.bones.size()), source.seldom() ? source.number() : 1.0});
    }
  }
  for (std::size_t t = source.next() % 2; t-- > 0;) {
    RigTarget target{source.index(rig.parts.size()), source.number(), {}};
    for (std::size_t v = 0; target.part < 2 && v < rig.parts[target.part].vertices; ++v) {
      target.offsets.push_back(source.point());
    }
    rig.targets.push_back(target);
  }
  for (std::size_t c = source.next() % 3; c-- > 0;) {
    RigClip clip{"walk", source.number(), {}, {}, {}};
    for (std::size_t k = source.next() % 3; k-- > 0;) {
      clip.channels.push_back({source.index(rig.nodes.size()), source.keys(), source.keys(), source.keys()});
    }
    if (!rig.targets.empty()) clip.targets.push_back({source.index(rig.targets.size()), source.keys()});
    rig.clips.push_back(clip);
  }
}

}  // namespace

ModelArrays any_arrays(std::span<const std::uint8_t> bytes) {
  Source source(bytes);
  ModelArrays model;
  add_faces(source, model);
  add_colours(source, model);
  if (source.next() % 2 == 0) add_rig(source, model);
  if (source.next() % 4 == 0) model.metres_per_unit = source.number();
  if (source.next() % 4 == 0)
    model.up = static_cast<ModelAxis>(source.seldom() ? source.next() - 128 : source.next() % 6);
  return model;
}

void use_arrays(const ModelArrays& arrays) {
  const auto any_of = [&](const auto& use) {
    try {
      use(to_model(arrays));
    } catch (const std::runtime_error&) {  // InputError and all other errors that the program reports
    } catch (const std::invalid_argument&) {
    }
  };
  for (const int dress : {0, 3}) {
    any_of([&](ImportedModel model) {
      BodySource source;
      source.file = "any";
      source.dress = dress;
      source.clip = dress == 0 ? "all" : "";
      make_body(source, std::move(model), {0.1, 60.0});
    });
  }
  any_of([&](ImportedModel model) {
    Scene scene;
    scene.garment.given = std::make_shared<const ImportedModel>(std::move(model));
    scene.garment.mesh = MeshChoice::model;
    scene.garment.subdivisions = 1;
    load_garment(scene);
  });
  any_of([&](const ImportedModel& model) {
    place_model({model.positions, model.triangles, {}}, {{}, {}, model.metres_per_unit, model.up});
    obj_text(model.faces, model.positions, {});
    for (const TextureImage& map : model.colours.maps) fitted_to(map, 1);
  });
}

bool are_taken_and_used(std::span<const std::uint8_t> bytes) {
  std::optional<ModelArrays> taken;
  try {
    taken = decode(encode(any_arrays(bytes)));
  } catch (const std::runtime_error&) {
    return false;
  }
  use_arrays(*taken);
  return true;
}

}  // namespace taut::test

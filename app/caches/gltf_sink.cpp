#include <nlohmann/json.hpp>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/drawing/framing.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::json;

constexpr double max_bytes = double{1U << 30U};
// Constants of glTF 2.0, section 5.
constexpr int float_type = 5126;
constexpr int index_type = 5125;
constexpr int vertex_data = 34962;
constexpr int index_data = 34963;

/// One vertex for each pair of a mesh vertex and a texture coordinate: a glTF vertex has only one texture coordinate.
struct SplitVertices {
  std::vector<sim::Index> mesh_vertex;
  std::vector<glm::vec2> uv;
  std::vector<sim::Index> corners;  ///< three per triangle

  explicit SplitVertices(const GarmentInScene& loaded) {
    std::map<std::tuple<sim::Index, std::uint32_t, std::uint32_t>, sim::Index> known;
    for (const sim::Triangle& t : loaded.shown_mesh().triangles) {
      for (const sim::Index vertex : t) {
        const glm::vec2 at =
            loaded.colours.corner_uv.empty() ? glm::vec2(0.0F) : loaded.colours.corner_uv[corners.size()];
        const auto [place, is_new] =
            known.try_emplace({vertex, std::bit_cast<std::uint32_t>(at.x), std::bit_cast<std::uint32_t>(at.y)},
                              static_cast<sim::Index>(mesh_vertex.size()));
        if (is_new) {
          mesh_vertex.push_back(vertex);
          uv.push_back(at);
        }
        corners.push_back(place->second);
      }
    }
  }
};

/// Binary data of the file, with the descriptions of its parts.
class Buffer {
 public:
  template <class Numbers> int add(const Numbers& numbers, const char* type, int components, int target = 0) {
    using Number = typename Numbers::value_type;
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(Number)}};
    if (target != 0) view["target"] = target;
    for (const Number number : numbers) {
      const auto little = sim::little_endian(number);
      bytes_.append(little.begin(), little.end());
    }
    views_.push_back(std::move(view));
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", std::is_same_v<Number, float> ? float_type : index_type},
                          {"count", numbers.size() / static_cast<std::size_t>(components)},
                          {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  /// Adds numbers with the minimum and maximum of each component, which glTF requires for positions and times.
  int add_bounded(const std::vector<float>& numbers, const char* type, std::size_t components, int target = 0) {
    const int accessor = add(numbers, type, static_cast<int>(components), target);
    std::vector<float> least(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(components));
    std::vector<float> most = least;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      least[k % components] = std::min(least[k % components], numbers[k]);
      most[k % components] = std::max(most[k % components], numbers[k]);
    }
    accessors_.back()["min"] = least;
    accessors_.back()["max"] = most;
    return accessor;
  }

  /// Adds an image and returns the index of its buffer view.
  std::size_t add_png(const TextureImage& image) {
    const std::vector<std::uint8_t> png =
        renderer::encode_png({static_cast<int>(image.width_px), static_cast<int>(image.height_px), 4, *image.rgba});
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", png.size()}});
    bytes_.append(png.begin(), png.end());
    bytes_.append((4 - bytes_.size() % 4) % 4, '\0');
    return views_.size() - 1;
  }

  /// Returns the whole file.
  std::string glb(Json description) const {
    description["buffers"] = {{{"byteLength", bytes_.size()}}};
    description["bufferViews"] = views_;
    description["accessors"] = accessors_;
    std::string text = description.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    constexpr std::size_t headers = 12 + 8 + 8;
    sim::ByteWriter out;
    const auto put = [&](std::size_t number) { out.put(static_cast<std::uint32_t>(number)); };
    constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    put(glb_magic), put(2), put(headers + text.size() + bytes_.size()), put(text.size()), put(json_chunk);
    std::string file = out.bytes() + text;
    out = {};
    put(bytes_.size()), put(binary_chunk);
    return file.append(out.bytes()).append(bytes_);
  }

 private:
  std::string bytes_;  ///< length is a multiple of 4, because all numbers have 4 bytes
  std::vector<Json> views_;
  std::vector<Json> accessors_;
};

class GltfSink final : public FrameSink {
 public:
  GltfSink(const ExportSettings& settings, const GarmentInScene& loaded)
      : settings_(settings), loaded_(loaded), vertices_(loaded) {
    const double frames = settings.frames.count();
    // Counts positions and normals of the rest shape and of each frame, and for each frame one weight per frame.
    const double bytes = 24.0 * (frames + 1.0) * static_cast<double>(vertices_.uv.size()) + 4.0 * frames * frames;
    if (bytes > max_bytes) {
      throw InputError(
          "cannot write '{}': {:.0f} frames of {} vertices are {:.1f} GiB, and a .glb is held in "
          "memory until it "
          "is written; expected at most 1 GiB: fewer --frames, or .pc2",
          settings.name, frames, vertices_.uv.size(), bytes / max_bytes);
    }
    const sim::Mesh& mesh = loaded.shown_mesh();
    rest_positions_ = flat_numbers(to_float(mesh.positions));
    rest_normals_ = flat_numbers(mesh_normals(mesh, mesh.positions));
    rest_["POSITION"] = buffer_.add_bounded(rest_positions_, "VEC3", 3, vertex_data);
    rest_["NORMAL"] = buffer_.add(rest_normals_, "VEC3", 3, vertex_data);
    if (!loaded.colours.corner_uv.empty()) {
      std::vector<float> uv;
      for (const glm::vec2& at : vertices_.uv) uv.insert(uv.end(), {at.x, 1.0F - at.y});
      rest_["TEXCOORD_0"] = buffer_.add(uv, "VEC2", 2, vertex_data);
    }
  }

  void write(int frame, std::span<const sim::Vec3> shown_m) override {
    if (!settings_.frames.contains(frame)) return;
    std::vector<float> moved = flat_numbers(to_float(shown_m));
    std::vector<float> turned = flat_numbers(mesh_normals(loaded_.shown_mesh(), shown_m));
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k] -= rest_positions_[k];
      turned[k] -= rest_normals_[k];
    }
    Json& target = targets_.emplace_back();
    target["POSITION"] = buffer_.add_bounded(moved, "VEC3", 3, vertex_data);
    target["NORMAL"] = buffer_.add(turned, "VEC3", 3, vertex_data);
  }

  std::string finish() override {
    const std::size_t frames = targets_.size();
    if (frames == 0) return "wrote nothing";
    Json description;
    description["asset"] = {{"version", "2.0"}, {"generator", "taut " + program_version()}};
    description["scene"] = 0;
    description["scenes"] = {{{"nodes", {0}}}};
    description["nodes"] = {{{"mesh", 0}, {"name", "garment"}}};
    put_surface(description);
    description["animations"] = Json::array({animation()});
    write_text_file(settings_.name, buffer_.glb(std::move(description)));
    return fmt::format("wrote {}, {}", settings_.name, count_text(frames, "frame"));
  }

 private:
  /// Returns the components of the mesh's vectors, for each vertex of the file.
  std::vector<float> flat_numbers(std::span<const glm::vec3> of_mesh) const {
    std::vector<float> numbers;
    for (const sim::Index vertex : vertices_.mesh_vertex) {
      const glm::vec3& v = of_mesh[vertex];
      numbers.insert(numbers.end(), {v.x, v.y, v.z});
    }
    return numbers;
  }

  /// Adds a primitive for each used material. All share the same vertices.
  void put_surface(Json& description) {
    std::map<sim::Index, std::vector<sim::Index>> corners_of_material;
    const std::vector<sim::Index>& material_of_face = loaded_.colours.material_of_face;
    for (std::size_t c = 0; c < vertices_.corners.size(); ++c) {
      corners_of_material[material_of_face.empty() ? no_map : material_of_face[c / 3]].push_back(vertices_.corners[c]);
    }
    Json primitives = Json::array();
    for (const auto& [material, corners] : corners_of_material) {
      primitives.push_back({{"attributes", rest_},
                            {"indices", buffer_.add(corners, "SCALAR", 1, index_data)},
                            {"material", primitives.size()},
                            {"targets", targets_}});
      description["materials"].push_back(find_fabric_material(material, description));
    }
    std::vector<int> first_frame(targets_.size(), 0);
    first_frame[0] = 1;
    description["meshes"] = {{{"name", "garment"}, {"primitives", primitives}, {"weights", first_frame}}};
  }

  Json find_fabric_material(sim::Index index, Json& description) {
    const SurfaceMaterial material =
        index == no_map ? SurfaceMaterial{.name = "cloth"} : loaded_.colours.materials[index];
    Json surface = {{"metallicFactor", 0.0}, {"roughnessFactor", settings_.look.roughness}};
    if (material.map != no_map && rest_.contains("TEXCOORD_0")) {
      const std::size_t view = buffer_.add_png(loaded_.colours.maps[material.map]);
      description["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
      description["textures"].push_back({{"source", description["images"].size() - 1}});
      surface["baseColorTexture"] = {{"index", description["textures"].size() - 1}};
    } else {
      const auto linear = [&](int k) { return srgb_to_linear(std::clamp(material.base_colour[k], 0.0F, 1.0F)); };
      surface["baseColorFactor"] = {linear(0), linear(1), linear(2), 1.0};
    }
    std::array<float, 3> sheen{};
    for (std::size_t k = 0; k < 3; ++k) {
      sheen[k] =
          settings_.look.sheen *
          std::lerp(1.0F, surface.value("baseColorFactor", std::array<float, 4>{1, 1, 1, 1})[k], renderer::fringe_dyed);
    }
    description["extensionsUsed"] = {"KHR_materials_sheen"};
    return {{"name", material.name},
            {"doubleSided", true},
            {"pbrMetallicRoughness", surface},
            {"extensions",
             {{"KHR_materials_sheen",
               {{"sheenColorFactor", sheen}, {"sheenRoughnessFactor", settings_.look.sheen_roughness}}}}}};
  }

  /// Returns an animation in which each frame has weight 1 at its time.
  Json animation() {
    const std::size_t frames = targets_.size();
    std::vector<float> times(frames);
    std::vector<float> weights(frames * frames, 0.0F);
    for (std::size_t k = 0; k < frames; ++k) {
      times[k] = static_cast<float>(static_cast<double>(k) / settings_.frame_rate_hz);
      weights[k * frames + k] = 1.0F;
    }
    return {{"samplers",
             {{{"input", buffer_.add_bounded(times, "SCALAR", 1)}, {"output", buffer_.add(weights, "SCALAR", 1)}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}};
  }

  ExportSettings settings_;
  const GarmentInScene& loaded_;
  SplitVertices vertices_;
  std::vector<float> rest_positions_;
  std::vector<float> rest_normals_;
  Buffer buffer_;
  Json rest_ = Json::object();    ///< attributes of the rest shape
  Json targets_ = Json::array();  ///< one for each frame
};

}  // namespace

std::unique_ptr<FrameSink> make_gltf_sink(const ExportSettings& settings, const GarmentInScene& loaded) {
  return std::make_unique<GltfSink>(settings, loaded);
}

}  // namespace taut::app

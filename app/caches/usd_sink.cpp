#include <fstream>

#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/drawing/framing.hpp"

namespace taut::app {
namespace {

/// Returns the items as a list in one line.
template <class Items, class TextOf> std::string join_list(const Items& items, const TextOf& to_usd_tuple) {
  return '[' + join(collect<std::string>(items, to_usd_tuple)) + ']';
}

template <class Numbers> std::string numbers_text(const Numbers& numbers) {
  return join_list(numbers, [](auto number) { return fmt::format("{}", number); });
}

// Writes the shortest digits that restore the same single-precision numbers, which USD uses for points.
std::string to_usd_tuple(const glm::vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

/// Returns a surface for every renderer and a MaterialX standard surface, which has sheen as well.
std::string material_text(const SurfaceMaterial& material, const renderer::SurfaceStyle& look) {
  glm::vec3 colour;
  for (int k = 0; k < 3; ++k) colour[k] = srgb_to_linear(std::clamp(material.base_colour[k], 0.0F, 1.0F));
  return fmt::format(R"(
    def Material "Cloth"
    {{
        token outputs:surface.connect = </Garment/Cloth/Preview.outputs:surface>
        token outputs:mtlx:surface.connect = </Garment/Cloth/Standard.outputs:surface>

        def Shader "Preview"
        {{
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor = {0}
            float inputs:roughness = {1}
            token outputs:surface
        }}

        def Shader "Standard"
        {{
            uniform token info:id = "ND_standard_surface_surfaceshader"
            color3f inputs:base_color = {0}
            float inputs:specular_roughness = {1}
            float inputs:sheen = {2}
            color3f inputs:sheen_color = (1, 1, 1)
            float inputs:sheen_roughness = {3}
            token outputs:surface
        }}
    }}
)",
                     to_usd_tuple(colour), look.roughness, look.sheen, look.sheen_roughness);
}

class UsdSink final : public FrameSink {
 public:
  UsdSink(const ExportSettings& settings, const GarmentInScene& loaded)
      : settings_(settings), loaded_(loaded), cloth_(loaded), incomplete_(temporary_name(settings.name)) {}

  ~UsdSink() override {
    std::error_code error;
    if (file_.is_open()) std::filesystem::remove(incomplete_, error);
  }

  void write(int frame, std::span<const sim::Vec3> shown_m) override {
    if (!settings_.frames.contains(frame)) return;
    if (!file_.is_open()) begin();
    const std::vector<glm::vec3> positions_m = to_float(cloth_.positions(shown_m));
    const auto [low, high] = renderer::bounding_box(positions_m);
    file_ << fmt::format("            {}: {},\n", frame, join_list(positions_m, to_usd_tuple));
    extents_ += fmt::format("            {}: [{}, {}],\n", frame, to_usd_tuple(low), to_usd_tuple(high));
    last_ = frame;
    if (!file_) fail_to_write(settings_.name, std::generic_category().message(errno));
  }

  std::string finish() override {
    if (!file_.is_open()) return "wrote nothing";
    file_ << "        }\n        float3[] extent.timeSamples = {\n"
          << extents_ << "        }\n    }\n"
          << material_text(loaded_.colours.materials.empty() ? SurfaceMaterial{} : loaded_.colours.materials.front(),
                           settings_.look)
          << "}\n";
    file_.close();
    if (!file_) fail_to_write(settings_.name, std::generic_category().message(errno));
    rename_complete(incomplete_, settings_.name);
    return fmt::format("wrote {}, {}", settings_.name,
                       count_text(static_cast<std::size_t>(last_ - settings_.frames.first + 1), "frame"));
  }

 private:
  /// Writes everything that does not move, up to the points.
  void begin() {
    create_file(incomplete_, settings_.name);
    file_.open(incomplete_, std::ios::binary | std::ios::trunc);
    const FileFaces& faces = cloth_.faces();
    file_ << fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"Garment\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n"
        "    startTimeCode = {}\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n)\n\n"
        "def Xform \"Garment\"\n{{\n    def Mesh \"Surface\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
        "    )\n    {{\n        uniform token subdivisionScheme = \"none\"\n        uniform bool doubleSided = 1\n"
        "        rel material:binding = </Garment/Cloth>\n        int[] faceVertexCounts = {}\n"
        "        int[] faceVertexIndices = {}\n",
        settings_.frames.first, settings_.frames.last, settings_.frame_rate_hz, numbers_text(faces.corner_counts),
        numbers_text(faces.corners));
    if (!faces.corner_uv.empty()) {
      const auto text = [](const glm::vec2& uv) { return fmt::format("({}, {})", uv.x, uv.y); };
      file_ << "        texCoord2f[] primvars:st = " << join_list(faces.corner_uv, text)
            << " (\n            interpolation = \"faceVarying\"\n        )\n";
    }
    file_ << "        point3f[] points.timeSamples = {\n";
  }

  ExportSettings settings_;
  const GarmentInScene& loaded_;
  WrittenCloth cloth_;
  std::filesystem::path incomplete_;
  std::ofstream file_;
  std::string extents_;  ///< bounding boxes of the frames so far
  int last_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> make_usd_sink(const ExportSettings& settings, const GarmentInScene& loaded) {
  return std::make_unique<UsdSink>(settings, loaded);
}

}  // namespace taut::app

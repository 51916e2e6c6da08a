#include "app/drawing/garment_surface.hpp"

#include "app/base/errors.hpp"
#include "app/drawing/framing.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/garment_parts.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

sim::Groups find_pieces(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  const std::vector<std::uint32_t> triangles = flat(garment.mesh.triangles);
  const std::vector<renderer::VertexPair> seams =
      renderer::seam_edges(to_float(garment.mesh.positions), triangles, corner_uv);
  const std::vector<renderer::TriangleSide> sides = renderer::sorted_sides(triangles);
  sim::Groups pieces(garment.mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].ends == sides[i + 1].ends && !std::ranges::binary_search(seams, sides[i].ends)) {
      pieces.join(sides[i].number / 3, sides[i + 1].number / 3);
    }
  }
  return pieces;
}

struct Areas {
  double in_m2 = 0.0;
  double in_uv = 0.0;  ///< negative: mirrored
};

// Sizes for an adult's garment. A smaller garment has them times its share of an adult's diagonal, at least
// min_size_factor.
constexpr float hem_m = 0.02F;
constexpr float neckband_m = 0.018F;
constexpr double diagonal_of_adult_m = 0.8;
constexpr float min_size_factor = 0.25F;
// Maximum width of a hem as a fraction of its length, so that small holes get narrow hems.
constexpr float max_hem_length_ratio = 1.0F / 12.0F;

// Minimum length of a seam along sharp edges, in stitches. Shorter sharp edges are folds of the model.
constexpr float min_seam_stitches = 25.0F;

std::vector<renderer::VertexPair> long_edges(std::span<const renderer::VertexPair> edges,
                                             std::span<const glm::vec3> rest_positions, float min_length_m) {
  const renderer::LineChains lines = renderer::make_lines(edges, rest_positions);
  std::vector<renderer::VertexPair> kept_pairs;
  for (const renderer::LineChains::ChainSegment& segment : lines.segments) {
    if (lines.chains[segment.chain].length >= min_length_m) kept_pairs.push_back(segment.ends);
  }
  return kept_pairs;
}

bool is_around_neck(const Opening& opening, const GarmentMarks& marks) {
  return marks.top && !marks.is_worn_at_waist && opening.range.lower == marks.top->lower &&
         opening.range.upper == marks.top->upper;
}

std::vector<renderer::BorderBand> make_border_bands(const sim::Garment& garment, float share) {
  const GarmentMarks marks = find_garment_marks(garment, garment.mesh.positions, {});
  std::vector<renderer::BorderBand> bands(garment.mesh.positions.size());
  for (const GarmentPart& part : find_garment_parts(garment.mesh, garment.adjacency)) {
    for (const Opening& opening : part.openings) {
      const bool ribbed = is_around_neck(opening, marks);
      const float width_m =
          std::min(share * (ribbed ? neckband_m : hem_m), max_hem_length_ratio * static_cast<float>(opening.length_m));
      for (const sim::Index vertex : opening.vertices) bands[vertex] = {width_m, ribbed};
    }
  }
  return bands;
}

// Size in pixels below which a rim or a stitch is not drawn.
constexpr float min_rim_px = 0.7F;
constexpr float min_stitch_px = 0.8F;

float mean_edge_m(const sim::Garment& garment) {
  double sum_m = 0.0;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    sum_m += glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]);
  }
  return static_cast<float>(sum_m / static_cast<double>(std::max<std::size_t>(garment.adjacency.edges.size(), 1)));
}

// Wrinkles are about two bending lengths long. The mesh itself shows wrinkles of four edges and more. If its edges are
// nearly as long as the wrinkles, it does not tell where they are.
constexpr float wrinkle_bending_lengths = 2.0F;
constexpr float resolved_wrinkle_edges = 4.0F;
constexpr float min_wrinkle_edges = 1.2F;
constexpr float min_drawn_wrinkle_edges = 2.5F, max_drawn_wrinkle_edges = 3.5F;

/// Returns the wavelength in metres of the wrinkles to draw; 0: none. The bending length is the edge of a square of
/// cloth that its own weight bends clearly (Peirce 1930).
float wavelength_m(const sim::Material& material, float edge_m) {
  const double bending_length_m = std::cbrt(material.bending_rigidity_n_m / (material.areal_density_kg_per_m2 * 9.81));
  const float wanted_m = wrinkle_bending_lengths * static_cast<float>(bending_length_m);
  const bool is_drawn = wanted_m > min_wrinkle_edges * edge_m && wanted_m < resolved_wrinkle_edges * edge_m;
  return !is_drawn ? 0.0F : std::clamp(wanted_m, min_drawn_wrinkle_edges * edge_m, max_drawn_wrinkle_edges * edge_m);
}

// Flexural springs lie under the structural springs that they run along. Their lines are wider, to show on both sides.
constexpr float flexural_width_factor = 2.5F;

// Inside of cloth that is printed or dyed on its outside.
constexpr renderer::Colour undyed_colour = renderer::rgb(0xE6E2DC);

renderer::Colour inner_colour(const renderer::SurfaceStyle& cloth) {
  return cloth.inside_colour.value_or(renderer::reverse_colour(cloth.outside_colour));
}

renderer::BaseColourMap to_base_colour_map(const TextureImage& image) {
  return {static_cast<int>(image.width_px), static_cast<int>(image.height_px), image.rgba};
}

DrawnColours print(const PictureStyle& style, const SurfaceColours& colours) {
  if (colours.corner_uv.empty()) {
    throw InputError("picture.texture: '" + style.texture.string() +
                     "' cannot be drawn, as the garment has no texture coordinates; expected a model that "
                     "has, such as an OBJ file with vt lines");
  }
  return {colours.corner_uv,
          {{style.cloth.outside_colour, inner_colour(style.cloth), to_base_colour_map(read_image(style.texture))}},
          {}};
}

renderer::BaseColour to_base_colour(const SurfaceMaterial& material, const SurfaceColours& colours,
                                    const renderer::Colour& inside_colour) {
  if (material.map == no_map || colours.corner_uv.empty()) return {material.base_colour, material.base_colour, {}};
  return {material.base_colour, inside_colour, to_base_colour_map(colours.maps[material.map])};
}

DrawnColours model_colours(const PictureStyle& style, const SurfaceColours& colours) {
  DrawnColours drawn{colours.corner_uv, {}, colours.material_of_face, colours.remarks};
  for (const SurfaceMaterial& material : colours.materials) {
    drawn.base_colours.push_back(to_base_colour(material, colours, style.cloth.inside_colour.value_or(undyed_colour)));
  }
  return drawn;
}

// Programs write white or a grey where nobody chose a colour.
constexpr float max_grey_difference = 0.02F;

bool are_chosen(const SurfaceColours& colours) {
  return std::ranges::any_of(colours.materials, [](const SurfaceMaterial& material) {
    const glm::vec3& rgb = material.base_colour;
    const float difference = std::max({rgb.x, rgb.y, rgb.z}) - std::min({rgb.x, rgb.y, rgb.z});
    return !material.map_file.empty() || difference > max_grey_difference;
  });
}

PictureStyle fabric_style(const std::string& fabric) {
  DrawnScene scene;
  apply_overrides(drawn_scene_format(), std::vector<Override>{{"cloth.fabric", fabric, "fabrics"}}, scene);
  return scene.picture;
}

/// Returns the colours of a garment whose layers have fabrics of their own.
DrawnColours layer_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  DrawnColours drawn{
      loaded.colours.corner_uv, {{scene.picture.cloth.outside_colour, inner_colour(scene.picture.cloth), {}}}, {}};
  for (const auto& [group, fabric] : read_garment_facts(scene.garment.model()).fabrics) {
    const renderer::SurfaceStyle cloth = fabric_style(fabric).cloth;
    drawn.base_colours.push_back({cloth.outside_colour, inner_colour(cloth), {}});
  }
  for (const sim::Triangle& t : loaded.garment->mesh.triangles) {
    drawn.base_colour_of_triangle.push_back(loaded.garment->material_indices[t[0]]);
  }
  return drawn;
}

DrawnColours choose_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  const PictureStyle& style = scene.picture;
  if (names_image(style.texture)) return print(style, loaded.colours);
  if (style.texture != no_texture && !loaded.garment->material_indices.empty()) return layer_colours(scene, loaded);
  const bool is_coloured = style.cloth.outside_colour != renderer::SurfaceStyle().outside_colour;
  if (style.texture == no_texture || is_coloured || !are_chosen(loaded.colours)) {
    return {loaded.colours.corner_uv, {}, {}};
  }
  return model_colours(style, loaded.colours);
}

}  // namespace

std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  if (corner_uv.empty()) return {};
  const sim::Mesh& mesh = garment.mesh;
  sim::Groups pieces = find_pieces(garment, corner_uv);
  std::vector<Areas> areas(mesh.triangles.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec2 a(corner_uv[3 * t]);
    const glm::dvec2 ab = glm::dvec2(corner_uv[3 * t + 1]) - a, ac = glm::dvec2(corner_uv[3 * t + 2]) - a;
    Areas& own = areas[pieces.find(t)];
    own.in_m2 += 0.5 * glm::length(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]));
    own.in_uv += 0.5 * (ab.x * ac.y - ab.y * ac.x);
  }
  std::vector<glm::vec2> coordinates;
  coordinates.reserve(corner_uv.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const Areas& own = areas[pieces.find(t)];
    const double scale = std::sqrt(own.in_m2 / std::abs(own.in_uv));
    if (!std::isfinite(scale)) return {};
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      coordinates.emplace_back(std::copysign(scale, own.in_uv) * corner_uv[corner].x, scale * corner_uv[corner].y);
    }
  }
  return coordinates;
}

GarmentSewing make_garment_sewing(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates) {
  GarmentSewing sewing;
  sewing.rim_radius_m = 0.5F * static_cast<float>(garment.material.thickness_m);
  if (!garment.mesh.quads.empty()) return sewing;
  const double diagonal_m = glm::length(sim::compute_extent(garment.mesh.positions).size());
  const float share = std::clamp(static_cast<float>(diagonal_m / diagonal_of_adult_m), min_size_factor, 1.0F);
  sewing.stitch_m *= share;
  sewing.rim_radius_m *= 2.0F;
  sewing.bands = make_border_bands(garment, share);
  const std::vector<glm::vec3> rest_positions = to_float(garment.mesh.positions);
  sewing.seams = renderer::seam_edges(rest_positions, flat(garment.mesh.triangles), corner_coordinates);
  if (corner_coordinates.empty()) {
    sewing.seams = long_edges(sewing.seams, rest_positions, min_seam_stitches * sewing.stitch_m);
  }
  return sewing;
}

GarmentSurface::GarmentSurface(const sim::Garment& garment, std::vector<glm::vec2> corner_coordinates,
                               std::vector<std::uint32_t> colour_of_triangle)
    : triangles_(flat(garment.mesh.triangles)),
      rest_positions_(to_float(garment.mesh.positions)),
      corner_coordinates_(std::move(corner_coordinates)),
      cloth_coordinates_(cloth_coordinates(garment, corner_coordinates_)),
      colour_of_triangle_(std::move(colour_of_triangle)),
      edge_m_(mean_edge_m(garment)),
      wavelength_m_(wavelength_m(garment.material, edge_m_)),
      sewing_(make_garment_sewing(garment, corner_coordinates_)) {}

void GarmentSurface::set_detail(float pixels_per_m, std::optional<float> min_edge_px) {
  Detail wanted;
  if (min_edge_px) {
    wanted.levels = renderer::refinement_levels(edge_m_ * pixels_per_m, triangles_.size() / 3, *min_edge_px);
    wanted.rim = 2.0F * sewing_.rim_radius_m * pixels_per_m > min_rim_px;
    wanted.sewn = sewing_.stitch_m * pixels_per_m > min_stitch_px;
  }
  if (!surface_ || wanted != detail_) {
    detail_ = wanted;
    make();
  }
}

void GarmentSurface::make() {
  surface_.emplace(rest_positions_, triangles_, detail_.levels, freedom_, detail_.rim ? sewing_.rim_radius_m : 0.0F);
  surface_->place(rest_positions_);
  material_coordinates_ = surface_->positions();
  wrinkles_.reset();
  if (is_wrinkled_ && is_refined() && wavelength_m_ > 0.0F) {
    wrinkles_.emplace(rest_positions_, triangles_, wavelength_m_);
    wrinkles_->refine(std::span(material_coordinates_).first(surface_->mesh().vertex_count()),
                      surface_->mesh().parents());
  }
  fine_corner_coordinates_ = fine_corner_values(corner_coordinates_);
  fine_colour_of_triangle_.clear();
  if (!colour_of_triangle_.empty()) {
    for (const std::uint32_t parent : surface_->parent_triangles()) {
      fine_colour_of_triangle_.push_back(colour_of_triangle_[parent]);
    }
  }
  trims_.clear();
  if (detail_.sewn) {
    trims_ = renderer::trimmed_triangles(*surface_, material_coordinates_,
                                         {sewing_.bands, sewing_.seams, sewing_.stitch_m, sewing_.rim_radius_m});
  }
  if (!cloth_coordinates_.empty()) {
    material_coordinates_.clear();
    for (const glm::vec2& place : surface_->part_vertices(fine_corner_values(cloth_coordinates_))) {
      material_coordinates_.emplace_back(place, 0.0F);
    }
  }
}

// Returns texture coordinates of the fine surface. A vertex of the rim takes the values of the border beside it.
std::vector<glm::vec2> GarmentSurface::fine_corner_values(std::span<const glm::vec2> corners) const {
  if (corners.empty()) return {};
  std::vector<glm::vec2> fine = renderer::refined_corner_values(corners, detail_.levels);
  const std::vector<std::uint32_t>& triangles = surface_->triangles();
  std::vector<glm::vec2> at_vertex(surface_->positions().size(), glm::vec2(0.0F));
  for (std::size_t corner = 0; corner < fine.size(); ++corner) at_vertex[triangles[corner]] = fine[corner];
  const std::size_t coarse = surface_->mesh().coarse_vertex_count();
  for (std::size_t v = surface_->mesh().vertex_count(); v < at_vertex.size(); ++v) {
    at_vertex[v] = at_vertex[surface_->parents()[v - coarse][0]];
  }
  for (std::size_t corner = fine.size(); corner < triangles.size(); ++corner) {
    fine.push_back(at_vertex[triangles[corner]]);
  }
  return fine;
}

void GarmentSurface::place(std::span<const glm::vec3> positions, std::span<const float> clearances_m) {
  surface_->place(positions, clearances_m, wrinkles_ ? wrinkles_->heights(positions) : std::span<const float>());
}

renderer::SurfaceView GarmentSurface::view() const {
  const renderer::RefinedMesh& mesh = surface_->mesh();
  renderer::SurfaceView view;
  view.positions = surface_->positions();
  view.normals = surface_->normals();
  view.triangles = surface_->triangles();
  view.material_coordinates = material_coordinates_;
  view.refinement = renderer::Refinement{mesh.coarse_vertex_count(), triangles_, surface_->parents(),
                                         surface_->parent_triangles(), freedom_.max_bulge};
  view.corner_coordinates = fine_corner_coordinates_;
  view.base_colour_of_triangle = fine_colour_of_triangle_;
  view.trims = trims_;
  return view;
}

void GarmentSurface::interpolate(std::vector<float>& values) const {
  renderer::interpolate(std::span(surface_->parents()), values);
}

bool shows(WhichSprings shown, sim::SpringKind kind) {
  return shown == WhichSprings::all || std::strcmp(to_name(shown), sim::to_name(kind)) == 0;
}

SpringLines::SpringLines(const sim::Garment& garment, WhichSprings shown, float width_px) {
  const sim::Springs& springs = garment.springs;
  for (const sim::SpringKind kind : {sim::SpringKind::flexural, sim::SpringKind::shear, sim::SpringKind::structural}) {
    if (!shows(shown, kind)) continue;
    const bool is_under = shown == WhichSprings::all && kind == sim::SpringKind::flexural;
    lines_.push_back({{springs.ends.begin() + static_cast<std::ptrdiff_t>(springs.begin_index(kind)),
                       springs.ends.begin() + static_cast<std::ptrdiff_t>(springs.end_index(kind))},
                      spring_colour(kind),
                      is_under ? flexural_width_factor * width_px : width_px,
                      {}});
  }
}

void SpringLines::add(std::span<const glm::vec3> positions, renderer::FrameView& frame) {
  for (SewingLines& lines : lines_) {
    lines.points.clear();
    for (const sim::Edge& ends : lines.springs) {
      lines.points.push_back(positions[ends[0]]);
      lines.points.push_back(positions[ends[1]]);
    }
    if (!lines.points.empty()) {
      frame.lines.push_back({.points = lines.points, .colour = lines.colour, .width_px = lines.width_px});
    }
  }
}

DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  DrawnColours colours = choose_colours(scene, loaded);
  colours.following = loaded.following;
  return colours;
}

}  // namespace taut::app

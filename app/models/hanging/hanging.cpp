#include "app/models/hanging/hanging.hpp"

#include "app/base/words.hpp"
#include "app/models/hanging/hanger.hpp"
#include "app/models/hanging/placement.hpp"
#include "app/models/hanging/tuning.hpp"

namespace taut::app {

using namespace hanging;

namespace {

/// Returns the vertices at the end of these in a direction along an axis, in a band that is a fraction of the part.
std::vector<sim::Index> find_end(const sim::Mesh& mesh, const GarmentPart& part, std::span<const sim::Index> vertices,
                                 int axis, double direction) {
  const sim::Extent range = sim::compute_extent(mesh.positions, vertices);
  const double end = direction > 0.0 ? range.upper[axis] : range.lower[axis];
  const double reach = pinned_band_fraction * part.range.size()[axis];
  std::vector<sim::Index> at_end;
  std::ranges::copy_if(vertices, std::back_inserter(at_end),
                       [&](sim::Index v) { return direction * (end - mesh.positions[v][axis]) <= reach; });
  return at_end;
}

/// Returns the highest of the vertices on either side of the centre of mass, no farther out than `reach_m`. Empty if
/// there are none on one side.
std::vector<sim::Index> find_tops(const sim::Mesh& mesh, const GarmentPart& part,
                                  const std::vector<sim::Index>& vertices, double reach_m) {
  std::vector<sim::Index> top_vertices;
  for (const double side : {-1.0, 1.0}) {
    std::vector<sim::Index> half;
    for (const sim::Index v : vertices) {
      const double out_m = side * (mesh.positions[v][part.across()] - part.centre_m[part.across()]);
      if (out_m > 0.0 && out_m <= reach_m) half.push_back(v);
    }
    if (half.empty()) return {};
    std::ranges::copy(find_end(mesh, part, half, 1, 1.0), std::back_inserter(top_vertices));
  }
  return top_vertices;
}

/// Returns whether these openings reach up to straps on both sides, as armholes do and cuffs do not.
bool reach_up(const sim::Mesh& mesh, const GarmentPart& part, const std::vector<sim::Index>& pair, double top_m) {
  std::array<double, 2> max_height_m = {part.range.lower.y, part.range.lower.y};
  for (const sim::Index v : pair) {
    const bool is_right = mesh.positions[v][part.across()] > part.centre_m[part.across()];
    max_height_m[is_right ? 1 : 0] = std::max(max_height_m[is_right ? 1 : 0], mesh.positions[v].y);
  }
  return std::min(max_height_m[0], max_height_m[1]) >= top_m - min_strap_neckline_depth * part.range.size().y;
}

/// Returns the tops of straps if the opening at the top is their border, else none.
std::vector<sim::Index> straps(const sim::Mesh& mesh, const GarmentPart& part, const Opening& top) {
  const double depth = top.range.size().y / part.range.size().y;
  const bool is_neckline =
      depth >= min_strap_neckline_depth && reach_up(mesh, part, pair_of_openings(part), top.range.upper.y);
  return is_neckline ? find_tops(mesh, part, part.vertices, part.width_m()) : std::vector<sim::Index>();
}

/// Returns the vertices that hold a part that lies flat.
std::vector<sim::Index> find_flat_pins(const sim::Mesh& mesh, const GarmentPart& part, HungPart& hung) {
  if (const Opening* opening = inner_opening(part); opening != nullptr) {
    hung.by = HungBy::top_opening;
    return opening->vertices;
  }
  hung.by = HungBy::back_edge;
  const bool is_a_ribbon = part.range.size().z <= max_flat_part_thickness * part.size_m();
  return find_end(mesh, part, part.vertices, is_a_ribbon ? 0 : 2, -1.0);
}

/// Returns the vertices that hold a part that stands up: the first set that carries it in balance, or else its highest
/// points.
std::vector<sim::Index> find_upright_pins(const sim::Mesh& mesh, const GarmentPart& part, HungPart& hung) {
  if (std::vector<sim::Index> neck = neck_below_hood(mesh, part, part.across()); !neck.empty()) {
    hung.by = HungBy::neck;
    return neck;
  }
  if (const Opening* opening = top_opening(part); opening != nullptr) {
    hung.by = HungBy::top_opening;
    if (std::vector<sim::Index> tops = straps(mesh, part, *opening); !tops.empty()) {
      hung.by = HungBy::straps;
      return tops;
    }
    return opening->vertices;
  }
  std::vector<sim::Index> band = find_end(mesh, part, part.vertices, 1, 1.0);
  // Sleeves that are stretched out are as high as shoulders, but nobody hangs a garment by them.
  if (carries(part, sim::compute_extent(mesh.positions, band)) && !has_sleeves(part)) return band;
  if (std::vector<sim::Index> pair = pair_of_openings(part); !pair.empty()) {
    hung.by = HungBy::straps;
    return find_tops(mesh, part, pair, part.width_m());
  }
  const double shoulders_m = max_pinned_shoulder_offset * part.width_m();
  if (std::vector<sim::Index> both = find_tops(mesh, part, part.vertices, shoulders_m); !both.empty()) {
    hung.by = HungBy::shoulders;
    return both;
  }
  return band;
}

HungPart hang_part(const sim::Mesh& mesh, const GarmentPart& part, std::vector<sim::Index>& pins) {
  const sim::Vec3 size = part.range.size();
  HungPart hung;
  hung.vertices = part.vertices.size();
  hung.area_m2 = part.area_m2;
  hung.closed = part.openings.empty();
  hung.flat = std::min({size.x, size.y, size.z}) <= max_flat_part_thickness * part.size_m();
  const bool is_lying = size.y <= max_flat_part_thickness * part.size_m();
  const std::vector<sim::Index> pinned_vertices =
      is_lying ? find_flat_pins(mesh, part, hung) : find_upright_pins(mesh, part, hung);
  hung.pins = pinned_vertices.size();
  pins.insert(pins.end(), pinned_vertices.begin(), pinned_vertices.end());
  return hung;
}

const char* hanging_name(HungBy by) {
  constexpr std::array ways = {"hung by its top opening",
                               "held at its highest points",
                               "lies flat, held by its back edge",
                               "hung by the neck below its hood",
                               "hung by its straps",
                               "held on both shoulders",
                               "on a hanger"};
  return ways[static_cast<std::size_t>(by)];
}

/// Returns how much the cloth sags when it hangs with this axis up: the mean distance by which it moves, divided by the
/// square of its height along this axis. Without the height cloth that lies would win, as it hardly moves. Empty if it
/// cannot be hung.
std::optional<double> sagging_when_hung(const sim::Mesh& model_m, ModelAxis up) {
  sim::Mesh mesh = upright(model_m, up);
  const std::vector<sim::Vec3> start_m = mesh.positions;
  std::vector<sim::Index> pins = hang(mesh, sim::make_adjacency(mesh)).pins;
  if (pins.empty()) return std::nullopt;
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.contact = false};
  try {
    sim::Simulation simulation(sim::share(sim::make_garment(std::move(mesh), {})), std::move(pins), settings, {});
    for (int frame = 0; frame < trial_frames; ++frame) simulation.advance_frame();
    const std::vector<double>& masses_kg = simulation.garment().masses_kg;
    double sum_kg_m = 0.0, all_kg = 0.0;
    for (std::size_t v = 0; v < start_m.size(); ++v) {
      sum_kg_m += masses_kg[v] * glm::distance(simulation.state().current[v], start_m[v]);
      all_kg += masses_kg[v];
    }
    const double height_m = sim::compute_extent(simulation.state().current).size().y;
    return sum_kg_m / all_kg / (height_m * height_m);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// Returns the widths of flat cloth at even levels, from its lower end.
std::vector<double> measure_widths(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  std::vector<sim::Extent> at_level(flat_levels);
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) {
      const double height = (mesh.positions[v].y - box.lower.y) / box.size().y;
      at_level[std::min<std::size_t>(flat_levels - 1, static_cast<std::size_t>(flat_levels * height))].add(
          mesh.positions[v]);
    }
  }
  return collect<double>(at_level, [](const sim::Extent& level) { return std::max(0.0, level.size().x); });
}

/// Returns whether flat cloth stands on its head: its sleeves, beside which it is narrower at once, are in the lower
/// half, or, without sleeves, most of its area is in the upper half.
bool is_upside_down(const sim::Mesh& mesh) {
  const std::vector<double> widths = measure_widths(mesh);
  double sleeves = 0.0;
  for (std::size_t k = 1; k < widths.size(); ++k) {
    if (widths[k] < max_narrowing * widths[k - 1]) sleeves -= 1.0;
    if (widths[k - 1] < max_narrowing * widths[k]) sleeves += 1.0;
  }
  if (sleeves != 0.0) return sleeves < 0.0;
  double moment = 0.0, all = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    const double area = glm::length(sim::doubled_area_vector(mesh.positions, t));
    moment += area * (mesh.positions[t[0]].y + mesh.positions[t[1]].y + mesh.positions[t[2]].y) / 3.0;
    all += area;
  }
  const sim::Extent box = sim::compute_extent(mesh.positions);
  return moment / all > box.lower.y + max_middle_height * box.size().y;
}

}  // namespace

Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  Hanging hanging;
  for (const GarmentPart& part : find_garment_parts(mesh, adjacency)) {
    hanging.parts.push_back(hang_part(mesh, part, hanging.pins));
  }
  std::ranges::sort(hanging.pins);
  return hanging;
}

Hanging hang_as_in_a_shop(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  Hanging hanging = hang(mesh, adjacency);
  const auto largest = std::ranges::max_element(hanging.parts, {}, &HungPart::area_m2);
  if (largest->by != HungBy::shoulders && largest->by != HungBy::neck) return hanging;
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, adjacency);
  const GarmentPart& part = parts[static_cast<std::size_t>(largest - hanging.parts.begin())];
  hanging.hanger = hanger_for(mesh, part, min_chosen_bar_ratio, max_chosen_neckline_ratio);
  if (!hanging.hanger.empty()) {
    largest->by = HungBy::hanger;
    largest->pins = 0;
    std::erase_if(hanging.pins, [&](sim::Index pin) { return std::ranges::binary_search(part.vertices, pin); });
  }
  return hanging;
}

std::vector<std::string> describe(const Hanging& hanging) {
  std::vector<std::string> lines;
  std::size_t closed = 0, flat = 0;
  for (std::size_t p = 0; p < hanging.parts.size(); ++p) {
    const HungPart& part = hanging.parts[p];
    closed += part.closed;
    flat += part.flat;
    if (p < max_described_parts) {
      lines.push_back(fmt::format("part {} of {}: {}, {}, {}", p + 1, hanging.parts.size(),
                                  count_text(part.vertices, "vertex", "vertices"), hanging_name(part.by),
                                  count_text(part.pins, "pin")));
    }
  }
  if (hanging.parts.size() > max_described_parts) {
    lines.push_back(
        fmt::format("and {} more, held likewise", count_text(hanging.parts.size() - max_described_parts, "part")));
  }
  if (closed > 0) {
    lines.push_back(
        fmt::format("{} closed all around: cloth modelled with a thickness hangs as an outer and an inner "
                    "layer, joined where the model joins them",
                    closed == 1 ? "1 part is" : fmt::format("{} parts are", closed)));
  }
  if (flat > 1) {
    lines.push_back(
        fmt::format("{} parts are flat, like pattern pieces before they are sewn: each hangs by itself; "
                    "garment.weld sews borders that lie next to each other",
                    flat));
  }
  return lines;
}

std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m) {
  const std::optional<double> y = sagging_when_hung(model_m, ModelAxis::y);
  const std::optional<double> z = sagging_when_hung(model_m, ModelAxis::z);
  if (!y || !z) return std::nullopt;
  const bool is_z = *z < max_sagging_ratio * *y;
  if (!is_z && *y >= max_sagging_ratio * *z) return std::nullopt;
  const sim::Vec3 size = sim::compute_extent(model_m.positions).size();
  if (is_z && size.y < max_pattern_thickness * size.z) {
    return is_upside_down(upright(model_m, ModelAxis::z)) ? ModelAxis::minus_z : ModelAxis::z;
  }
  return better_way_up(model_m, sim::make_adjacency(model_m), is_z ? ModelAxis::z : ModelAxis::y);
}

}  // namespace taut::app

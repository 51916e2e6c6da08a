#include "any_calls.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cloths.hpp"

namespace taut::test {
namespace {

constexpr std::size_t max_points = 64;
constexpr const char* texts[] = {"",
                                 "wind.speed = 3",
                                 "solver.kind = strong",
                                 "solver.max_stretch=0.01",
                                 "cloth.fabric = silk",
                                 "solver.contact = false",
                                 "=",
                                 "wind.speed",
                                 "gravity.acceleration",
                                 "[0, 1e300, 0]",
                                 "3",
                                 "silk",
                                 "cloth.fabric",
                                 "\xFF\xFE",
                                 "forces",
                                 "[{vertex = 2, force = [0, 1, 0]}]",
                                 "pins.at = [0, 3]",
                                 "/none"};
constexpr const char* scenes[] = {
    "[garment.grid]\ncolumns = 4\nrows = 4\nwidth = 0.1\nheight = 0.1\n[solver]\nmax_substeps = 40\n",
    "[garment.grid]\ncolumns = 3\n[solver]\nkind = \"provot\"\nmax_substeps = 40\n", "[", ""};

class Calls {
 public:
  explicit Calls(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  CallsMade run() {
    while (!bytes_.empty() && made_.calls < 200) {
      made_.successes += call() == TAUT_OK ? 1 : 0;
      ++made_.calls;
      taut_last_error(some_cloth());
    }
    for (const TautCloth cloth : cloths_) {
      taut_destroy(cloth);
    }
    return made_;
  }

 private:
  std::uint8_t next() {
    if (bytes_.empty()) {
      return 0;
    }
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  bool seldom() { return next() % 16 == 1; }

  template <class T>
  T* or_null(T& value) {
    return seldom() ? nullptr : &value;
  }

  const char* text() { return seldom() ? nullptr : texts[next() % std::size(texts)]; }

  TautCloth some_cloth() {
    if (cloths_.empty() || seldom()) {
      return TautCloth{next() * 0x0101010101010101ULL};
    }
    return cloths_[next() % cloths_.size()];
  }

  double number() {
    constexpr double odd[] = {0.0,
                              -0.0,
                              1e300,
                              1e-310,
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN(),
                              -1e9,
                              1e6};
    return seldom() ? odd[next() % std::size(odd)] : (next() - 128) / 512.0;
  }

  std::size_t count(std::size_t usual) {
    constexpr std::size_t odd[] = {0, 1, 5, max_points, ~std::size_t{0}, std::size_t{1} << 40U};
    return seldom() ? odd[next() % std::size(odd)] : usual;
  }

  std::int32_t type() { return seldom() ? next() - 3 : TAUT_DOUBLE; }

  TautPoints points(std::size_t usual) {
    for (double& value : numbers_) {
      value = bytes_.empty() ? value : number();
    }
    const std::size_t stride = seldom() ? next() % 25U : 24U;
    return {seldom() ? nullptr : numbers_.data(), count(usual), stride, type()};
  }

  const std::uint32_t* vertices() {
    for (std::uint32_t& vertex : vertices_) {
      vertex = seldom() ? next() * 0x01010101U : next() % 16U;
    }
    return seldom() ? nullptr : vertices_.data();
  }

  template <class T, class Init>
  T some(const Init& init) {
    T value = make_struct<T>(init);
    if (seldom()) {
      value.struct_size = next() * 0x00010101U;
    }
    return value;
  }

  TautMesh mesh() {
    TautMesh value = some<TautMesh>(taut_mesh_init);
    if (seldom()) {
      value.positions = points(16);
      value.corners = vertices();
      value.corner_count = count(3 * (next() % 16U));
      return value;
    }
    value.positions = square_.points();
    value.corners = square_.corners.data();
    value.corner_count = square_.corners.size();
    value.corners_per_face = square_.sizes.data();
    value.face_count = square_.sizes.size();
    return value;
  }

  TautResult list() {
    std::array<char, 2048> names;
    std::size_t size = 0;
    return taut_list(next() % 4 - 1, or_null(names[0]), seldom() ? next() : names.size(), or_null(size));
  }

  TautResult create() {
    TautOptions options = some<TautOptions>(taut_options_init);
    const TautMesh given = mesh();
    const TautPoints start = points(16);
    const std::array settings = {"solver.max_substeps = 40", text()};
    options.mesh = next() % 2 == 0 ? &given : nullptr;
    options.scene_text =
        options.mesh == nullptr || seldom() ? scenes[next() % 8 < 6 ? 0 : next() % 4] : nullptr;
    options.scene = seldom() ? text() : nullptr;
    options.start = seldom() ? &start : nullptr;
    options.settings = settings.data();
    options.setting_count = seldom() ? 2 : 1;
    options.threads = seldom() ? next() - 100 : 1;
    options.counts_crossings = next() % 2;
    const TautMesh of_body = mesh();
    const TautBody body = some_body(of_body);
    const TautBody* const bodies[] = {or_null(body)};
    options.bodies = seldom() ? nullptr : bodies;
    options.body_count = next() % 4 == 0 ? 1 : 0;
    TautCloth cloth = {};
    TautError error = some<TautError>(taut_error_init);
    if (cloths_.size() > 4) {
      return TAUT_ERROR_MEMORY;
    }
    const TautResult result = taut_create(or_null(options), or_null(cloth), or_null(error));
    if (result == TAUT_OK) {
      cloths_.push_back(cloth);
    }
    return result;
  }

  TautBody some_body(const TautMesh& given) {
    TautBody body = some<TautBody>(taut_body_init);
    body.mesh = next() % 4 == 0 ? &given : nullptr;
    body.dress = seldom() ? next() - 10 : 0;
    body.name = text();
    body.plane_point[1] = number() - 0.5;
    body.plane_normal[1] = number();
    body.has_friction = next() % 2;
    body.friction = number();
    return body;
  }

  TautResult add_body(TautCloth cloth) {
    const TautMesh given = mesh();
    const TautBody body = some_body(given);
    std::int32_t body_number = 0;
    return taut_add_body(cloth, or_null(body), or_null(body_number));
  }

  TautResult save_or_restore(TautCloth cloth) {
    std::size_t size = 0;
    if (next() % 2 == 0) {
      saved_.resize(std::size_t{1} << 16U);
      const TautResult result = taut_save(cloth, or_null(saved_[0]), saved_.size(), or_null(size));
      saved_.resize(result == TAUT_OK ? size : saved_.size());
      return result;
    }
    if (saved_.empty()) {
      return taut_restore(cloth, nullptr, size);
    }
    if (seldom()) {
      saved_[(next() * 256U + next()) % saved_.size()] ^= 4;
    }
    return taut_restore(cloth, or_null(saved_[0]), seldom() ? saved_.size() / 2 : saved_.size());
  }

  TautResult get_arrays(TautCloth cloth) {
    std::vector<std::uint32_t> whole(4096);
    std::vector<double> real(4096);
    const TautPointsOut out = {or_null(real[0]), count(16), seldom() ? 3U : 24U, type()};
    switch (next() % 6) {
      case 0:
        return taut_get_positions(cloth, or_null(out));
      case 1:
        return taut_get_pins(cloth, or_null(whole[0]), count(next() % 4));
      case 2:
        return taut_get_stretch(cloth, or_null(real[0]), count(16));
      case 3:
        return taut_get_triangles(cloth, or_null(whole[0]), count(54));
      case 4:
        return refuse_to_draw(cloth);
      default:
        return taut_get_edges(cloth, or_null(whole[0]), or_null(real[0]), count(33));
    }
  }

  // A picture takes longer than all other calls, so that one argument is always wrong.
  TautResult refuse_to_draw(TautCloth cloth) {
    std::uint8_t rgb = 0;
    return taut_draw(cloth, next() % 20, 16 + next(), or_null(rgb), count(16));
  }

  TautResult lead(TautCloth cloth) {
    const TautPoints few = points(next() % 4);
    const TautPoints all = points(16);
    switch (next() % 6) {
      case 0:
        return taut_set_pins(cloth, vertices(), count(next() % 4));
      case 1:
        return taut_move_pins(cloth, vertices(), or_null(few));
      case 2:
        return taut_set_forces(cloth, vertices(), or_null(few));
      case 3:
        return taut_move_body(cloth, next() % 4 - 1, or_null(all));
      case 4:
        return taut_place_body(cloth, next() % 4 - 1, or_null(all));
      default:
        return taut_set_positions(cloth, or_null(all));
    }
  }

  TautResult call() {
    TautFrame frame = some<TautFrame>(taut_frame_init);
    TautInfo info = some<TautInfo>(taut_info_init);
    std::uint64_t hash = 0;
    const std::uint8_t which = next() % 16;
    const TautCloth cloth = some_cloth();
    switch (which) {
      case 0:
        return create();
      case 1:
        return seldom() ? taut_destroy(cloth) : list();
      case 2:
        return taut_get_info(cloth, or_null(info));
      case 3:
        return taut_set(cloth, text(), text());
      case 4:
        return taut_set_wind(cloth, number(), number(), number());
      case 5:
        return taut_set_gravity(cloth, number(), number(), number());
      case 6:
        return add_body(cloth);
      case 7:
        return save_or_restore(cloth);
      case 8:
        return taut_state_hash(cloth, or_null(hash));
      case 9:
        return taut_restore_file(cloth, text());
      case 10:
      case 11:
        return get_arrays(cloth);
      case 12:
      case 13:
        return lead(cloth);
      default:
        return taut_step(cloth, or_null(frame));
    }
  }

  std::span<const std::uint8_t> bytes_;
  CallsMade made_;
  std::vector<TautCloth> cloths_;
  std::array<double, 3 * max_points> numbers_ = {};
  std::array<std::uint32_t, max_points> vertices_ = {};
  std::vector<char> saved_;
  const Square square_{4, 0.1};
};

}  // namespace

CallsMade make_any_calls(std::span<const std::uint8_t> bytes) {
  return Calls(bytes).run();
}

}  // namespace taut::test

#include "tailor/model_file.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "app/base/files.hpp"
#include "app/models/file_mesh.hpp"

namespace taut::tailor {
namespace {

constexpr std::int64_t micrometres_per_metre = 1000000;

std::int64_t to_micrometres(double metres) {
  return static_cast<std::int64_t>(std::floor(metres * micrometres_per_metre + 0.5));
}

/// Where the origin of a piece's plane is in the square of texture coordinates, in metres. The origin of
/// front and back is on the fold, a little above the neck; a sleeve's is between its armpits.
Vec2 place_of(PieceKind kind) {
  const double middle = kind == PieceKind::front || kind == PieceKind::left_sleeve ? 0.25 : 0.75;
  const bool is_body = kind == PieceKind::front || kind == PieceKind::back;
  return {middle * metres_per_uv, is_body ? 1.45 : 0.35};
}

std::vector<glm::vec2> texture_coordinates(const Shirt& shirt) {
  std::vector<glm::vec2> corner_uv;
  for (const Panel& panel : shirt.panels) {
    for (const Triangle& t : panel.triangles) {
      for (const Index point : t) {
        corner_uv.emplace_back((place_of(panel.kind) + panel.flat_m[point]) / metres_per_uv);
      }
    }
  }
  return corner_uv;
}

/// The seams walked one after the other; a closed walk does not repeat its first vertex.
Landmark walk(const Shirt& shirt, const std::string& name, const std::vector<std::string>& seams) {
  Landmark landmark = {name, {}};
  for (const std::string& seam_name : seams) {
    for (const Index v : shirt.seam(seam_name).vertices) {
      if (landmark.vertices.empty() || landmark.vertices.back() != v) {
        landmark.vertices.push_back(v);
      }
    }
  }
  if (landmark.vertices.front() == landmark.vertices.back()) {
    landmark.vertices.pop_back();
  }
  return landmark;
}

std::vector<Landmark> find_landmarks(const Shirt& shirt) {
  return {walk(shirt, "left_shoulder_seam", {"left_shoulder_seam"}),
          walk(shirt, "right_shoulder_seam", {"right_shoulder_seam"}),
          walk(shirt, "back_neckline", {"back_neckline"}),
          walk(shirt, "front_neckline", {"front_neckline"}),
          walk(shirt, "hem", {"front_hem", "back_hem"}),
          walk(shirt, "left_cuff", {"left_cuff"}),
          walk(shirt, "right_cuff", {"right_cuff"}),
          walk(shirt, "left_side_seam", {"left_side_seam"}),
          walk(shirt, "right_side_seam", {"right_side_seam"})};
}

std::string landmarks_text(const std::vector<Landmark>& landmarks, const std::string& name) {
  std::ostringstream out;
  out << "# Vertices of " << name << ".obj, counted from 0, in order along each seam or border.\n"
      << "# Left and right are the wearer's. Texture coordinates are the pieces as they are cut, to scale.\n"
      << "metres_per_uv = " << metres_per_uv << '\n';
  for (const Landmark& landmark : landmarks) {
    out << landmark.name << " = [";
    for (std::size_t i = 0; i < landmark.vertices.size(); ++i) {
      out << (i == 0 ? "" : i % 16 == 0 ? ",\n  " : ", ") << landmark.vertices[i];
    }
    out << "]\n";
  }
  return out.str();
}

}  // namespace

Model make_model(const Shirt& shirt, const std::vector<Vec3>& positions) {
  assert(positions.size() == shirt.vertex_count);
  Model model;
  const Index unused = static_cast<Index>(positions.size());
  std::vector<Index> number(positions.size(), unused);
  const auto rounded = [](double metres) {
    return static_cast<double>(to_micrometres(metres)) / static_cast<double>(micrometres_per_metre);
  };
  for (Triangle t : shirt.triangles()) {
    for (Index& v : t) {
      if (number[v] == unused) {
        number[v] = static_cast<Index>(model.mesh.positions.size());
        model.mesh.positions.emplace_back(rounded(positions[v].x), rounded(positions[v].y), rounded(positions[v].z));
      }
      v = number[v];
    }
    model.mesh.triangles.push_back(t);
  }
  model.corner_uv = texture_coordinates(shirt);
  model.landmarks = find_landmarks(shirt);
  for (Landmark& landmark : model.landmarks) {
    for (Index& v : landmark.vertices) {
      v = number[v];
    }
  }
  return model;
}

void write_model(const Model& model, const std::filesystem::path& folder, const std::string& name,
                 const std::string& header) {
  app::write_text_file(folder / (name + ".obj"),
                       app::obj_text(model.mesh, model.mesh.positions, model.corner_uv, header, "{:.6f}"));
  app::write_text_file(folder / (name + ".landmarks.toml"), landmarks_text(model.landmarks, name));
}

}  // namespace taut::tailor

#include "tailor/model_file.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace taut::tailor {
namespace {

constexpr std::int64_t micrometres_per_metre = 1000000;

std::int64_t to_micrometres(double metres) {
  return static_cast<std::int64_t>(std::floor(metres * micrometres_per_metre + 0.5));
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

std::string metres_text(std::int64_t micrometres) {
  const std::int64_t size = micrometres < 0 ? -micrometres : micrometres;
  const std::string decimals = std::to_string(size % micrometres_per_metre);
  std::string text = micrometres < 0 ? "-" : "";
  text += std::to_string(size / micrometres_per_metre);
  text += '.';
  text.append(6 - decimals.size(), '0');
  return text + decimals;
}

std::string obj_text(const sim::Mesh& mesh, const std::string& header) {
  std::ostringstream out;
  out << header;
  for (const Vec3& p : mesh.positions) {
    out << "v " << metres_text(to_micrometres(p.x)) << ' ' << metres_text(to_micrometres(p.y)) << ' '
        << metres_text(to_micrometres(p.z)) << '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return out.str();
}

std::string landmarks_text(const std::vector<Landmark>& landmarks, const std::string& name) {
  std::ostringstream out;
  out << "# Vertices of " << name << ".obj, counted from 0, in order along each seam or border.\n"
      << "# Left and right are the wearer's.\n";
  for (const Landmark& landmark : landmarks) {
    out << landmark.name << " = [";
    for (std::size_t i = 0; i < landmark.vertices.size(); ++i) {
      out << (i == 0 ? "" : i % 16 == 0 ? ",\n  " : ", ") << landmark.vertices[i];
    }
    out << "]\n";
  }
  return out.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path unfinished = file.string() + ".part";
  std::ofstream out(unfinished, std::ios::binary);
  out << text;
  out.close();
  std::error_code failed;
  std::filesystem::rename(unfinished, file, failed);
  if (!out || failed) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
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
        model.mesh.positions.emplace_back(rounded(positions[v].x), rounded(positions[v].y),
                                          rounded(positions[v].z));
      }
      v = number[v];
    }
    model.mesh.triangles.push_back(t);
  }
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
  write_text(folder / (name + ".obj"), obj_text(model.mesh, header));
  write_text(folder / (name + ".landmarks.toml"), landmarks_text(model.landmarks, name));
}

}  // namespace taut::tailor

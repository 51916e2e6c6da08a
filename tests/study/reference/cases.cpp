#include "tests/study/reference/cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace reference {
namespace {

/// Cotton of 0.318 mm with a Young's modulus of 0.821 MPa (Penava, Simic Penava and Knezic 2014), with the bending
/// stiffness of canvas, so that folds are wider than edges.
constexpr Fabric canvas{0.1503, 261.0, 1e-4, 1e-3};
std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Reads the integers of `name = [1, 2, ...]`.
std::vector<int> read_numbers(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\n" + name + " = [");
  if (at == std::string::npos) throw std::runtime_error("found no list " + name);
  const std::size_t from = text.find('[', at) + 1;
  std::string list = text.substr(from, text.find(']', from) - from);
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream words(list);
  std::vector<int> numbers;
  for (int number = 0; words >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace

Surface even_sheet(int across, int rows, double width_m, double length_m) {
  Surface sheet;
  std::vector<int> firsts;
  for (int row = 0; row <= rows; ++row) {
    firsts.push_back(static_cast<int>(sheet.points_m.size()));
    for (int i = 0; i <= across + row % 2; ++i) {
      const double x = std::clamp((i - 0.5 * (row % 2)) / across, 0.0, 1.0) * width_m;
      sheet.points_m.emplace_back(x - 0.5 * width_m, 0.0, (static_cast<double>(row) / rows - 0.5) * length_m);
    }
  }
  for (int row = 0; row < rows; ++row) {
    const int even = firsts[row + row % 2], odd = firsts[row + 1 - row % 2];
    const auto add = [&](int a, int b, int c) {
      sheet.triangles.push_back(row % 2 == 0 ? Corners{a, b, c} : Corners{a, c, b});
    };
    for (int i = 0; i <= across; ++i) add(odd + i, odd + i + 1, even + i);
    for (int i = 0; i < across; ++i) add(even + i + 1, even + i, odd + i + 1);
  }
  return sheet;
}

RestCase shirt(const std::filesystem::path& garments, int triangles) {
  const std::string name = "tshirt_" + std::to_string(triangles);
  const Surface model = read_obj(garments / (name + ".obj"));
  const std::string landmarks = read_text(garments / (name + ".landmarks.toml"));
  std::vector<int> pins;
  for (const char* seam : {"left_shoulder_seam", "right_shoulder_seam", "back_neckline"}) {
    const std::vector<int> vertices = read_numbers(landmarks, seam);
    pins.insert(pins.end(), vertices.begin(), vertices.end());
  }
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
  return {name, {model.points_m, model.triangles, pins, canvas}, model.points_m};
}

RestCase cloth_on_ball(int across, double rigidity_n_m) {
  constexpr double radius_m = 0.25;
  const Surface square = even_sheet(across, static_cast<int>(std::lround(across / std::sqrt(0.75))), 1.0, 1.0);
  RestCase result{"ball_" + std::to_string(across) + "_" + std::to_string(std::lround(1e3 * rigidity_n_m)),
                  {square.points_m, square.triangles, {}, canvas},
                  square.points_m};
  result.cloth.fabric.rigidity_n_m = rigidity_n_m;
  const auto middle =
      std::min_element(square.points_m.begin(), square.points_m.end(),
                       [](const Point& a, const Point& b) { return a.squaredNorm() < b.squaredNorm(); });
  const int first = static_cast<int>(middle - square.points_m.begin());
  result.cloth.pins = {first, first + 1, static_cast<int>(square.points_m.size())};
  result.cloth.ball = result.cloth.pins.back();
  result.cloth.ball_radius_m = radius_m;
  // The ball is off the middle, so that the cloth does not hang alike on all sides.
  const Point ball = *middle + Point(0.02, -radius_m - 1e-3, 0.007);
  result.cloth.rest_m.push_back(ball);
  result.start_m.push_back(ball);
  return result;
}

std::vector<RestCase> kept_cases(const std::filesystem::path& garments) {
  std::vector<RestCase> cases;
  for (const int triangles : kept_shirts) cases.push_back(shirt(garments, triangles));
  for (const double rigidity_n_m : kept_rigidities_n_m) {
    for (const int across : kept_meshes) cases.push_back(cloth_on_ball(across, rigidity_n_m));
  }
  return cases;
}

Vector kept_rest(const RestCase& what, const std::filesystem::path& shapes) {
  const std::filesystem::path file = shapes / (what.name + ".obj");
  const Surface surface = read_obj(file);
  if (surface.points_m.size() != what.start_m.size()) {
    throw std::runtime_error(file.string() + ": found " + std::to_string(surface.points_m.size()) +
                             " vertices, expected " + std::to_string(what.start_m.size()));
  }
  return flatten(surface.points_m);
}

Surface read_obj(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  Surface surface;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Point p;
      if (!(words >> p.x() >> p.y() >> p.z()))
        throw std::runtime_error(file.string() + ": expected 3 coordinates: " + line);
      surface.points_m.push_back(p);
    } else if (kind == "f") {
      Corners corners;
      for (int& corner : corners) {
        std::string word;
        words >> word;
        corner = std::atoi(word.c_str()) - 1;
        if (corner < 0 || corner >= static_cast<int>(surface.points_m.size())) {
          throw std::runtime_error(file.string() + ": expected 3 vertices: " + line);
        }
      }
      surface.triangles.push_back(corners);
    }
  }
  return surface;
}

}  // namespace reference

// Whether written frames keep a bound on stretch, by nothing but their text: shares no code with the program.
//
//   check_written_positions REST.obj BOUND FRAME.obj...
//
// Reading a model may number its vertices anew but keeps its faces in order, so that corner k of face f is
// the same point of the cloth in every file. Rest lengths come from REST.obj, which was never in the program.
// Prints the worst edge of all frames. Exit code 0: every edge of every frame is at most 1 + BOUND times as
// long as in REST.obj; 1: one is longer; 2: the files do not show the same cloth.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Of lengths that are computed here and there from the same decimals.
constexpr double rounding_error = 1e-12;

struct Point {
  double x, y, z;
};

struct Model {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

std::size_t corner_of(const std::string& word, std::size_t point_count, const std::string& file) {
  const long number = std::strtol(word.c_str(), nullptr, 10);
  if (number < 1 || static_cast<std::size_t>(number) > point_count) {
    throw std::runtime_error(file + ": a face names the vertex '" + word + "'");
  }
  return static_cast<std::size_t>(number - 1);
}

Model read_obj(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw std::runtime_error("cannot read " + file);
  }
  Model model;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      std::array<std::string, 3> numbers;
      words >> numbers[0] >> numbers[1] >> numbers[2];
      model.points.push_back({std::strtod(numbers[0].c_str(), nullptr),
                              std::strtod(numbers[1].c_str(), nullptr),
                              std::strtod(numbers[2].c_str(), nullptr)});
    } else if (kind == "f") {
      model.faces.emplace_back();
      for (std::string word; words >> word;) {
        model.faces.back().push_back(corner_of(word, model.points.size(), file));
      }
    }
  }
  if (model.faces.empty()) {
    throw std::runtime_error(file + ": no faces");
  }
  return model;
}

double distance(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

// The faces of both have to join the same vertices under one renumbering.
void require_same_cloth(const Model& rest, const Model& frame, const std::string& file) {
  if (rest.faces.size() != frame.faces.size()) {
    throw std::runtime_error(file + ": " + std::to_string(frame.faces.size()) + " faces, expected " +
                             std::to_string(rest.faces.size()));
  }
  std::map<std::size_t, std::size_t> frame_of, rest_of;
  for (std::size_t f = 0; f < rest.faces.size(); ++f) {
    if (rest.faces[f].size() != frame.faces[f].size()) {
      throw std::runtime_error(file + ": face " + std::to_string(f + 1) + " has other corners");
    }
    for (std::size_t k = 0; k < rest.faces[f].size(); ++k) {
      const std::size_t r = rest.faces[f][k], v = frame.faces[f][k];
      if (frame_of.emplace(r, v).first->second != v || rest_of.emplace(v, r).first->second != r) {
        throw std::runtime_error(file + ": face " + std::to_string(f + 1) + " joins other vertices");
      }
    }
  }
}

double worst_stretch(const Model& rest, const Model& frame) {
  double worst = -1.0;
  for (std::size_t f = 0; f < rest.faces.size(); ++f) {
    const std::vector<std::size_t>& r = rest.faces[f];
    const std::vector<std::size_t>& v = frame.faces[f];
    for (std::size_t k = 0; k < r.size(); ++k) {
      const std::size_t next = (k + 1) % r.size();
      const double length = distance(frame.points[v[k]], frame.points[v[next]]);
      const double stretch = length / distance(rest.points[r[k]], rest.points[r[next]]) - 1.0;
      // Not max: something that is no number has to be noticed.
      worst = stretch <= worst ? worst : stretch;
    }
  }
  return worst;
}

int check(const std::vector<std::string>& arguments) {
  const Model rest = read_obj(arguments[0]);
  const double bound = std::strtod(arguments[1].c_str(), nullptr);
  double worst = -1.0;
  int frames_over = 0;
  for (std::size_t i = 2; i < arguments.size(); ++i) {
    const Model frame = read_obj(arguments[i]);
    require_same_cloth(rest, frame, arguments[i]);
    const double stretch = worst_stretch(rest, frame);
    if (!(stretch <= bound + rounding_error)) {
      std::printf("%s: stretched by %.9f %%\n", arguments[i].c_str(), 100.0 * stretch);
      ++frames_over;
    }
    worst = stretch <= worst ? worst : stretch;
  }
  std::printf("%zu frames, %d over %.9g %%, worst %.9f %%\n", arguments.size() - 2, frames_over,
              100.0 * bound, 100.0 * worst);
  return frames_over == 0 ? 0 : 1;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 4) {
    std::fprintf(stderr, "check_written_positions REST.obj BOUND FRAME.obj...\n");
    return 2;
  }
  try {
    return check({arguments + 1, arguments + argument_count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

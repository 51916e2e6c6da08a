#include "tailor/flat/pattern.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace taut::tailor {
namespace {

constexpr double largest_gap_m = 1e-5;              // what rounding in the file may leave between segments
constexpr double largest_seam_difference_m = 1e-3;  // more would show as a pucker

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

Vec2 read_point(const std::filesystem::path& file, const std::string& field, const toml::node& node) {
  const toml::array* pair = node.as_array();
  const auto x = pair != nullptr && pair->size() == 2 ? (*pair)[0].value<double>() : std::nullopt;
  const auto y = pair != nullptr && pair->size() == 2 ? (*pair)[1].value<double>() : std::nullopt;
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) {
    fail(file, field + " holds something other than pairs of numbers [x, y]");
  }
  return {*x * 1e-3, -*y * 1e-3};
}

std::vector<Vec2> read_line(const std::filesystem::path& file, const toml::table& root,
                            const std::string& segment) {
  const std::string field = segment + ".points_mm";
  const toml::array* points = root.at_path(field).as_array();
  if (points == nullptr || points->size() < 2) {
    fail(file, field + " is missing or shorter than two points");
  }
  std::vector<Vec2> line;
  for (const toml::node& node : *points) {
    line.push_back(read_point(file, field, node));
  }
  return line;
}

void check_joined(const std::filesystem::path& file, const std::string& piece,
                  const std::vector<const std::vector<Vec2>*>& lines) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (glm::length(lines[i]->front() - lines[i - 1]->back()) > largest_gap_m) {
      fail(file, "segment " + std::to_string(i + 1) + " of " + piece + " does not begin where segment " +
                     std::to_string(i) + " ends");
    }
  }
}

void check_seam(const std::filesystem::path& file, const std::string& name, const std::vector<Vec2>& a,
                const std::vector<Vec2>& b) {
  const double difference_m = std::abs(length_of(a) - length_of(b));
  if (difference_m > largest_seam_difference_m) {
    fail(file, "the two sides of the " + name + " differ by " + std::to_string(difference_m * 1e3) +
                   " mm; expected at most " + std::to_string(largest_seam_difference_m * 1e3));
  }
}

HalfBody read_body(const std::filesystem::path& file, const toml::table& root, const std::string& piece) {
  HalfBody body = {read_line(file, root, piece + ".hem"), read_line(file, root, piece + ".side_seam"),
                   read_line(file, root, piece + ".armhole"), read_line(file, root, piece + ".shoulder_seam"),
                   read_line(file, root, piece + ".neckline")};
  check_joined(file, piece, {&body.hem, &body.side_seam, &body.armhole, &body.shoulder_seam, &body.neckline});
  if (std::abs(body.hem.front().x) > largest_gap_m || std::abs(body.neckline.back().x) > largest_gap_m) {
    fail(file, piece + " does not begin and end on its fold, x = 0");
  }
  return body;
}

RightSleeve read_sleeve(const std::filesystem::path& file, const toml::table& root) {
  RightSleeve sleeve = {read_line(file, root, "sleeve.cuff"), read_line(file, root, "sleeve.underarm_front"),
                        read_line(file, root, "sleeve.cap_front"), read_line(file, root, "sleeve.cap_back"),
                        read_line(file, root, "sleeve.underarm_back")};
  check_joined(file, "sleeve",
               {&sleeve.cuff, &sleeve.underarm_front, &sleeve.cap_front, &sleeve.cap_back,
                &sleeve.underarm_back, &sleeve.cuff});
  return sleeve;
}

toml::table parse(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    fail(file, "line " + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
}

}  // namespace

Pattern read_pattern(const std::filesystem::path& file) {
  const toml::table root = parse(file);
  Pattern pattern = {read_body(file, root, "front"),
                     read_body(file, root, "back"),
                     read_sleeve(file, root),
                     root.at_path("source.pattern").value_or(std::string()) + ", " +
                         root.at_path("source.package").value_or(std::string()) + " " +
                         root.at_path("source.version").value_or(std::string()),
                     root.at_path("source.licence").value_or(std::string()),
                     root.at_path("wearer.name").value_or(std::string()),
                     root.at_path("wearer.neck_point_height_m").value_or(0.0)};
  if (!pattern.wearer.empty() && !(pattern.neck_point_height_m > 0.0)) {
    fail(file, "wearer.neck_point_height_m is not above 0");
  }
  const RightSleeve& sleeve = pattern.sleeve;
  check_seam(file, "side seam", pattern.front.side_seam, pattern.back.side_seam);
  check_seam(file, "shoulder seam", pattern.front.shoulder_seam, pattern.back.shoulder_seam);
  check_seam(file, "underarm", sleeve.underarm_front, sleeve.underarm_back);
  check_seam(file, "front armhole", pattern.front.armhole, sleeve.cap_front);
  check_seam(file, "back armhole", pattern.back.armhole, sleeve.cap_back);
  return pattern;
}

}  // namespace taut::tailor

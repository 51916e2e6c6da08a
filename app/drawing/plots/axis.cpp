#include "app/drawing/plots/axis.hpp"

#include <fmt/core.h>

#include "app/drawing/drawing.hpp"
#include "renderer/page/ticks.hpp"

namespace taut::app {
namespace {

void draw_solid(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    canvas.line(points[i - 1].x, points[i - 1].y, points[i].x, points[i].y, stroke.colour, stroke.thickness_px);
  }
  // Segments are stroked one by one: a disc closes the wedge at every corner.
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    canvas.circle(points[i].x, points[i].y, 0.5F * stroke.thickness_px, stroke.colour);
  }
}

// Walks along the line and tells dashes from gaps.
class Dasher {
 public:
  Dasher(const Stroke& stroke, const glm::vec2& start)
      : stroke_(stroke), left_px_(stroke.dashes.front() * stroke.thickness_px) {
    pieces_.push_back({start});
  }

  void go_to(const glm::vec2& a, const glm::vec2& b) {
    const float length = glm::distance(a, b);
    float done = 0.0F;
    while (length - done > left_px_) {
      done += left_px_;
      turn_over(a + (b - a) * (done / length));
    }
    left_px_ -= length - done;
    if (is_dash_) pieces_.back().push_back(b);
  }

  std::vector<std::vector<glm::vec2>> pieces() && {
    std::erase_if(pieces_, [](const auto& piece) { return piece.size() < 2; });
    return std::move(pieces_);
  }

 private:
  void turn_over(const glm::vec2& at) {
    if (is_dash_) {
      pieces_.back().push_back(at);
    } else {
      pieces_.push_back({at});
    }
    is_dash_ = !is_dash_;
    index_ = (index_ + 1) % stroke_.dashes.size();
    left_px_ = stroke_.dashes[index_] * stroke_.thickness_px;
  }

  const Stroke& stroke_;
  std::vector<std::vector<glm::vec2>> pieces_;
  float left_px_;
  std::size_t index_ = 0;
  bool is_dash_ = true;
};

void append_column(std::vector<glm::vec2> column, std::vector<glm::vec2>& result) {
  if (column.size() <= 4) {
    result.insert(result.end(), column.begin(), column.end());
    return;
  }
  const auto [low, high] = std::ranges::minmax_element(column, [](auto& p, auto& q) { return p.y < q.y; });
  result.push_back(column.front());
  result.push_back(*std::min(low, high));
  result.push_back(*std::max(low, high));
  result.push_back(column.back());
}

// With more decades than this, only some ticks have labels, so that labels do not overlap.
constexpr double most_labelled_decades = 8.0;

std::vector<Tick> linear_ticks(const Axis& axis) {
  const double step = renderer::round_step(axis.maximum - axis.minimum);
  std::vector<Tick> ticks;
  for (const double value : renderer::multiples_within(axis.minimum, axis.maximum, step)) {
    ticks.push_back({value, renderer::tick_text(value, step) + axis.suffix});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Axis& axis) {
  const double decades = std::log10(axis.maximum / axis.minimum);
  const int every = static_cast<int>(std::ceil(decades / most_labelled_decades));
  // Powers where digits would have to be counted.
  const bool in_full = axis.minimum >= 0.0099 && axis.maximum <= 10001.0;
  std::vector<Tick> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(axis.minimum) + 1e-9));
       std::pow(10.0, exponent) <= axis.maximum * (1.0 + 1e-9); ++exponent) {
    for (int multiple = 1; multiple <= 9; ++multiple) {
      const double value = multiple * std::pow(10.0, exponent);
      if (value < axis.minimum * (1.0 - 1e-9) || value > axis.maximum * (1.0 + 1e-9)) continue;
      const bool is_labelled =
          decades < 2.0 ? multiple == 1 || multiple == 2 || multiple == 5 : multiple == 1 && exponent % every == 0;
      std::string label;
      if (is_labelled) {
        label = (in_full || decades < 2.0 ? fmt::format("{:g}", value) : power_of_ten(exponent)) + axis.suffix;
      }
      ticks.push_back({value, std::move(label)});
    }
  }
  return ticks;
}

}  // namespace

std::vector<std::vector<glm::vec2>> cut_into_dashes(std::span<const glm::vec2> points, const Stroke& stroke) {
  if (points.size() < 2) return {};
  if (stroke.dashes.empty()) return {{points.begin(), points.end()}};
  Dasher dasher(stroke, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) dasher.go_to(points[i - 1], points[i]);
  return std::move(dasher).pieces();
}

void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke) {
  for (const std::vector<glm::vec2>& piece : cut_into_dashes(points, stroke)) {
    draw_solid(canvas, piece, stroke);
  }
}

std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways) {
  constexpr int pieces = 16;
  const glm::vec2 along = b - a;
  const glm::vec2 across(-along.y, along.x);
  std::vector<glm::vec2> points;
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / pieces;
    points.push_back(a + t * along + 4.0F * t * (1.0F - t) * sideways * across);
  }
  return points;
}

std::vector<glm::vec2> thinned_out(std::span<const glm::vec2> points) {
  std::vector<glm::vec2> result;
  std::vector<glm::vec2> column;
  for (const glm::vec2& point : points) {
    if (!column.empty() && std::floor(point.x) != std::floor(column.front().x)) {
      append_column(std::move(column), result);
      column.clear();
    }
    column.push_back(point);
  }
  append_column(std::move(column), result);
  return result;
}

std::vector<Tick> ticks_of(const Axis& axis) {
  if (!axis.chosen.empty()) {
    std::vector<Tick> ticks;
    for (const double value : axis.chosen) ticks.push_back({value, fmt::format("{:g}", value) + axis.suffix});
    return ticks;
  }
  return axis.logarithmic ? logarithmic_ticks(axis) : linear_ticks(axis);
}

double position_on(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.minimum) / std::log(axis.maximum / axis.minimum);
  return (value - axis.minimum) / (axis.maximum - axis.minimum);
}

Axis decades_around(std::string label, const std::vector<double>& values) {
  double low = INFINITY, high = 0.0;
  for (const double value : values) {
    if (value > 0.0) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (high <= 0.0) low = high = 1.0;
  Axis axis{std::move(label), std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::ceil(std::log10(high))),
            true};
  if (!(axis.maximum > axis.minimum)) axis.maximum = 10.0 * axis.minimum;
  return axis;
}

std::string power_of_ten(int exponent) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) label += raised[digit - '0'];
  return label;
}

std::string scientific(double value) {
  if (!(std::abs(value) > 0.0) || !std::isfinite(value)) return fmt::format("{}", value);
  if (std::abs(value) >= 0.1 && std::abs(value) < 1000.0) return fmt::format("{:.2g}", value);
  const std::string digits = fmt::format("{:.1e}", value);
  const std::size_t e = digits.find('e');
  return digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
}

}  // namespace taut::app

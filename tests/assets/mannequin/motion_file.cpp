#include "mannequin/motion_file.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace taut::test {
namespace {

glm::dmat3 turn(int axis, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  glm::dmat3 result(1.0);  // indexed by column first
  result[next][next] = result[last][last] = std::cos(angle);
  result[next][last] = std::sin(angle);
  result[last][next] = -std::sin(angle);
  return result;
}

struct Header {
  std::vector<std::string> joints;
  std::size_t frames = 0;
};

Header read_hierarchy(std::istream& in, MotionFile& motion) {
  Header header;
  bool in_end_site = false;
  for (std::string word; in >> word && word != "MOTION";) {
    if (word == "ROOT" || word == "JOINT") {
      in >> header.joints.emplace_back();
      in_end_site = false;
    } else if (word == "End") {
      in_end_site = true;
    } else if (word == "OFFSET") {
      sim::Vec3 offset;
      in >> offset.x >> offset.y >> offset.z;
      if (!in_end_site) {
        motion.offsets_m[header.joints.back()] = offset;
      }
    } else if (word == "CHANNELS") {
      std::string channels;
      std::getline(in, channels);
      const std::string turns = "Zrotation Xrotation Yrotation";
      const bool is_root = header.joints.size() == 1;
      if (channels != (is_root ? " 6 Xposition Yposition Zposition " : " 3 ") + turns) {
        throw std::runtime_error("the channels of " + header.joints.back() + " are" + channels);
      }
    }
  }
  std::string frames;
  std::string frame;
  std::string time;
  in >> frames >> header.frames >> frame >> time >> motion.frame_time_s;
  if (frames != "Frames:" || frame != "Frame" || time != "Time:" || !in) {
    throw std::runtime_error("no frames and frame time after the hierarchy");
  }
  return header;
}

}  // namespace

MotionFile read_motion(const std::filesystem::path& file) {
  std::ifstream in(file);
  MotionFile motion;
  const Header header = read_hierarchy(in, motion);
  motion.frames.resize(header.frames);
  for (MotionFrame& frame : motion.frames) {
    in >> frame.root_m.x >> frame.root_m.y >> frame.root_m.z;
    for (const std::string& joint : header.joints) {
      double z = 0.0;
      double x = 0.0;
      double y = 0.0;
      in >> z >> x >> y;
      frame.turns[joint] = turn(2, z) * turn(0, x) * turn(1, y);
    }
  }
  std::string more;
  if (!in || in >> more) {
    throw std::runtime_error(file.string() + " holds fewer or more numbers than its frames need");
  }
  return motion;
}

std::vector<sim::Vec3> pose_body(const BodyFile& body, const MotionFile& motion, std::size_t frame) {
  const MotionFrame& now = motion.frames.at(frame);
  const sim::Vec3 first_m = motion.frames.front().root_m;
  std::vector<glm::dmat3> turns;
  std::vector<sim::Vec3> places;
  for (std::size_t j = 0; j < body.names.size(); ++j) {
    const glm::dmat3& own = now.turns.at(body.names[j]);
    if (body.parents[j] < 0) {
      turns.push_back(own);
      places.push_back(body.places[j] + (now.root_m - first_m) * (body.places[j].y / first_m.y));
    } else {
      const auto parent = static_cast<std::size_t>(body.parents[j]);
      turns.push_back(turns[parent] * own);
      places.push_back(places[parent] + turns[parent] * (body.places[j] - body.places[parent]));
    }
  }
  std::vector<sim::Vec3> result;
  for (std::size_t v = 0; v < body.mesh.positions.size(); ++v) {
    sim::Vec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = body.joints[v][i];
      sum += static_cast<double>(body.weights[v][i]) *
             (places[j] + turns[j] * (body.mesh.positions[v] - body.places[j]));
    }
    result.push_back(sum);
  }
  return result;
}

}  // namespace taut::test

#include "garment_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

namespace taut::test {
namespace {

using Node = std::pair<int, int>;

/// One sheet: the grid's squares in the region, and the number of squares that meet at each node.
struct Sheet {
  std::vector<Node> squares;
  std::map<Node, int> squares_at;

  Sheet(const Region& region, double cell_m) {
    for (int column = -60; column < 60; ++column) {
      for (int row = -60; row < 60; ++row) {
        if (region((column + 0.5) * cell_m, (row + 0.5) * cell_m)) {
          squares.emplace_back(column, row);
          for (const Node& corner : {Node{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            ++squares_at[{column + corner.first, row + corner.second}];
          }
        }
      }
    }
  }
  bool ends_at(const Node& node) const {
    const auto found = squares_at.find(node);
    return found != squares_at.end() && found->second < 4;
  }
};

/// Bulge of a sheet at a node: 0 where both sheets end, 1 at four or more rings of squares from there.
double bulge(const Sheet& sheet, const Node& node, const Sheet& other) {
  for (int ring = 0; ring < 4; ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      for (int k = -ring; k <= ring; ++k) {
        const Node near{node.first + i, node.second + k};
        if (sheet.ends_at(near) && other.ends_at(near)) {
          return std::sqrt(ring / 4.0);
        }
      }
    }
  }
  return 1.0;
}

void add_sheet(const Cut& cut, const Sheet& sheet, const Sheet& other, bool is_front,
               std::map<Node, sim::Index>& shared, sim::Mesh& mesh) {
  std::map<Node, sim::Index> own;
  const auto vertex = [&](const Node& node) {
    const double x_m = node.first * cut.cell_m, y_m = node.second * cut.cell_m;
    const bool meets = sheet.ends_at(node) && other.ends_at(node);
    std::map<Node, sim::Index>& vertices = meets && !cut.open(x_m, y_m) ? shared : own;
    const auto [found, is_new] = vertices.try_emplace(node, static_cast<sim::Index>(mesh.positions.size()));
    if (is_new) {
      const double half_m = 0.5 * cut.depth_m * (&vertices == &shared ? 0.0 : std::max(0.2, bulge(sheet, node, other)));
      mesh.positions.emplace_back(x_m, y_m, is_front ? half_m : -half_m);
    }
    return found->second;
  };
  for (const auto& [column, row] : sheet.squares) {
    const sim::Index a = vertex({column, row}), b = vertex({column + 1, row});
    const sim::Index c = vertex({column + 1, row + 1}), d = vertex({column, row + 1});
    if (is_front) {
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
    }
  }
}

bool in_box(double x, double y, double left, double right, double bottom, double top) {
  return x > left && x < right && y > bottom && y < top;
}

bool in_shirt(double x, double y) {
  return in_box(x, y, -0.24, 0.24, 0.0, 0.72) || in_box(x, y, -0.45, 0.45, 0.54, 0.72);
}

bool open_in_shirt(double x, double y) { return y < 0.01 || std::abs(x) > 0.44 || (std::abs(x) < 0.08 && y > 0.71); }

/// A tube of rings of vertices; `place` maps the number of a ring and an angle to a position.
sim::Mesh tube(int rings, int around, const std::function<sim::Vec3(int ring, double angle)>& place) {
  sim::Mesh mesh;
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      mesh.positions.push_back(place(ring, 2.0 * std::numbers::pi * k / around));
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const auto a = static_cast<sim::Index>(ring * around + k);
      const auto b = static_cast<sim::Index>(ring * around + (k + 1) % around);
      const auto up = static_cast<sim::Index>(around);
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + up}, {a, b + up, a + up}});
    }
  }
  return mesh;
}

sim::Vec3 around_y(double radius_m, double angle, double y_m) {
  return {radius_m * std::sin(angle), y_m, radius_m * std::cos(angle)};
}

}  // namespace

sim::Mesh sewn(const Cut& cut) {
  const Sheet front(cut.front, cut.cell_m), back(cut.back, cut.cell_m);
  std::map<Node, sim::Index> shared;
  sim::Mesh mesh;
  add_sheet(cut, front, back, true, shared, mesh);
  add_sheet(cut, back, front, false, shared, mesh);
  return mesh;
}

sim::Mesh shirt() {
  const auto front = [](double x, double y) { return in_shirt(x, y) && !in_box(x, y, -0.09, 0.09, 0.63, 0.8); };
  return sewn({.front = front, .back = in_shirt, .open = open_in_shirt});
}

sim::Mesh shirt_with_gap() {
  const auto front = [](double x, double y) { return in_shirt(x, y) && !in_box(x, y, -0.09, 0.09, 0.63, 0.8); };
  const auto open = [](double x, double y) { return open_in_shirt(x, y) || in_box(x, y, 0.13, 0.28, 0.71, 0.8); };
  return sewn({.front = front, .back = in_shirt, .open = open});
}

sim::Mesh jacket(double hem_m) {
  const auto back = [hem_m](double x, double y) { return in_shirt(x, y) || in_box(x, y, -hem_m, hem_m, 0.0, 0.12); };
  const auto front = [&](double x, double y) { return back(x, y) && std::abs(x) > 0.03; };
  const auto open = [](double x, double y) { return open_in_shirt(x, y) && (y < 0.01 || y > 0.5); };
  return sewn({.front = front, .back = back, .open = open});
}

sim::Mesh raised_sleeve() {
  const auto body = [](double x, double y) { return in_shirt(x, y) || in_box(x, y, 0.33, 0.45, 0.54, 0.9); };
  const auto open = [](double x, double y) { return y < 0.01 || x < -0.44 || y > 0.89; };
  return sewn({.front = body, .back = body, .open = open});
}

sim::Mesh strap_dress(double neckline_m) {
  const auto body = [neckline_m](double x, double y) {
    return in_box(x, y, -0.21, 0.21, 0.0, neckline_m) || in_box(std::abs(x), y, 0.09, 0.21, 0.0, 0.69) ||
           in_box(std::abs(x), y, 0.09, 0.15, 0.0, 0.9);
  };
  const auto open = [neckline_m](double x, double y) {
    return y < 0.01 || (y < 0.89 && y > (std::abs(x) < 0.1 ? neckline_m - 0.01 : 0.68));
  };
  return sewn({.front = body, .back = body, .open = open});
}

sim::Mesh hoodie(double top_m, double face_from_m, double shoulders_m) {
  const auto back = [=](double x, double y) {
    return (in_shirt(x, y) && std::abs(x) < shoulders_m) || in_box(x, y, -0.15, 0.15, 0.6, top_m);
  };
  const auto front = [=](double x, double y) {
    return back(x, y) && !in_box(x, y, -0.09, 0.09, face_from_m, top_m - 0.06);
  };
  const auto open = [=](double x, double y) { return y < 0.01 || std::abs(x) > std::min(0.44, shoulders_m - 0.01); };
  return sewn({.front = front, .back = back, .open = open, .depth_m = 0.2});
}

sim::Mesh trousers() {
  const auto body = [](double x, double y) {
    return in_box(std::abs(x), y, 0.03, 0.21, 0.0, 0.9) || in_box(x, y, -0.21, 0.21, 0.6, 0.9);
  };
  return sewn({.front = body, .back = body, .open = [](double, double y) { return y < 0.01 || y > 0.89; }});
}

sim::Mesh skirt() {
  return tube(12, 24, [](int ring, double angle) { return around_y(0.3 - 0.015 * ring, angle, 0.05 * ring); });
}

sim::Mesh circle_skirt(double wave_m) {
  return tube(12, 32, [wave_m](int ring, double angle) {
    return around_y(0.7 - 0.05 * ring, angle, 0.5 * wave_m * std::cos(4.0 * angle));
  });
}

sim::Mesh bottle(double height_m, const Neck& neck) {
  return tube(12, 24, [&](int ring, double angle) {
    return ring < 11 ? around_y(0.2, angle, 0.1 * ring * height_m)
                     : sim::Vec3(neck.off_x_m + neck.half_x_m * std::sin(angle), height_m,
                                 neck.off_z_m + neck.half_z_m * std::cos(angle));
  });
}

sim::Mesh cape() {
  sim::Mesh mesh = tube(14, 24, [](int ring, double angle) {
    return around_y(ring < 10 ? 0.35 - 0.01 * ring : 0.26 - 0.05 * (ring - 9), angle,
                    0.08 * std::min(ring, 10) + 0.02 * std::max(ring - 10, 0));
  });
  // The cape is open in front, at the angle 0.
  std::erase_if(mesh.triangles, [](const sim::Triangle& t) { return t[0] % 24 == 0; });
  return mesh;
}

sim::Mesh lined_bell(double lining_from) {
  constexpr int rings = 11, lining = 4;
  const sim::Index around = 24;
  sim::Mesh mesh = tube(rings + lining, around, [&](int ring, double angle) {
    return ring < rings ? around_y(0.25, angle, 0.08 * ring)
                        : around_y(0.2, angle, 0.8 * (1.0 - (1.0 - lining_from) * (ring - rings + 1) / lining));
  });
  const auto top = static_cast<sim::Index>(mesh.positions.size());
  mesh.positions.emplace_back(0.0, 0.81, 0.0);
  for (sim::Index k = 0; k < around; ++k) {
    mesh.triangles.push_back({(rings - 1) * around + k, (rings - 1) * around + (k + 1) % around, top});
  }
  return mesh;
}

sim::Mesh panels(int count, double gap_m) {
  sim::Mesh all;
  for (int p = 0; p < count; ++p) {
    const double begin = 2.0 * std::numbers::pi * p / count, step = 2.0 * std::numbers::pi / count;
    sim::Mesh panel;
    for (sim::Index row = 0; row < 7; ++row) {
      for (sim::Index column = 0; column < 4; ++column) {
        const double gap = gap_m / 0.3;
        const double angle = begin + 0.5 * gap + (step - gap) * column / 3.0;
        panel.positions.push_back(around_y(0.3, angle, 0.1 * row));
      }
    }
    for (sim::Index row = 0; row < 6; ++row) {
      for (sim::Index column = 0; column < 3; ++column) {
        const sim::Index a = 4 * row + column;
        panel.triangles.insert(panel.triangles.end(), {{a, a + 1, a + 5}, {a, a + 5, a + 4}});
      }
    }
    all = both(all, panel);
  }
  return all;
}

sim::Mesh thick(const sim::Mesh& mesh, double thickness_m) {
  const auto count = static_cast<sim::Index>(mesh.positions.size());
  std::vector<sim::Vec3> normals(count, sim::Vec3(0.0));
  std::map<std::pair<sim::Index, sim::Index>, int> edges;
  for (const sim::Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      normals[t[k]] += sim::doubled_area_vector(mesh.positions, t);
      ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  sim::Mesh shell = mesh;
  for (sim::Index v = 0; v < count; ++v) {
    shell.positions.push_back(mesh.positions[v] - thickness_m * normals[v] / glm::length(normals[v]));
  }
  for (const sim::Triangle& t : mesh.triangles) {
    shell.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
    for (int k = 0; k < 3; ++k) {
      const sim::Index a = t[k], b = t[(k + 1) % 3];
      if (edges[std::minmax(a, b)] == 1) {
        shell.triangles.insert(shell.triangles.end(), {{b, a, a + count}, {b, a + count, b + count}});
      }
    }
  }
  return shell;
}

sim::Mesh dress_with_wide_skirt(double hem_m) {
  const auto body = [hem_m](double x, double y) {
    const double half_m = y > 0.75 ? 0.18 : std::min(hem_m, 0.18 + (0.75 - y) * 4.0);
    return (std::abs(x) < half_m && y > 0.0 && y < 1.05) || in_box(std::abs(x), y, 0.08, 0.14, 0.0, 1.2);
  };
  const auto open = [](double x, double y) {
    return y < 0.01 || (y > 1.04 && y < 1.19) || (std::abs(x) > 0.14 && y > 0.9);
  };
  return sewn({.front = body, .back = body, .open = open});
}

sim::Mesh split_tube(double gap_m) {
  sim::Mesh mesh;
  for (sim::Index ring = 0; ring < 16; ++ring) {
    for (sim::Index k = 0; k < 25; ++k) {
      const double gap = gap_m / 0.2, angle = 0.5 * gap + (2.0 * std::numbers::pi - gap) * k / 24.0;
      mesh.positions.push_back(around_y(0.2, angle, 0.05 * ring));
    }
  }
  for (sim::Index ring = 0; ring < 15; ++ring) {
    for (sim::Index k = 0; k < 24; ++k) {
      const sim::Index a = 25 * ring + k;
      mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, a + 26}, {a, a + 26, a + 25}});
    }
  }
  return mesh;
}

sim::Mesh both(const sim::Mesh& a, const sim::Mesh& b) {
  sim::Mesh mesh = a;
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  for (sim::Triangle t : b.triangles) {
    for (sim::Index& v : t) {
      v += static_cast<sim::Index>(a.positions.size());
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

sim::Mesh translate(sim::Mesh mesh, const sim::Vec3& by_m) {
  for (sim::Vec3& p : mesh.positions) {
    p += by_m;
  }
  return mesh;
}

sim::Mesh button(const sim::Vec3& at_m, double radius_m) {
  sim::Mesh disc{{at_m}, {}, {}};
  for (sim::Index k = 0; k < 8; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 8;
    disc.positions.push_back(at_m + radius_m * sim::Vec3(std::cos(angle), std::sin(angle), 0.0));
    disc.triangles.push_back({0, k + 1, (k + 1) % 8 + 1});
  }
  return disc;
}

sim::Mesh inside_out(sim::Mesh mesh) {
  for (sim::Triangle& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

sim::Mesh turned_down(double until_m) {
  return tube(22, 24, [until_m](int ring, double angle) {
    return ring < 11 ? around_y(0.2, angle, 0.05 * ring)
                     : around_y(0.22, angle, 0.5 - (0.5 - until_m) * (ring - 11) / 10.0);
  });
}

sim::Mesh with_z_up(sim::Mesh mesh) {
  for (sim::Vec3& p : mesh.positions) {
    p = {p.x, -p.z, p.y};
  }
  return mesh;
}

sim::Mesh laid_flat(sim::Mesh mesh) {
  for (sim::Vec3& p : mesh.positions) {
    p = {p.x, 0.1 * p.z, -p.y};
  }
  return mesh;
}

}  // namespace taut::test

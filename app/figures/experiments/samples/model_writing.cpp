#include "app/figures/experiments/samples/model_writing.hpp"

#include <fmt/core.h>

#include <span>
#include <stdexcept>

namespace taut::app {
namespace {

using Face = std::span<const sim::Index>;

std::string points_text(const ModelArrays& model, const char* begin, const char* between, const char* end,
                        double units_per_metre = 1.0) {
  std::string text;
  for (const sim::Vec3& p : model.positions) {
    text += fmt::format("{0}{3:.9g}{1}{4:.9g}{1}{5:.9g}{2}", begin, between, end, units_per_metre * p.x,
                        units_per_metre * p.y, units_per_metre * p.z);
  }
  return text;
}

template <class Writer>
std::string faces_text(const ModelArrays& model, const Writer& face_text) {
  std::string text;
  const sim::Index* corners = model.corners.data();
  for (const std::uint32_t count : model.corner_counts) {
    text += face_text(Face(corners, count));
    corners += count;
  }
  return text;
}

std::string numbers_text(Face face, sim::Index first_number = 0) {
  std::string text;
  for (const sim::Index corner : face) {
    text += fmt::format(" {}", corner + first_number);
  }
  return text;
}

std::string counted_face(Face face) {
  return fmt::format("{}{}\n", face.size(), numbers_text(face));
}

// Not obj_writing.hpp, which writes meshes: of what all six formats share, OBJ needs these three lines more.
std::string obj_text(const ModelArrays& model) {
  return points_text(model, "v ", " ", "\n") +
         faces_text(model, [](Face face) { return fmt::format("f{}\n", numbers_text(face, 1)); });
}

std::string off_text(const ModelArrays& model) {
  return fmt::format("OFF\n{} {} 0\n", model.positions.size(), model.corner_counts.size()) +
         points_text(model, "", " ", "\n") + faces_text(model, counted_face);
}

std::string ply_text(const ModelArrays& model) {
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
             "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
             model.positions.size(), model.corner_counts.size()) +
         points_text(model, "", " ", "\n") + faces_text(model, counted_face);
}

// Triangles alone, each with points of its own.
std::string stl_text(const ModelArrays& model) {
  const auto triangle_text = [&](Face face) {
    std::string text = " facet normal 0 0 0\n  outer loop\n";
    for (const sim::Index corner : face) {
      const sim::Vec3& p = model.positions[corner];
      text += fmt::format("   vertex {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    }
    return text + "  endloop\n endfacet\n";
  };
  return fmt::format("solid garment\n{}endsolid garment\n", faces_text(model, triangle_text));
}

std::string dae_text(const ModelArrays& model) {
  const std::string counts = faces_text(model, [](Face face) { return fmt::format("{} ", face.size()); });
  return fmt::format(
      R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="{0}">{1}</float_array><technique_common>
<accessor source="#a" count="{2}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="{3}"><input semantic="VERTEX" source="#v" offset="0"/><vcount>{4}</vcount><p>{5}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)",
      3 * model.positions.size(), points_text(model, "", " ", " "), model.positions.size(),
      model.corner_counts.size(), counts, numbers_text(model.corners));
}

// In centimetres. The last corner of a face is written as -1 - its number.
std::string fbx_text(const ModelArrays& model) {
  std::string points = points_text(model, "", ",", ",", 100.0);
  points.pop_back();
  std::string corners = faces_text(model, [](Face face) {
    std::string text;
    for (const sim::Index corner : face.first(face.size() - 1)) {
      text += fmt::format("{},", corner);
    }
    return text + fmt::format("-{},", face.back() + 1);
  });
  corners.pop_back();
  return fmt::format(R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {{
  FBXVersion: 7400
}}
GlobalSettings:  {{
  Properties70:  {{
    P: "UpAxis", "int", "Integer", "",1
    P: "UpAxisSign", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",1
  }}
}}
Objects:  {{
  Geometry: 100, "Geometry::garment", "Mesh" {{
    Vertices: *{} {{
      a: {}
    }}
    PolygonVertexIndex: *{} {{
      a: {}
    }}
  }}
  Model: 200, "Model::garment", "Mesh" {{
    Version: 232
  }}
}}
Connections:  {{
  C: "OO",200,0
  C: "OO",100,200
}}
)",
                     3 * model.positions.size(), points, model.corners.size(), corners);
}

}  // namespace

std::string model_text(const ModelArrays& model, const std::string& format) {
  if (format == "dae") {
    return dae_text(model);
  }
  if (format == "fbx") {
    return fbx_text(model);
  }
  if (format == "obj") {
    return obj_text(model);
  }
  if (format == "off") {
    return off_text(model);
  }
  if (format == "ply") {
    return ply_text(model);
  }
  if (format == "stl") {
    return stl_text(model);
  }
  throw std::invalid_argument("no model can be written as " + format);
}

}  // namespace taut::app

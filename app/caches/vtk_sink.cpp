#include <pugixml.hpp>

#include "app/base/words.hpp"
#include "app/caches/frame_sink.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

/// An array as VTK's XML has it: in base64, how many bytes and then these.
template <class Numbers>
std::string data_array(const std::string& name, const Numbers& numbers, const std::string& attributes = "") {
  using Number = typename Numbers::value_type;
  sim::ByteWriter out;
  out.put(static_cast<std::uint64_t>(numbers.size() * sizeof(Number)));
  for (const Number number : numbers) out.put(number);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(out.bytes().data()), out.bytes().size());
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">{}</DataArray>\n",
                     std::is_same_v<Number, double> ? "Float64" : "Int64", name, attributes, base64(bytes));
}

std::string field(const std::string& name, double value) {
  return data_array(name, std::array{value}, " NumberOfTuples=\"1\"");
}

/// The shape's own measures: not a number where the solver has none.
std::string fields_text(const WrittenMoment& moment) {
  const double distance_m = moment.report.contact.smallest_distance_m;
  return "<FieldData>\n" + field("TimeValue", moment.state.time_s) +
         field("smallest_distance", std::isfinite(distance_m) ? distance_m : std::numeric_limits<double>::quiet_NaN()) +
         "</FieldData>\n";
}

std::string polygons_text(const std::vector<sim::Triangle>& triangles) {
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> ends;
  for (const sim::Triangle& t : triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }
  return "<Polys>\n" + data_array("connectivity", corners) + data_array("offsets", ends) + "</Polys>\n";
}

std::string vtp_text(const WrittenMoment& moment) {
  const sim::Garment& garment = moment.garment;
  const std::vector<sim::Vec3>& positions_m = moment.state.current;
  std::vector<double> coordinates;
  for (const sim::Vec3& p : positions_m) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         "<PolyData>\n" +
         fields_text(moment) +
         fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n", positions_m.size(),
                     garment.mesh.triangles.size()) +
         "<PointData Scalars=\"stretch\">\n" +
         data_array("stretch", sim::vertex_surface_stretch(garment, positions_m)) +
         "</PointData>\n<CellData Scalars=\"stretch\">\n" +
         data_array("stretch", sim::triangle_surface_stretch(garment, positions_m)) + "</CellData>\n<Points>\n" +
         data_array("Points", coordinates, " NumberOfComponents=\"3\"") + "</Points>\n" +
         polygons_text(garment.mesh.triangles) + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

class VtkSink final : public FrameSink {
 public:
  explicit VtkSink(const ExportSettings& settings)
      : settings_(settings), last_(settings.last_kept.value_or(settings.frames.first - 1)) {}

  void write(int frame, const WrittenMoment& moment) override {
    if (settings_.frames.contains(frame)) {
      write_text_file(vtp_beside(settings_.name, frame), vtp_text(moment));
      last_ = frame;
    }
  }

  std::string finish() override {
    const fs::path name = settings_.name;
    const int frames = std::max(last_ - settings_.frames.first + 1, 0);
    if (frames == 0) return "wrote nothing";
    write_text_file(name, collection_text());
    return fmt::format("wrote {}, {} in {}", name.string(), counted(static_cast<std::size_t>(frames), "frame"),
                       vtp_beside(name, 0).parent_path().string());
  }

 private:
  std::string collection_text() const {
    pugi::xml_document document;
    pugi::xml_node file = document.append_child("VTKFile");
    file.append_attribute("type") = "Collection";
    file.append_attribute("version") = "1.0";
    pugi::xml_node collection = file.append_child("Collection");
    for (int frame = settings_.frames.first; frame <= last_; ++frame) {
      const fs::path path = vtp_beside(settings_.name, frame);
      pugi::xml_node entry = collection.append_child("DataSet");
      entry.append_attribute("timestep") = fmt::format("{}", frame / settings_.frame_rate_hz).c_str();
      entry.append_attribute("file") = (path.parent_path().filename() / path.filename()).c_str();
    }
    std::ostringstream text;
    document.save(text);
    return text.str();
  }

  ExportSettings settings_;
  int last_;  ///< frame that was written
};

}  // namespace

fs::path vtp_beside(const fs::path& collection, int frame) {
  const fs::path folder = fs::path(collection).replace_extension("");
  return folder / fmt::format("{}_{:04}.vtp", folder.filename().string(), frame);
}

std::unique_ptr<FrameSink> make_vtk_sink(const ExportSettings& settings) { return std::make_unique<VtkSink>(settings); }

}  // namespace taut::app

#include <numeric>

#include "app/base/files.hpp"
#include "app/caches/sinks.hpp"
#include "app/caches/written_cloth.hpp"

namespace taut::app {
namespace {

class ObjSink final : public FrameSink {
 public:
  ObjSink(const ExportSettings& settings, const GarmentInScene& loaded)
      : pattern_(settings.name, ".obj"), range_(settings.frames), cloth_(loaded) {
    range_.first = pattern_.has_field() ? range_.first : range_.last;
    last_ = settings.last_kept.value_or(range_.first - 1);
  }

  void write(int frame, const WrittenMoment& moment) override {
    if (range_.contains(frame)) {
      write_text_file(pattern_.path_of(frame), cloth_.obj(moment.state.current));
      last_ = frame;
    }
  }

  std::string finish() override {
    std::vector<int> frames(static_cast<std::size_t>(std::max(last_ - range_.first + 1, 0)));
    std::iota(frames.begin(), frames.end(), range_.first);
    return describe_written(pattern_, frames);
  }

 private:
  OutputPattern pattern_;
  FrameRange range_;
  WrittenCloth cloth_;
  int last_ = 0;  ///< frame that was written
};

}  // namespace

std::unique_ptr<FrameSink> make_obj_sink(const ExportSettings& settings, const GarmentInScene& loaded) {
  return std::make_unique<ObjSink>(settings, loaded);
}

}  // namespace taut::app

#include "app/output/video_writer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

// How ffmpeg writes the kinds of video. GIF and WebP are for pages that show pictures alone: they play for ever, GIF at
// 25 pictures a second, as its delays are hundredths of a second, and with the best 256 colours of the video. The
// options of MP4 keep date and library version out of the file, so that equal pictures give equal files.
struct VideoKind {
  std::string_view ending;
  std::string_view options;
};
constexpr std::array video_kinds = {
    VideoKind{".mp4",
              "-c:v libx264 -preset {} -crf 18 -pix_fmt yuv420p -colorspace bt709 -vf scale=out_color_matrix=bt709 "
              "-color_primaries bt709 -color_trc iec61966-2-1 -movflags +faststart -f mp4"},
    VideoKind{".gif",
              "-vf fps=25,split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=3 "
              "-loop 0 -f gif"},
    VideoKind{".webp", "-c:v libwebp_anim -quality 80 -loop 0 -f webp"}};

const VideoKind* find_kind(const fs::path& file) {
  const auto* const kind = std::ranges::find(video_kinds, file.extension().string(), &VideoKind::ending);
  return kind == video_kinds.end() ? nullptr : kind;
}

std::vector<std::string> ffmpeg_arguments(const fs::path& file, const fs::path& temporary,
                                          const VideoSettings& settings) {
  const std::string options =
      fmt::format(fmt::runtime(find_kind(file)->options), settings.is_live ? "veryfast" : "medium");
  std::istringstream words(
      fmt::format("ffmpeg -nostdin -hide_banner -loglevel error -y "
                  "-f rawvideo -pix_fmt rgb24 -video_size {}x{} -framerate {} -i pipe:0 {} "
                  "-fflags +bitexact -flags:v +bitexact",
                  settings.width_px, settings.height_px, settings.frame_rate_hz, options));
  std::vector<std::string> arguments(std::istream_iterator<std::string>(words), {});
  arguments.push_back("file:" + temporary.string());
  return arguments;
}

}  // namespace

bool is_video(const fs::path& file) { return find_kind(file) != nullptr; }

void require_video_size(const fs::path& file, const VideoSettings& settings) {
  if (file.extension() != ".mp4") return;
  const bool is_even = settings.width_px % 2 == 0 && settings.height_px % 2 == 0;
  if (!is_even) {
    throw UsageError("output '{}': an MP4 needs an even width and height, found {} x {}; choose another --resolution",
                     file.string(), settings.width_px, settings.height_px);
  }
}

VideoWriter::VideoWriter(fs::path file, const VideoSettings& settings)
    : file_(std::move(file)),
      temporary_(temporary_name(file_)),
      picture_bytes_(static_cast<std::size_t>(settings.width_px) * 3U * static_cast<std::size_t>(settings.height_px)),
      is_live_(settings.is_live) {
  assert(is_video(file_));
  require_video_size(file_, settings);
  // A socket instead of a pipe: only writing to a socket can be told not to raise SIGPIPE after ffmpeg has ended.
  std::array<int, 2> ends{};
  messages_ = Descriptor(memfd_create("ffmpeg messages", MFD_CLOEXEC));
  if (messages_.number() < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw InputError("cannot start ffmpeg: " + std::generic_category().message(errno));
  }
  input_ = Descriptor(ends[0]);
  const Descriptor its_input(ends[1]);
  create_file(temporary_, file_);
  try {
    ffmpeg_.emplace(ChildCommand{.arguments = ffmpeg_arguments(file_, temporary_, settings),
                                 .input = its_input.number(),
                                 .output = messages_.number(),
                                 .errors = messages_.number(),
                                 .own_group = true});
  } catch (const std::system_error& error) {
    fs::remove(temporary_);
    throw InputError("cannot make '" + file_.string() + "': the program ffmpeg does not start (" +
                     error.code().message() + "); install it, or write pictures such as frame_{frame:04}.png");
  }
}

VideoWriter::~VideoWriter() {
  ffmpeg_.reset();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void VideoWriter::add(const renderer::Image& picture) {
  if (picture.channels != 3 || picture.pixels.size() != picture_bytes_) {
    throw std::invalid_argument("video: a picture has another size than the video");
  }
  send(picture.pixels);
  ++frames_;
}

void VideoWriter::stop_if_interrupted() const {
  if (!is_live_) throw_if_interrupted();
}

void VideoWriter::send(std::span<const std::uint8_t> bytes) {
  constexpr int look_up_after_ms = 100;
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      stop_if_interrupted();
      pollfd room{input_.number(), POLLOUT, 0};
      ::poll(&room, 1, look_up_after_ms);
    } else if (errno != EINTR) {
      fail("stopped", wait_for_end());
    }
  }
}

void VideoWriter::finish() {
  // ffmpeg exits with 0 even after "Error writing trailer", as on a full disk. Its log has only errors.
  const int status = wait_for_end();
  if (status != 0 || !last_message().empty() || fs::file_size(temporary_) == 0) fail("failed", status);
  rename_complete(temporary_, file_);
}

void VideoWriter::fail(const char* how, int status) const {
  throw InputError("cannot make '{}': ffmpeg {} with {} after {}{}", file_.string(), how, describe_end(status),
                   count_text(frames_, "frame"), last_message());
}

// Closes the input, after which ffmpeg finishes and ends.
int VideoWriter::wait_for_end() {
  input_ = Descriptor();
  constexpr int look_again_after_ms = 5;
  while (!ffmpeg_->has_ended()) {
    stop_if_interrupted();
    ::poll(nullptr, 0, look_again_after_ms);
  }
  return ffmpeg_->wait();
}

// Returns the end of ffmpeg's log, whose last message gives the reason of a failure.
std::string VideoWriter::last_message() const {
  constexpr std::size_t max_message_bytes = 400;
  const off_t size = ::lseek(messages_.number(), 0, SEEK_END);
  std::string text(max_message_bytes, '\0');
  const ssize_t count =
      ::pread(messages_.number(), text.data(), max_message_bytes, std::max<off_t>(0, size - off_t{max_message_bytes}));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "" : ": " + text;
}

}  // namespace taut::app

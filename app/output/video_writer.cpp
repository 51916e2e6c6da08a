#include "app/output/video_writer.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <system_error>
#include <utility>
#include <vector>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

// Frames of a GIF last whole hundredths of a second. Viewers slow down frames of less than two hundredths.
constexpr double fastest_gif_hz = 50.0;

bool is_gif(const fs::path& file) {
  return file.extension() == ".gif";
}

int pictures_for_a_frame(const fs::path& file, double frame_rate_hz) {
  return is_gif(file) ? static_cast<int>(std::ceil(frame_rate_hz / fastest_gif_hz)) : 1;
}

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

// The colours of a GIF are chosen after all frames were seen, which holds them in memory.
std::vector<std::string> gif_arguments() {
  return {"-filter_complex", "[0:v]split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"};
}

std::vector<std::string> mp4_arguments(bool is_live) {
  return {"-c:v",
          "libx264",
          "-preset",
          is_live ? "veryfast" : "medium",
          "-crf",
          "18",
          "-pix_fmt",
          "yuv420p",
          "-colorspace",
          "bt709",
          "-vf",
          "scale=out_color_matrix=bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "iec61966-2-1",
          "-movflags",
          "+faststart",
          "-f",
          "mp4"};
}

std::vector<std::string> ffmpeg_arguments(const fs::path& file, const fs::path& temporary,
                                          const VideoSettings& settings) {
  std::vector<std::string> arguments = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y"};
  const std::vector<std::string> input = {
      "-f",
      "rawvideo",
      "-pix_fmt",
      "rgb24",
      "-video_size",
      fmt::format("{}x{}", settings.width_px, settings.height_px),
      "-framerate",
      fmt::format("{}", settings.frame_rate_hz / pictures_for_a_frame(file, settings.frame_rate_hz)),
      "-i",
      "pipe:0"};
  const std::vector<std::string> kind = is_gif(file) ? gif_arguments() : mp4_arguments(settings.is_live);
  // Without the date and the library's version in it, the same pictures are the same file.
  const std::vector<std::string> output = {"-fflags", "+bitexact", "-flags:v", "+bitexact",
                                           "file:" + temporary.string()};
  for (const auto& part : {input, kind, output}) {
    arguments.insert(arguments.end(), part.begin(), part.end());
  }
  return arguments;
}

// The child has a process group of its own: a Ctrl-C at the terminal reaches this program alone, which then
// decides what becomes of the video.
int spawn(std::vector<std::string>& arguments, int input, int messages, pid_t& process) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, messages, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&process, pointers.front(), &files, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  return error;
}

std::string describe_end(int status) {
  return WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status))
                             : fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace

bool is_video(const fs::path& file) {
  return file.extension() == ".mp4" || file.extension() == ".gif";
}

void require_video_size(const fs::path& file, const VideoSettings& settings) {
  const bool is_even = settings.width_px % 2 == 0 && settings.height_px % 2 == 0;
  if (file.extension() == ".mp4" && !is_even) {
    throw UsageError(
        fmt::format("output '{}': an MP4 needs an even width and height, found {} x {}; "
                    "choose another --resolution or a .gif",
                    file.string(), settings.width_px, settings.height_px));
  }
}

VideoWriter::VideoWriter(fs::path file, const VideoSettings& settings)
    : file_(std::move(file)),
      temporary_(file_.string() + ".part" + std::to_string(::getpid())),
      picture_bytes_(static_cast<std::size_t>(settings.width_px) * 3U *
                     static_cast<std::size_t>(settings.height_px)),
      is_live_(settings.is_live),
      pictures_for_a_frame_(pictures_for_a_frame(file_, settings.frame_rate_hz)) {
  require_video_size(file_, settings);
  // A socket and not a pipe: writing to one can be told not to raise SIGPIPE when ffmpeg is gone.
  std::array<int, 2> ends{};
  messages_ = memfd_create("ffmpeg messages", MFD_CLOEXEC);
  if (messages_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    const int error = errno;
    ::close(messages_);
    throw InputError("cannot start ffmpeg: " + reason_of(error));
  }
  std::vector<std::string> arguments = ffmpeg_arguments(file_, temporary_, settings);
  const int error = spawn(arguments, ends[1], messages_, process_);
  ::close(ends[1]);
  input_ = ends[0];
  if (error != 0) {
    close_input();
    ::close(messages_);
    throw InputError("cannot make '" + file_.string() + "': the program ffmpeg does not start (" +
                     reason_of(error) + "); install it, or write pictures such as frame_{frame:04}.png");
  }
}

VideoWriter::~VideoWriter() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close_input();
  ::close(messages_);
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void VideoWriter::add(const renderer::Image& picture) {
  if (picture.channels != 3 || picture.pixels.size() != picture_bytes_) {
    throw std::invalid_argument("video: a picture has another size than the video");
  }
  if (pictures_++ % pictures_for_a_frame_ == 0) {
    send(picture.pixels);
    ++frames_;
  }
}

void VideoWriter::stop_if_interrupted() const {
  if (!is_live_) {
    throw_if_interrupted();
  }
}

void VideoWriter::send(std::span<const std::uint8_t> bytes) {
  constexpr int look_up_after_ms = 100;
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      stop_if_interrupted();
      pollfd room{input_, POLLOUT, 0};
      ::poll(&room, 1, look_up_after_ms);
    } else if (errno != EINTR) {
      fail_stopped();
    }
  }
}

void VideoWriter::finish() {
  close_input();
  const int status = wait_for_end();
  if (status != 0) {
    throw InputError(fmt::format("cannot make '{}': ffmpeg failed with {} after {}{}", file_.string(),
                                 describe_end(status), counted(frames_, "frame"), last_words()));
  }
  std::error_code error;
  fs::rename(temporary_, file_, error);
  if (error) {
    throw InputError("cannot write '" + file_.string() + "': " + error.message());
  }
}

void VideoWriter::fail_stopped() {
  close_input();
  const int status = wait_for_end();
  throw InputError(fmt::format("cannot make '{}': ffmpeg stopped with {} after {}{}", file_.string(),
                               describe_end(status), counted(frames_, "frame"), last_words()));
}

int VideoWriter::wait_for_end() {
  constexpr int look_again_after_ms = 5;
  int status = 0;
  while (::waitpid(process_, &status, WNOHANG) == 0) {
    stop_if_interrupted();
    ::poll(nullptr, 0, look_again_after_ms);
  }
  process_ = -1;
  return status;
}

void VideoWriter::close_input() {
  if (input_ >= 0) {
    ::close(input_);
    input_ = -1;
  }
}

// The end of what it wrote: the last message says what went wrong.
std::string VideoWriter::last_words() const {
  constexpr std::size_t enough = 400;
  const off_t size = ::lseek(messages_, 0, SEEK_END);
  std::string text(enough, '\0');
  const ssize_t count = ::pread(messages_, text.data(), enough, std::max<off_t>(0, size - off_t{enough}));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  return text.empty() ? "" : ": " + text;
}

}  // namespace taut::app

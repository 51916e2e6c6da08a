#include "app/models/reading/import_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <new>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/models/reading/import_confinement.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t header_bytes = 1 + sizeof(std::uint64_t);

// Limit on the bytes that the child may send: more than the largest model that can be simulated.
constexpr std::uint64_t max_sent_bytes = std::uint64_t{1} << 31;

// Ratio of the longest wait for the child to its processor time. On a busy machine it gets a fraction of a core.
constexpr int max_wait_ratio = 6;

constexpr const char* nested = "TAUT_IMPORTING";

fs::path importer_program(const fs::path& chosen_program) {
  if (!chosen_program.empty()) return chosen_program;
  if (const char* chosen = std::getenv("TAUT_IMPORTER"); chosen != nullptr && *chosen != '\0') return chosen;
  const fs::path self = own_file();
  if (self.filename().string().starts_with("taut")) return self;
  std::vector<fs::path> candidates = folders_above(self);
  if (candidates.empty()) {
    throw InputError("there is no program that reads models: the file of this program is gone or was replaced");
  }
  for (fs::path& candidate : candidates) candidate = candidate / "libexec" / "taut" / "taut-import";
  std::error_code error;
  const auto found =
      std::ranges::find_if(candidates, [&](const fs::path& candidate) { return fs::exists(candidate, error); });
  if (found == candidates.end()) {
    throw InputError("there is no program that reads models; expected '" + candidates.front().string() + '\'');
  }
  return *found;
}

/// A child process and the pipe that it writes to.
struct Importer {
  Descriptor output;
  ChildProcess process;
};

Importer start_importer(const fs::path& model, const ImportLimits& limits, ReadParts parts) {
  // A program that does not know the command would start itself again and again.
  if (std::getenv(nested) != nullptr) throw InputError("the importer was started by itself");
  const fs::path program = importer_program(limits.program);
  try {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
    Descriptor ours(ends[0]);
    const Descriptor its(ends[1]);
    return {
        std::move(ours),
        ChildProcess({.arguments = {fs::absolute(program).string(), "import-model", "--memory",
                                    std::to_string(limits.memory_mib), "--seconds", std::to_string(limits.seconds),
                                    "--parts", std::to_string(static_cast<int>(parts)), fs::absolute(model).string()},
                      .variable = std::string(nested) + "=1",
                      .output = its.number(),
                      .own_group = true})};
  } catch (const std::system_error& error) {
    throw InputError("the importer '" + program.string() + "' does not start: " + error.code().message());
  }
}

/// Returns all bytes that are written to the pipe; nothing if time runs out.
std::optional<std::string> read_all(const Descriptor& output, Clock::time_point deadline) {
  constexpr int look_up_after_ms = 100;
  std::string bytes;
  std::vector<char> part(std::size_t{1} << 18);
  while (Clock::now() < deadline && bytes.size() <= max_sent_bytes + header_bytes) {
    throw_if_interrupted();
    pollfd ready{output.number(), POLLIN, 0};
    if (::poll(&ready, 1, look_up_after_ms) <= 0) continue;
    const ssize_t count = ::read(output.number(), part.data(), part.size());
    if (count == 0) return bytes;
    if (count > 0) {
      bytes.append(part.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR && errno != EAGAIN) {
      return bytes;
    }
  }
  return std::nullopt;
}

std::string too_slow(int seconds) { return fmt::format("reading it takes more than {} s", seconds); }

std::string describe_failure(int status, const fs::path& path, const ImportLimits& limits) {
  if (!WIFSIGNALED(status)) {
    return "the library that reads models failed on it (" + describe_end(status) + "); it may be damaged";
  }
  if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) return too_slow(max_processor_s(path, limits));
  return fmt::format("the library that reads models crashed on it ({}); it may be damaged",
                     ::strsignal(WTERMSIG(status)));
}

/// Returns the content of the message; nothing if it is incomplete.
std::optional<std::string> read_envelope(const std::string& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < header_bytes) return std::nullopt;
  std::memcpy(&length, bytes.data() + 1, sizeof(length));
  return length == bytes.size() - header_bytes ? std::optional(bytes.substr(header_bytes)) : std::nullopt;
}

std::string too_big(const ImportLimits& limits) {
  return fmt::format("reading it takes more than {} MiB of memory", limits.memory_mib);
}

std::string write_envelope(ImportAnswer kind, const std::string& content) {
  const std::uint64_t length = content.size();
  std::string bytes(1, static_cast<char>(kind));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
  return bytes + content;
}

std::string describe_error(const std::exception& error, const ImportLimits& limits) {
  const std::string reason = error.what();
  const bool memory =
      dynamic_cast<const std::bad_alloc*>(&error) != nullptr || reason.find("bad_alloc") != std::string::npos;
  return memory ? too_big(limits) : reason;
}

}  // namespace

ModelArrays read_model_in_process(const fs::path& path, const ImportLimits& limits, ReadParts parts) {
  const int max_wait_s = max_wait_ratio * limits.seconds;
  const auto deadline = Clock::now() + std::chrono::seconds(max_wait_s);
  Importer importer = start_importer(path, limits, parts);
  const std::optional<std::string> bytes = read_all(importer.output, deadline);
  if (!bytes) {
    throw InputError(Clock::now() < deadline ? "it is larger than anything that can be simulated"
                                             : too_slow(max_wait_s));
  }
  const int status = importer.process.wait();
  const std::optional<std::string> content = read_envelope(*bytes);
  if (!content) throw InputError(describe_failure(status, path, limits));
  if (bytes->front() == static_cast<char>(ImportAnswer::reason)) throw InputError(printable(*content));
  return decode(*content);
}

TextureImage read_image(const fs::path& path) {
  require_file(path);
  try {
    ModelArrays answer = read_model_in_process(path, {}, ReadParts::image);
    if (answer.colours.maps.size() != 1) throw InputError("nothing came of it");
    return std::move(answer.colours.maps.front());
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("cannot read an image from '" + path.string() + "': " + error.what());
  }
}

void serve_import(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts) {
  std::string answer;
  try {
    if (parts < ReadParts::shape || parts > ReadParts::image) throw InputError("found unknown parts to read");
    const bool are_files_refused = confine_import(path, limits, STDOUT_FILENO);
    ModelArrays model = read_model(path, parts);
    model.is_importer_confined = are_files_refused;
    answer = write_envelope(ImportAnswer::arrays, encode(model));
  } catch (const std::exception& error) {
    answer = write_envelope(ImportAnswer::reason, describe_error(error, limits));
  }
  // A reader's remains may crash when they are destroyed, so that exit() is not called.
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(answer.data());
  ::_exit(write_bytes(import_output, {bytes, answer.size()}) ? 0 : 1);
}

}  // namespace taut::app

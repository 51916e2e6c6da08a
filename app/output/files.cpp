#include "app/output/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "app/errors.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  name += ".part" + std::to_string(::getpid());
  return name;
}

void write_bytes(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) {
    const std::string reason = reason_of(errno);
    std::error_code ignored;
    fs::remove(path, ignored);
    throw InputError("cannot write '" + path.string() + "': " + reason);
  }
}

}  // namespace

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError("there is no file '" + path.string() + "'");
  }
  if (error) {
    throw InputError("cannot read '" + path.string() + "': " + error.message());
  }
  if (fs::is_directory(status)) {
    throw InputError("'" + path.string() + "' is a folder, not a file");
  }
  if (::access(path.c_str(), R_OK) != 0) {
    throw InputError("cannot read '" + path.string() + "': " + reason_of(errno));
  }
  if (fs::is_regular_file(status) && fs::file_size(path, error) == 0) {
    throw InputError("the file '" + path.string() + "' is empty");
  }
}

std::string read_text_file(const fs::path& path) {
  require_file(path);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) {
    throw InputError("cannot read '" + path.string() + "': " + reason_of(errno));
  }
  return text.str();
}

void prepare_folder_of(const fs::path& file) {
  const fs::path folder = folder_of(file);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw InputError("cannot make the output folder '" + folder.string() + "': " + error.message());
  }
  if (fs::is_directory(file, error)) {
    throw InputError("cannot write '" + file.string() + "': there is a folder of this name");
  }
  // Asking for permissions is not enough: a read-only file system, a full quota.
  const fs::path probe = temporary_name(folder / ".taut");
  const int descriptor = ::open(probe.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  if (descriptor < 0) {
    throw InputError("cannot write to the output folder '" + folder.string() + "': " + reason_of(errno));
  }
  ::close(descriptor);
  ::unlink(probe.c_str());
}

void write_text_file(const fs::path& path, const std::string& text) {
  const fs::path temporary = temporary_name(path);
  write_bytes(temporary, text);
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw InputError("cannot write '" + path.string() + "': " + error.message());
  }
}

}  // namespace taut::app

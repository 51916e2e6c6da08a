// A hostile importer: everything that a damaged or malicious model could make a reader do, tried within the
// confinement.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/bpf.h>
#include <linux/io_uring.h>
#include <linux/perf_event.h>
#include <linux/sched.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>

#include "app/base/errors.hpp"
#include "app/models/reading/import_confinement.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::TemporaryFolder;

constexpr int inherited = 77;  ///< a descriptor that the importer's parent forgot to close

/// A folder with a model, files that the model names, and files that it does not name.
struct Place {
  TemporaryFolder whole;
  std::filesystem::path folder = whole / "models";
  std::string outside = whole.write("keys.txt", "Nobody's business.");
  std::string model, library, same_stem, map, diary, letter, pipe;

  Place() {
    for (const char* name : {"maps", "letters"}) std::filesystem::create_directories(folder / name);
    model = write("dress.obj", "mtllib blue cloth.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n#pipe.mtl\nf 1 2 3\n");
    library = write("blue cloth.mtl", "newmtl blue\nmap_Kd maps\\weave.png\n");
    same_stem = write("dress.bin", "12345678");
    map = write("maps/weave.png", "pixels");
    diary = write("diary.txt", "Nobody's business either.");
    letter = write("letters/love.txt", "Nobody's business at all.");
    pipe = folder / "pipe.mtl";
    ::mkfifo(pipe.c_str(), 0600);
  }

  std::string write(const std::string& name, const std::string& text) const {
    return whole.write("models/" + name, text);
  }
};

/// Result of an attempt that a child process made within the confinement.
struct Outcome {
  bool is_done = false;   ///< the attempt succeeded
  int error_number = 0;   ///< errno of an attempt that failed
  int signal_number = 0;  ///< signal that ended the process
};

/// Makes the attempt in a child process, after `prepare`. The attempt returns -1 and sets errno if it fails.
Outcome run_apart(const std::function<void()>& prepare, const std::function<long()>& attempt) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open("/dev/null", O_RDWR), inherited);
    prepare();
    errno = 0;
    const long result = attempt();
    ::_exit(result == -1 ? std::max(errno, 1) : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return {.signal_number = WTERMSIG(status)};
  return {.is_done = WEXITSTATUS(status) == 0, .error_number = WEXITSTATUS(status)};
}

Outcome run_confined(const Place& place, const std::function<long()>& attempt) {
  return run_apart([&] { confine_import(place.model, {}, STDOUT_FILENO); }, attempt);
}

struct Attempt {
  const char* name;
  std::function<long()> run;
};

/// Returns the id of the child, which ends at once; -1 if it was not made.
long wait_for(long child) {
  if (child == 0) ::_exit(0);
  return child;
}

long open_for(const std::string& path, int flags) { return ::open(path.c_str(), flags, 0600); }

std::vector<Attempt> signals_to_others() {
  return {{"kill", [] { return ::kill(::getppid(), 0); }},
          {"tkill", [] { return ::syscall(SYS_tkill, ::getppid(), 0); }},
          {"tgkill", [] { return ::syscall(SYS_tgkill, ::getppid(), ::getppid(), 0); }},
          {"rt_sigqueueinfo",
           [] {
             siginfo_t info{};
             info.si_code = SI_QUEUE;
             return ::syscall(SYS_rt_sigqueueinfo, ::getppid(), 0, &info);
           }},
          {"pidfd_send_signal",
           [] {
             const long other = ::syscall(SYS_pidfd_open, ::getppid(), 0);
             return other < 0 ? -1 : ::syscall(SYS_pidfd_send_signal, other, 0, nullptr, 0);
           }},
          {"fcntl(F_SETOWN)", [] { return ::fcntl(STDOUT_FILENO, F_SETOWN, ::getppid()); }}};
}

std::vector<Attempt> changes_of_files(const Place& place) {
  const auto path = [](const std::string& name) { return name.c_str(); };
  return {{"chmod to setuid", [&] { return ::chmod(path(place.diary), 04755); }},
          {"fchmodat", [&] { return ::fchmodat(AT_FDCWD, path(place.diary), 0644, 0); }},
          {"chown", [&] { return ::chown(path(place.diary), ::getuid(), ::getgid()); }},
          {"utimensat", [&] { return ::utimensat(AT_FDCWD, path(place.diary), nullptr, 0); }},
          {"setxattr", [&] { return ::setxattr(path(place.diary), "user.taut", "1", 1, 0); }},
          {"unlink", [&] { return ::unlink(path(place.diary)); }},
          {"rename", [&] { return ::rename(path(place.model), path(place.folder / "moved")); }},
          {"link", [&] { return ::link(path(place.model), path(place.folder / "linked")); }},
          {"symlink", [&] { return ::symlink(path(place.model), path(place.folder / "link")); }},
          {"mkdir", [&] { return ::mkdir(path(place.folder / "made"), 0700); }},
          {"mknod", [&] { return ::mkfifo(path(place.folder / "fifo"), 0600); }},
          {"truncate", [&] { return ::truncate(path(place.same_stem), 1); }},
          {"open to write", [&] { return open_for(place.model, O_WRONLY); }},
          {"open to read and write", [&] { return open_for(place.model, O_RDWR); }},
          {"open to create", [&] { return open_for(place.folder / "new", O_WRONLY | O_CREAT); }},
          {"open to truncate", [&] { return open_for(place.same_stem, O_RDONLY | O_TRUNC); }},
          {"open without a name", [&] { return open_for(place.folder / "", O_WRONLY | O_TMPFILE); }}};
}

std::vector<Attempt> reading_of_others(const Place& place) {
  return {{"open outside of the folder", [&] { return open_for(place.outside, O_RDONLY); }},
          {"open /etc/passwd", [] { return open_for("/etc/passwd", O_RDONLY); }},
          {"open an unnamed file beside it", [&] { return open_for(place.diary, O_RDONLY); }},
          {"open an unnamed file below it", [&] { return open_for(place.letter, O_RDONLY); }},
          {"open a named pipe", [&] { return open_for(place.pipe, O_RDONLY | O_NONBLOCK); }},
          {"list the folder", [&] { return open_for(place.folder / "", O_RDONLY | O_DIRECTORY); }},
          {"an inherited descriptor", [] { return ::write(inherited, "x", 1); }},
          {"open_by_handle_at",
           [] { return ::syscall(SYS_open_by_handle_at, AT_FDCWD, std::array<int, 8>{}.data(), O_RDONLY); }}};
}

std::vector<Attempt> other_processes() {
  static int word = 7;
  static iovec here = {&word, sizeof(word)};
  return {{"fork", [] { return wait_for(::fork()); }},
          {"vfork", [] { return wait_for(::vfork()); }},
          {"clone", [] { return wait_for(::syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0)); }},
          {"clone3",
           [] {
             clone_args arguments{};
             arguments.exit_signal = SIGCHLD;
             return wait_for(::syscall(SYS_clone3, &arguments, sizeof(arguments)));
           }},
          {"setsid", [] { return ::setsid(); }},
          {"setpgid", [] { return ::setpgid(0, 0); }},
          {"setpriority", [] { return ::setpriority(PRIO_PROCESS, static_cast<id_t>(::getppid()), 0); }},
          {"sched_setaffinity",
           [] {
             cpu_set_t all;
             CPU_ZERO(&all);
             for (int k = 0; k < CPU_SETSIZE; ++k) CPU_SET(k, &all);
             return ::sched_setaffinity(::getppid(), sizeof(all), &all);
           }},
          {"prlimit of the parent",
           [] {
             rlimit own{};
             return ::prlimit(::getppid(), RLIMIT_STACK, nullptr, &own);
           }},
          {"raising a limit",
           [] {
             rlimit own{};
             ::getrlimit(RLIMIT_NOFILE, &own);
             return ::setrlimit(RLIMIT_NOFILE, &own);
           }},
          {"ptrace", [] { return ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr); }},
          {"process_vm_readv", [] { return ::process_vm_readv(::getppid(), &here, 1, &here, 1, 0); }},
          {"process_vm_writev", [] { return ::process_vm_writev(::getppid(), &here, 1, &here, 1, 0); }},
          {"pidfd_open", [] { return ::syscall(SYS_pidfd_open, ::getppid(), 0); }},
          {"kcmp", [] { return ::syscall(SYS_kcmp, ::getppid(), ::getpid(), 0, 0, 0); }},
          {"setuid", [] { return ::setuid(::getuid()); }},
          {"execve", [] { return ::execl("/bin/true", "true", nullptr); }},
          {"memfd_create and execution of it",
           [] {
             const int file = ::memfd_create("program", 0);
             char* const none[] = {nullptr};
             if (file < 0 || ::write(file, "#!/bin/true\n", 12) != 12) return -1;
             return ::fexecve(file, none, none);
           }},
          {"memory that can be executed", [] {
             return ::mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? -1
                                                                                                                   : 0;
           }}};
}

std::vector<Attempt> the_kernel() {
  return {{"socket", [] { return ::socket(AF_INET, SOCK_STREAM, 0); }},
          {"socket of the machine", [] { return ::socket(AF_UNIX, SOCK_DGRAM, 0); }},
          {"socketpair", [] { return ::socketpair(AF_UNIX, SOCK_STREAM, 0, std::array<int, 2>{}.data()); }},
          {"shmget", [] { return ::shmget(IPC_PRIVATE, 4096, 0600); }},
          {"inotify_init1", [] { return ::syscall(SYS_inotify_init1, 0); }},
          {"io_uring_setup",
           [] {
             io_uring_params parameters{};
             return ::syscall(SYS_io_uring_setup, 1, &parameters);
           }},
          {"bpf",
           [] {
             bpf_attr map{};
             map.map_type = BPF_MAP_TYPE_ARRAY;
             map.key_size = map.value_size = 4;
             map.max_entries = 1;
             return ::syscall(SYS_bpf, BPF_MAP_CREATE, &map, sizeof(map));
           }},
          {"perf_event_open",
           [] {
             perf_event_attr event{};
             event.size = sizeof(event);
             event.type = PERF_TYPE_SOFTWARE;
             return ::syscall(SYS_perf_event_open, &event, 0, -1, -1, 0);
           }},
          {"mount", [] { return ::mount("none", "/mnt", "tmpfs", 0, nullptr); }},
          {"unshare", [] { return ::unshare(CLONE_NEWUSER); }},
          {"userfaultfd", [] { return ::syscall(SYS_userfaultfd, O_CLOEXEC); }},
          {"add_key", [] { return ::syscall(SYS_add_key, "user", "taut", "1", 1, -2); }},
          {"personality", [] { return ::syscall(SYS_personality, 0xFFFFFFFF); }}};
}

void expect_refused(const Place& place, const std::vector<Attempt>& attempts) {
  for (const Attempt& attempt : attempts) {
    const Outcome outcome = run_confined(place, attempt.run);
    EXPECT_TRUE(outcome.error_number == EPERM || outcome.error_number == EACCES || outcome.error_number == EBADF)
        << attempt.name << (outcome.is_done ? ": done" : ": not refused as expected") << ", error "
        << outcome.error_number << ", signal " << outcome.signal_number;
  }
}

TEST(HostileImporter, SignalsNobody) { expect_refused(Place(), signals_to_others()); }

TEST(HostileImporter, ChangesNoFile) {
  const Place place;
  expect_refused(place, changes_of_files(place));
}

TEST(HostileImporter, ReadsNothingThatTheModelDoesNotName) {
  const Place place;
  expect_refused(place, reading_of_others(place));
}

TEST(HostileImporter, StartsAndTouchesNoProcess) { expect_refused(Place(), other_processes()); }

TEST(HostileImporter, AsksTheKernelForNothingElse) { expect_refused(Place(), the_kernel()); }

TEST(HostileImporter, EndsByCallsOfOtherKinds) {
  const Place place;
#if defined(__x86_64__)
  constexpr long x32 = 0x40000000;
  EXPECT_EQ(run_confined(place, [] { return ::syscall(x32 + SYS_getpid); }).signal_number, SIGSYS);
#endif
  EXPECT_EQ(run_confined(place, []() -> long { std::abort(); }).signal_number, SIGABRT) << "an abort ends it";
}

TEST(HostileImporter, DoesNotOutliveTheProgramThatStartedIt) {
  const Place place;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t starter = ::fork();
  if (starter == 0) {
    if (::fork() == 0) {
      confine_import(place.model, {}, ends[1]);
      if (::write(import_output, "x", 1) != 1) ::_exit(1);
      for (;;) ::sched_yield();
    }
    ::pause();
  }
  ::close(ends[1]);
  char letter = 0;
  EXPECT_EQ(::read(ends[0], &letter, 1), 1) << "it runs";
  const auto start = std::chrono::steady_clock::now();
  ::kill(starter, SIGKILL);
  EXPECT_EQ(::read(ends[0], &letter, 1), 0) << "it has ended";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << "before its time was spent";
  ::waitpid(starter, nullptr, 0);
  ::close(ends[0]);
}

TEST(HostileImporter, PrintsNothingBetweenTheAnswersBytes) {
  const Place place;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t importer = ::fork();
  if (importer == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::closefrom(STDERR_FILENO + 1);  // leaves the descriptors of a program that was just started
    confine_import(place.model, {}, STDOUT_FILENO);
    std::size_t written = 0;
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO, import_output}) {
      written += static_cast<std::size_t>(::write(stream, stream == import_output ? "answer" : "noise ", 6));
    }
    ::_exit(written == 18 ? 0 : 1);
  }
  ::close(ends[1]);
  std::array<char, 64> bytes{};
  EXPECT_EQ(::read(ends[0], bytes.data(), bytes.size()), 6);
  EXPECT_EQ(std::string(bytes.data()), "answer");
  ::waitpid(importer, nullptr, 0);
  ::close(ends[0]);
}

TEST(HostileImporter, ReadsTheModelAndWhatItNames) {
  const Place place;
  for (const std::string& path : {place.model, place.library, place.same_stem, place.map}) {
    const Outcome outcome = run_confined(place, [&] {
      const long file = open_for(path, O_RDONLY);
      char first = 0;
      return file < 0 || ::read(static_cast<int>(file), &first, 1) != 1 ? -1L : 0L;
    });
    EXPECT_TRUE(outcome.is_done) << path << ": error " << outcome.error_number;
  }
}

/// Makes the kernel answer a system call with an error, like a kernel without that call.
void refuse_call(int call, int error_number) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(static_cast<unsigned>(error_number)), call, 0);
  seccomp_load(filter);
  seccomp_release(filter);
}

TEST(ImportConfinement, WithoutLandlockStillRefusesAllWriting) {
  const Place place;
  const auto prepare = [&] {
    refuse_call(SCMP_SYS(landlock_create_ruleset), ENOSYS);
    if (confine_import(place.model, {}, STDOUT_FILENO)) ::_exit(99);
  };
  EXPECT_TRUE(run_apart(prepare, [&] { return open_for(place.diary, O_RDONLY); }).is_done) << "which is to be said";
  for (const Attempt& attempt : changes_of_files(place)) {
    EXPECT_EQ(run_apart(prepare, attempt.run).error_number, EPERM) << attempt.name;
  }
}

TEST(ImportConfinement, WithoutSeccompNoModelIsRead) {
  const Place place;
  const auto confined_without = [&] {
    refuse_call(SCMP_SYS(seccomp), EINVAL);
    try {
      confine_import(place.model, {}, STDOUT_FILENO);
    } catch (const InputError& error) {
      return std::string(error.what()).find("seccomp: Invalid argument") != std::string::npos ? 0L : -1L;
    }
    return -1L;
  };
  EXPECT_TRUE(run_apart([] {}, confined_without).is_done);
}

/// Files that belong to a model with this name and these bytes, relative to their folder, sorted.
std::vector<std::string> files_named(const Place& place, const std::string& model, const std::string& bytes) {
  std::vector<std::string> names;
  for (const auto& file : named_files(place.write(model, bytes))) {
    names.push_back(file.lexically_relative(std::filesystem::canonical(place.folder)));
  }
  std::ranges::sort(names);
  return names;
}

using Names = std::vector<std::string>;

TEST(NamedFiles, AreThoseOfTheSameStem) {
  const Place place;
  place.write("walk.md5anim", "1");
  place.write("walker.md5anim", "1");
  place.write("walk_a.3d", "1");
  EXPECT_EQ(files_named(place, "walk.md5mesh", "names nothing"), (Names{"walk.md5anim", "walk.md5mesh", "walk_a.3d"}));
  EXPECT_EQ(files_named(place, "walk_d.3d", "names nothing"),
            (Names{"walk.md5anim", "walk.md5mesh", "walk_a.3d", "walk_d.3d"}));
}

TEST(NamedFiles, AreFoundHoweverAModelSpellsThem) {
  const Place place;
  place.write("gr\u00fcner Stoff (1).png", "1");
  const Names both = {"a.fbx", "gr\u00fcner Stoff (1).png"};
  EXPECT_EQ(files_named(place, "a.fbx", "xgr\u00fcner Stoff (1).png"), both);
  EXPECT_EQ(files_named(place, "a.fbx", "C:\\work\\gr\u00fcner Stoff (1).png"), both);
  EXPECT_EQ(files_named(place, "a.fbx", "gr%C3%BCner%20Stoff%20(1).png"), both);
  EXPECT_EQ(files_named(place, "a.fbx", "gr%C3%BCner%20Stoff%20%281%29.png"), both);
  const std::u16string wide = u"gr\u00fcner Stoff (1).png";
  EXPECT_EQ(files_named(place, "a.fbx", {reinterpret_cast<const char*>(wide.data()), 2 * wide.size()}), both);
  EXPECT_EQ(files_named(place, "a.fbx", "gruener Stoff (1).png"), Names{"a.fbx"});
}

TEST(NamedFiles, LieInTheModelsFolderWhereverLinksLead) {
  const Place place;
  std::filesystem::create_symlink(place.outside, place.folder / "keys.png");
  std::filesystem::create_symlink(place.map, place.folder / "cloth.png");
  std::filesystem::create_symlink(place.folder, place.folder / "maps/again");
  EXPECT_EQ(files_named(place, "a.fbx", "keys.png cloth.png diary.txt/../pipe.mtl maps/again"),
            (Names{"a.fbx", "diary.txt", "maps/weave.png"}));
  std::filesystem::create_symlink(place.diary, place.folder / "link.fbx");
  EXPECT_EQ(named_files(place.folder / "link.fbx"), std::vector{std::filesystem::canonical(place.diary)});
  EXPECT_TRUE(named_files(place.pipe).empty()) << "nothing that is no file is opened";
}

TEST(NamedFiles, AreFoundAmongManyInALargeModel) {
  const Place place;
  for (int k = 0; k < 3000; ++k) place.write("picture" + std::to_string(k) + ".png", "");
  std::string bytes;
  for (int k = 0; k < 400'000; ++k) bytes += k % 1000 == 0 ? "map_Kd other.png\n" : "v 0.1234567 1.2345678\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(files_named(place, "large.obj", bytes + "map_Kd picture2999.png\n"),
            (Names{"large.obj", "picture2999.png"}));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace taut::app

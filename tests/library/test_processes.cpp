// Forks, broken pipes and absurd numbers in a program that uses the library.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <limits>
#include <thread>

#include "cloths.hpp"
#include "temporary_folder.hpp"

namespace taut::test {
namespace {

/// Runs the work in a child process and returns its exit code; -SIGNAL if a signal ended it. SIGALRM ends it after 20
/// s.
int run_apart(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(120);
    ::_exit(work());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

TEST(Library, AChildAfterForkHasNoClothOfItsParent) {
  OwnCloth cloth("tshirt", 4);
  cloth.step();
  ASSERT_EQ(cloth.result, TAUT_OK);
  EXPECT_EQ(run_apart([&] { return taut_step(cloth, nullptr); }), TAUT_ERROR_HANDLE);
  EXPECT_EQ(run_apart([&] { return taut_destroy(cloth); }), TAUT_ERROR_HANDLE);
  EXPECT_EQ(run_apart([&] {
              OwnCloth own("tshirt", 2);
              own.step();
              return own.result == TAUT_OK && own.cloth.id != cloth.cloth.id && taut_destroy(own) == TAUT_OK ? 0 : 1;
            }),
            0)
      << "a child makes cloths of its own";
  cloth.step();
  EXPECT_EQ(cloth.result, TAUT_OK) << "the parent goes on";
}

TEST(Library, AChildMayForkWhileOtherThreadsCall) {
  OwnCloth cloth("tshirt", 2);
  std::atomic<bool> is_over = false;
  std::thread other([&] {
    while (!is_over) cloth.info();
  });
  for (int k = 0; k < 200; ++k) {
    EXPECT_EQ(run_apart([&] { return taut_destroy(cloth); }), TAUT_ERROR_HANDLE);
  }
  is_over = true;
  other.join();
}

TEST(Library, AStateIsSavedToAFileAndToNothingElse) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  OwnCloth cloth("pinned-9x9-5");
  EXPECT_EQ(run_apart([&] {
              OwnCloth own("pinned-9x9-5");
              return taut_save_file(own, pipe.c_str());
            }),
            TAUT_ERROR_INPUT);
  EXPECT_EQ(taut_save_file(cloth, pipe.c_str()), TAUT_ERROR_INPUT);
  EXPECT_CONTAINS(cloth.error(), "pipe': found what is no file, expected a file or a free name");
  EXPECT_EQ(taut_save_file(cloth, (folder / "state").c_str()), TAUT_OK);
  ::close(reader);
}

/// Makes every call that takes numbers with one that is `odd`, then advances two frames. Returns the number of calls
/// that gave TAUT_OK.
int calls_taken(double odd) {
  int taken = 0;
  const auto attempt = [&](const auto& call) {
    Square square;
    square.options.threads = 2;
    square.options.counts_crossings = 1;
    OwnCloth cloth(square.options);
    const std::uint32_t pin = 0;
    taut_set_pins(cloth, &pin, 1);
    taken += call(square, cloth) == TAUT_OK ? 1 : 0;
    taut_step(cloth, nullptr);
    taut_step(cloth, nullptr);
  };
  const auto created = [&](const TautOptions& options) {
    OwnCloth cloth(options);
    cloth.step(2);
    return cloth.text.empty() ? TAUT_OK : TAUT_ERROR_ARGUMENT;
  };
  const std::array<double, 3> point = {0.0, odd, 0.0};
  const TautPoints one = {&point, 1, sizeof(point), TAUT_DOUBLE};
  const std::uint32_t pin = 0;
  attempt([&](Square& square, OwnCloth&) { return square.positions[5][1] = odd, created(square.options); });
  attempt([&](Square& square, OwnCloth&) {
    for (auto& position : square.positions) position[0] = odd;
    return created(square.options);
  });
  attempt([&](Square& square, OwnCloth&) {
    auto moved = square.positions;
    moved[7][2] = odd;
    const TautPoints start = {moved.data(), moved.size(), sizeof(moved[0]), TAUT_DOUBLE};
    square.options.start = &start;
    return created(square.options);
  });
  attempt([&](Square& square, OwnCloth& cloth) {
    square.positions[3][0] = odd;
    const TautPoints points = square.points();
    return taut_set_positions(cloth, &points);
  });
  attempt([&](Square&, OwnCloth& cloth) { return taut_set_wind(cloth, odd, 0, odd); });
  attempt([&](Square&, OwnCloth& cloth) { return taut_set_gravity(cloth, 0, odd, 0); });
  attempt([&](Square&, OwnCloth& cloth) { return taut_set_forces(cloth, &pin, &one); });
  attempt([&](Square&, OwnCloth& cloth) { return taut_move_pins(cloth, &pin, &one); });
  attempt([&](Square&, OwnCloth& cloth) {
    Box box(-1.0);
    box.positions[2][1] = odd;
    return taut_add_body(cloth, &box.body, nullptr);
  });
  attempt([&](Square&, OwnCloth& cloth) {
    auto plane = make_struct<TautBody>(taut_body_init);
    plane.plane_point[1] = odd;
    plane.plane_normal[1] = odd;
    return taut_add_body(cloth, &plane, nullptr);
  });
  for (const auto move : {taut_move_body, taut_place_body}) {
    attempt([&](Square&, OwnCloth& cloth) {
      Box box(-1.0);
      std::int32_t number = 0;
      taut_add_body(cloth, &box.body, &number);
      box.positions[2][1] = odd;
      return move(cloth, number, &box.mesh.positions);
    });
  }
  return taken;
}

TEST(Library, AbsurdNumbersEndInAResultAndNotInASignal) {
  for (const double odd : {1e-310, 1e-30, 1e9, 1e20, 9e29}) {
    EXPECT_GE(run_apart([&] { return calls_taken(odd); }), 0) << odd;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double odd : {2e30, 1e160, 1e300, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(run_apart([&] { return calls_taken(odd); }), 0) << odd << " was taken";
  }
}

}  // namespace
}  // namespace taut::test

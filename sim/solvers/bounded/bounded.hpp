#pragma once

#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim {

namespace bounded {
class ParallelKernels;
struct ProjectionResult;
}  // namespace bounded

/// The strong constraint organised so that a bound on stretch is kept in every frame at any resolution.
/// How and why: bounded.md beside this file.
class BoundedSolver : public Solver {
 public:
  /// Throws std::invalid_argument if this processor does not have the vector unit.
  BoundedSolver(const BoundedSettings& settings, std::optional<int> substeps, int max_substeps);
  ~BoundedSolver() override;

  void require_promised(const Garment& garment, const Surroundings& surroundings) const override;
  void move_within_bound(const Garment& garment, const Pins& pins, State& state) const override;
  FrameReport advance_frame(const Frame& frame, State& state) override;
  void keep_frame() override;
  bool ignores_contact() const override { return !settings_.contact; }
  void save(const Garment& garment, const Pins& pins, ByteWriter& bytes) const override;
  void restore(const Frame& frame, ByteReader& bytes) override;

 private:
  struct Cloth;
  struct Attempt;
  struct FramePart;
  struct Try;
  struct Effort;

  void lay_out(const Frame& frame);
  int substeps_for_load(const Frame& frame) const;
  double pins_turn_m(const Frame& frame, const State& state) const;
  double usual_work(const Frame& frame, double pins_turn_m, const bounded::Memory& memory) const;
  bounded::Memory first_memory(const Frame& frame) const;
  void begin_frame(const State& state);
  void begin_substeps(double time_step_s);
  void follow_tension(int done, int substeps, double frame_time_s);
  [[nodiscard]] bool run_substeps(const Frame& frame, double time_s, int substeps, bool is_last);
  bounded::ProjectionResult project(const Frame& frame, double end_s, int substeps, const Try& how,
                                    bounded::Float4Array& corrections);
  Attempt attempt(const Frame& frame, const State& state, bounded::Memory memory, const Try& how);
  int substeps_in(double time_s, const bounded::SubstepControl& control) const;
  static Try next_try(const FramePart& part, const bounded::SubstepControl& control, const Effort& effort);
  FramePart first_part(const bounded::Memory& memory, const Effort& effort) const;
  static void halve(FramePart& part, double raw_bounds, double limit);
  static void go_on(FramePart& part, double raw_bounds, bool is_cheap);
  void try_otherwise(FramePart& part, const Attempt& failed, double raw_bounds, const Try& how, const Effort& effort,
                     bounded::SubstepControl& control) const;
  Attempt advance(const Frame& frame, const State& begin, bounded::Memory memory, Effort& effort);
  State shape_of(const Frame& frame, const State& begin, int substeps) const;
  void set_previous(State& state) const;
  void require_a_way_on(const Frame& frame, const State& begin, const Attempt& last, const Effort& effort) const;

  /// The stretch that others are counted in.
  double bound() const;

  BoundedSettings settings_;
  std::optional<int> substeps_;  ///< per frame; the solver chooses if there is none
  int max_substeps_;
  std::unique_ptr<bounded::ParallelKernels> kernels_;
  std::unique_ptr<Cloth> cloth_;
  std::optional<bounded::Memory> memory_;  ///< of the last frame that was kept
  bounded::Memory next_;                   ///< of the last frame that was advanced
};

}  // namespace taut::sim

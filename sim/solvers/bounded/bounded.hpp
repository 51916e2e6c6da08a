#pragma once

#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/settings.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim {

namespace bounded {
class ParallelKernels;
struct ProjectionResult;
}  // namespace bounded

/// The strong constraint, organised so that every frame keeps a bound on stretch at any resolution. Method and reasons:
/// bounded.md beside this file.
class BoundedSolver : public Solver {
 public:
  /// Throws std::invalid_argument if this processor lacks the vector unit.
  BoundedSolver(const BoundedSettings& settings, std::optional<int> substeps, int max_substeps);
  ~BoundedSolver() override;

  void require_promised(const Garment& garment, const Surroundings& surroundings) const override;
  void move_within_bound(const Garment& garment, const Pins& pins, State& state) const override;
  void prepare_first_frame(const Frame& frame) override;
  FrameReport advance_frame(const Frame& frame, State& state) override;
  void keep_frame() override;
  bool ignores_contact() const override { return !settings_.contact; }
  void save(const Garment& garment, const Pins& pins, ByteWriter& bytes) const override;
  void restore(const Frame& frame, ByteReader& bytes) override;

 private:
  struct Cloth;
  struct FrameAttempt;
  struct FramePart;
  struct AttemptLimits;
  struct WorkBudget;

  void lay_out(const Frame& frame);
  int substeps_for_load(const Frame& frame) const;
  double pins_turn_m(const Frame& frame, const State& state) const;
  double expected_work(const Frame& frame, double pins_turn_m, const bounded::Memory& memory) const;
  bounded::Memory first_memory(const Frame& frame) const;
  void begin_frame(const State& state);
  void begin_substeps(double time_step_s);
  void follow_tension(int done, int substeps, double frame_time_s);
  [[nodiscard]] bool run_substeps(const Frame& frame, double time_s, int substeps, bool is_last);
  bounded::ProjectionResult project(const Frame& frame, double end_s, int substeps, const AttemptLimits& how,
                                    bounded::Float4Array& corrections);
  FrameAttempt attempt(const Frame& frame, const State& state, bounded::Memory memory, const AttemptLimits& how);
  int substeps_in(double time_s, const bounded::SubstepControl& control) const;
  static AttemptLimits next_try(const FramePart& part, const bounded::SubstepControl& control,
                                const WorkBudget& effort);
  FramePart first_part(const bounded::Memory& memory, const WorkBudget& effort) const;
  static void halve(FramePart& part, double raw_bounds, double limit);
  static void advance_part(FramePart& part, double raw_bounds, bool is_cheap);
  void adapt_after_failure(FramePart& part, const FrameAttempt& failed, double raw_bounds, const AttemptLimits& how,
                           const WorkBudget& effort, bounded::SubstepControl& control) const;
  FrameAttempt advance(const Frame& frame, const State& begin, bounded::Memory memory, WorkBudget& effort);
  State end_state(const Frame& frame, const State& begin, int substeps) const;
  void set_previous(State& state) const;
  void require_unblocked(const Frame& frame, const State& begin, const FrameAttempt& last,
                         const WorkBudget& effort) const;

  /// Returns the unit of stretch in which other stretches are expressed.
  double bound() const;

  BoundedSettings settings_;
  std::optional<int> substeps_;  ///< per frame; the solver chooses if not set
  int max_substeps_;
  std::unique_ptr<bounded::ParallelKernels> kernels_;
  std::unique_ptr<Cloth> cloth_;
  std::optional<bounded::Memory> memory_;  ///< memory of the last kept frame
  bounded::Memory next_;                   ///< memory of the last advanced frame
};

}  // namespace taut::sim

#pragma once

#include <memory>

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

  FrameReport advance_frame(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
                            double frame_time_s, State& state) override;
  void save(const Garment& garment, const Pins& pins, ByteWriter& memory) const override;
  void restore(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
               double frame_time_s, ByteReader& memory) override;

 private:
  struct Cloth;
  class ApartWhileCorrected;

  bool is_laid_out_for(const Garment& garment, const Pins& pins) const;
  void lay_out(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
               double frame_time_s);
  void begin_frame(const State& state);
  void begin_substeps(double time_step_s);
  void run_substeps(const Garment& garment, const Surroundings& surroundings, double time_s,
                    double frame_time_s, int substeps, int earlier_attempts);
  bounded::ProjectionResult try_frame(const Garment& garment, const Pins& pins,
                                      const Surroundings& surroundings, double frame_time_s,
                                      int earlier_attempts, State& state);
  void write_shape(const Surroundings& surroundings, double frame_time_s, State& state) const;
  void require_a_way_on(const Pins& pins, const Surroundings& surroundings, double frame_time_s,
                        State& state) const;
  void end_frame(double frame_time_s, int substeps, State& state) const;

  BoundedSettings settings_;
  std::optional<int> substeps_;  ///< per frame; the solver chooses if there is none
  int max_substeps_;
  std::unique_ptr<bounded::ParallelKernels> kernels_;
  std::unique_ptr<Cloth> cloth_;
};

}  // namespace taut::sim

#pragma once

#include "sim/solvers/bounded/projection.hpp"
#include "sim/solvers/bounded/step.hpp"

namespace taut::sim::bounded {

/// Keeps the projection at the end of a frame from making anything cross.
class ApartWhileCorrected : public Confinement {
 public:
  /// The frame ends at `time_s`. All arguments must outlive this object.
  ApartWhileCorrected(const Frame& frame, double time_s, ParallelKernels& kernels, SteppedCloth& cloth)
      : frame_(frame), time_s_(time_s), kernels_(kernels), cloth_(cloth) {}

  void begin(const Float4Array& raw, const Float4Array& expected) override;
  void bring_back(Float4Array& displacements) override;
  bool is_spent(double sweeps) const override { return cloth_.contacts.is_spent(sweeps); }

 private:
  const Frame& frame_;
  double time_s_;
  ParallelKernels& kernels_;
  SteppedCloth& cloth_;
  int rounds_ = 0;
  bool is_held_back_ = false;
  Float4Array last_;  ///< displacements that are known to keep everything apart
  Float4Array moved_;
};

}  // namespace taut::sim::bounded

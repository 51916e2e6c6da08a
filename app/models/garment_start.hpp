#pragma once

#include "app/models/garment_loading.hpp"

namespace taut::app {

/// Returns the position of each vertex of the file, in m.
std::vector<sim::Vec3> positions_in_file(const ImportedModel& model);

/// Returns the start positions, in m, for the vertices of the garment's file or of the mesh. Throws InputError that
/// names the file, and std::invalid_argument for positions that the caller gave.
std::vector<sim::Vec3> read_start(const GarmentSource& source, LoadedGarment& loaded);

/// Returns whether a garment that is not simulated as modelled crosses itself so little that untangling ends soon.
bool can_be_untangled(const LoadedGarment& loaded);

/// Separates crossings of the start, which then is the rest shape of a fitted mesh where that leaves no flat triangles.
void untangle(const Scene& scene, LoadedGarment& loaded, const StageReport& begin);

}  // namespace taut::app

#pragma once

#include <string>
#include <vector>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// A model whose faces, or their connections, are unlike those of the other samples.
struct SampleGarment {
  std::string name;    ///< of its file, without extension
  std::string format;  ///< an argument of model_text()
  std::string kind;    ///< what is special about it, for people
  ModelArrays model;   ///< about 1 m large, y up
};

/// One sample of every kind, each in one format. Every call gives the same models.
std::vector<SampleGarment> make_sample_garments();

}  // namespace taut::app

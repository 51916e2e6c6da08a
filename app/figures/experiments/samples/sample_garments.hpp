#pragma once

#include <string>
#include <vector>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// A model that differs from the others in what its faces are or how they hang together.
struct SampleGarment {
  std::string name;    ///< of its file, without what tells the format
  std::string format;  ///< of `model_text`
  std::string kind;    ///< what is particular about it, in words
  ModelArrays model;   ///< about a metre large, y up
};

/// One of every kind, each in one format; always the same.
std::vector<SampleGarment> make_sample_garments();

}  // namespace taut::app

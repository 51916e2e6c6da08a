#pragma once

#include <span>
#include <string>

#include "app/bench/contact_trials.hpp"
#include "app/report/machine.hpp"

namespace taut::app {

/// The trials as a table for people, with what the first frame that broke a promise broke in each run.
std::string contact_table(std::span<const ContactTrial> trials);

/// All trials as one JSON object, run by run.
std::string contact_json(std::span<const ContactTrial> trials, const Machine& machine);

}  // namespace taut::app

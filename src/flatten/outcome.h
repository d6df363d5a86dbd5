#pragma once

#include <string>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// What is wrong with the form of a result, in the order of Criterion; empty where nothing is.
std::vector<FormFault> find_form_faults(const EvolveReport& evolve);

/// All of them after "the form": "is crumpled and lost".
std::string joined(const std::vector<FormFault>& faults);

}  // namespace planish

#pragma once

#include <string_view>
#include <variant>

#include <planish/evolve/auto.h>
#include <planish/evolve/bilaplacian_fairing.h>
#include <planish/evolve/classical_laplacian.h>
#include <planish/evolve/controllable_laplacian.h>
#include <planish/evolve/flattenable_laplacian.h>
#include <planish/evolve/global_penalty.h>
#include <planish/evolve/least_norm.h>
#include <planish/evolve/local_offset.h>
#include <planish/evolve/local_perturbation.h>

namespace planish {

/// A method is a value: its options say which one it is. Each has its header, its source file and
/// its page under docs/methods; it says there
///   name             on the command line and in reports,
///   usual_sweeps     how many sweeps it is given where nobody said,
///   honours_weights, honours_obstacle   see Constraints,
/// and describe(options, visit) describes its options, once, for command line, JSON, bindings and
/// docs: it calls visit(name, member, doc, range) for numbers, visit(name, member, doc) for
/// enumerations and BorderFreedom.
using Method =
    std::variant<ControllableLaplacian, ClassicalLaplacian, LeastNorm, FlattenableLaplacian,
                 LocalOffset, GlobalPenalty, LocalPerturbation, BilaplacianFairing, Auto>;

/// As in "controllable".
std::string_view name_of(const Method& method);

/// The method of that name with its default options.
/// @throws Error unknown_name
Method method_named(std::string_view name);

/// @throws Error option_out_of_range naming the first option out of its range
void check_options(const Method& method);

}  // namespace planish

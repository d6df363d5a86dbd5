#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish::cli {

/// Other names of a flag that mean exactly the same, as "--seam-allowance" of --allowance.
std::vector<std::string> aliases_of(std::string_view flag);

/// The flag that a name is an alias of; the name itself where it is none.
std::string_view without_alias(std::string_view name);

/// Why there is no flag of that name, and which one is nearest in purpose, as a sentence; empty for
/// other names. For what people look for and the program lacks, or calls something else.
std::string_view missing_flag_advice(std::string_view name);

}  // namespace planish::cli

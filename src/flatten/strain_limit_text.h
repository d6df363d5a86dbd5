#pragma once

#include <span>
#include <string>
#include <string_view>

#include <planish/measure/limit_check.h>

namespace planish {

/// What of the strain a limit bounds: "strain", "stretch" or "compression".
std::string_view bounded_part(Criterion what);
/// Behind its figure: "", " of stretch" or " of compression".
std::string side_words(Criterion what);
/// And behind that: "", " on 99 % of the area" or " (rms)".
std::string scope_words(Criterion what);
/// Whether a limit of strain is for 99 % of the area.
bool is_of_area(Criterion what);

/// Whether a pattern keeps a limit of strain, in a sentence, ASCII: "The limit of 10 % on 99 % of
/// the area is kept: the pattern has 6.8 %."
std::string strain_limit_text(const LimitCheck& check);

/// The sentences of all checks; empty where there are none.
std::string strain_limits_text(std::span<const LimitCheck> checks);

}  // namespace planish

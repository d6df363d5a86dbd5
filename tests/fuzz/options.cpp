// Values of flags: numbers, quantities with units, names, and the methods that they make.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "flags/method_flags.h"
#include "flags/quantities.h"
#include "flags/units.h"
#include "fuzz/bytes.h"
#include "fuzz/check.h"
#include "shell/failures.h"
#include "shell/values.h"

using namespace planish;
using namespace planish::cli;

namespace {

template <class Work>
void allow_usage_error(Work&& work) {
  try {
    fuzz::allow_refusal(work);
  } catch (const UsageError& error) {
    fuzz::check(*error.what() != '\0', "messages are not empty");
  }
}

void check_value(const std::string& text, const Arguments& arguments) {
  constexpr std::array ranges = {Range{}, Range{0.0, 1.0}, Range{0.0}, Range{-10.0, 0.0}};
  for (const Range range : ranges) {
    for (const Quantity quantity :
         {Quantity::number, Quantity::share, Quantity::length, Quantity::angle}) {
      allow_usage_error([&] {
        const double value = quantity_value("--flag", text, quantity, range, arguments);
        fuzz::check(value >= range.min && value <= range.max, "values are in their range");
      });
    }
    allow_usage_error([&] {
      const int value = whole_number_of("--flag", text, range);
      fuzz::check(value >= range.min && value <= range.max, "numbers are in their range");
    });
  }
}

/// A flag a line, as "--lambda-min -0.5".
Arguments arguments_in(fuzz::Bytes& bytes) {
  Arguments arguments;
  std::string_view rest = bytes.rest();
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t blank = line.find(' ');
    const std::string value(blank == line.npos ? std::string_view() : line.substr(blank + 1));
    arguments.flags[std::string(line.substr(0, blank))] = {value};
  }
  return arguments;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const Arguments arguments = arguments_in(bytes);
  for (const auto& [flag, value] : arguments.flags)
    check_value(arguments.text(flag), arguments);
  allow_usage_error([&] { unit_from(arguments); });
  allow_usage_error([&] {
    const Method method = method_from(arguments, Auto{});
    check_options(method);  // what flags let through is in range
    fuzz::check(stopping_from(arguments, method).max_sweeps >= 0, "sweeps are counted");
  });
  allow_usage_error([&] {
    if (!arguments.has("--methods")) return;
    fuzz::check(!runs_from(arguments).empty(), "something is compared");
  });
  return 0;
}

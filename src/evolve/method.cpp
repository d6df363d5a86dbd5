#include <string>

#include <planish/core/error.h>
#include <planish/evolve/method.h>

namespace planish {

namespace {

/// Looks for the name among the alternatives from I on.
template <std::size_t I = 0>
Method find_method(std::string_view name, const std::string& known) {
  if constexpr (I == k_named_methods) {
    throw Error(ErrorCode::unknown_name,
                "there is no method called \"" + std::string(name) + "\"; known are " + known);
  } else {
    using Alternative = std::variant_alternative_t<I, Method>;
    if (name == Alternative::name) return Alternative{};
    return find_method<I + 1>(name, known + (I == 0 ? "" : ", ") + std::string(Alternative::name));
  }
}

struct CheckRange {
  void operator()(std::string_view name, double value, std::string_view /*doc*/,
                  Range range) const {
    check_range(name, value, range);
  }
  void operator()(std::string_view name, const BorderFreedom& border,
                  std::string_view /*doc*/) const {
    check_range(name, border.distance, Range{0.0});
  }
  template <class Enumeration>
  void operator()(std::string_view /*name*/, Enumeration /*value*/,
                  std::string_view /*doc*/) const {}
};

}  // namespace

std::string_view name_of(const Method& method) {
  return std::visit([](const auto& options) -> std::string_view { return options.name; }, method);
}

Method method_named(std::string_view name) {
  return find_method(name, {});
}

void check_options(const Method& method) {
  if (const auto* own = std::get_if<OwnMethod>(&method); own && (own->name.empty() || !own->sweep))
    throw Error(ErrorCode::option_out_of_range, "a method of one's own has a name and a sweep");
  std::visit([](auto options) { describe(options, CheckRange{}); }, method);
  if (const auto* options = std::get_if<Auto>(&method)) require(options->limits);
}

}  // namespace planish

// All methods but the controllable one, with any options, for a few sweeps.

#include <utility>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check_evolution.h"
#include "fuzz/fill_options.h"

using namespace planish;

namespace {

template <std::size_t... I>
Method method_numbered(std::size_t number, std::index_sequence<I...>) {
  Method method;
  ((number == I ? void(method = std::variant_alternative_t<I, Method>{}) : void()), ...);
  return method;
}

bool border_stays(const Method& method) {
  if (const auto* penalty = std::get_if<GlobalPenalty>(&method))
    return penalty->border == BorderRule::fixed;
  if (const auto* descent = std::get_if<Auto>(&method)) return !descent->border.moves();
  return true;
}

template <class Options>
double deviation_limit(const Options& options) {
  if constexpr (requires { options.max_deviation; }) return options.max_deviation;
  return std::numeric_limits<double>::infinity();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  constexpr std::size_t count = k_named_methods;
  Method method = method_numbered(bytes.whole(1, count - 1), std::make_index_sequence<count>());
  std::visit([&](auto& options) { describe(options, fuzz::OptionFiller{bytes}); }, method);
  const Stopping stopping{.max_sweeps = static_cast<int>(bytes.whole(0, 5))};
  const auto mesh = fuzz::patch_from(bytes, Purpose::evolve);
  if (!mesh) return 0;
  Constraints constraints = fuzz::fixed_vertices_from(bytes, *mesh);
  if (honours_weights(method) && bytes.flag()) {
    for (std::size_t v = 0; v < mesh->positions.size(); ++v)
      constraints.weights.push_back(std::ldexp(1.0, static_cast<int>(bytes.whole(0, 38)) - 19));
  }

  const EvolveResult result = evolve(Patch(*mesh), method, stopping, constraints, {.threads = 1});
  fuzz::check_evolution(*mesh, result, constraints, border_stays(method));
  fuzz::check_deviation(*mesh, result,
                        std::visit([](const auto& o) { return deviation_limit(o); }, method));
  return 0;
}

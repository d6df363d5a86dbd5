#include "flags/method_flags.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flags/limit_flags.h"
#include "flags/material_flag.h"
#include "flags/quantities.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

/// "lambda_min" -> "--lambda-min"
std::string flag_name(std::string_view option) {
  std::string name = "--" + std::string(option);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// "0.5", "500000", "no limit"
std::string default_text(double value) {
  return std::isinf(value) ? "no limit" : plain(value);
}

/// "0 to 1, default 0.5". Bounds that nobody will reach are left out.
std::string range_text(double value, Range range) {
  const bool from = std::isfinite(range.min);
  const bool to = range.max < 1e9;
  std::string text;
  if (from && to) text = shortest(range.min) + " to " + shortest(range.max) + ", ";
  if (from && !to) text = "at least " + shortest(range.min) + ", ";
  if (!from && to) text = "at most " + shortest(range.max) + ", ";
  return text + "default " + default_text(value);
}

// Methods that have this option take --material in its place.
constexpr std::string_view k_strain_option = "max_strain";

template <class Enum>
std::vector<std::string> names_in(Enum value) {
  std::vector<std::string> names;
  for (const auto& entry : names_of(value))
    names.emplace_back(entry.second);
  return names;
}

/// The values of --border: words, or a distance.
std::vector<std::string> border_names(const BorderFreedom& border) {
  std::vector<std::string> names = names_in(border.rule);
  names.push_back("a length such as " + forms_of(Quantity::length));
  return names;
}

/// Makes a flag of every option that describe() visits.
struct FlagMaker {
  std::vector<Flag> flags;

  template <class Number>
  void operator()(std::string_view name, Number value, const char* doc, Range range) {
    const std::string forms = name == k_strain_option
                                  ? "0.02 or 2% for every edge, 2%@p99 for 99 % of the area"
                                  : forms_of(quantity_of(name));
    flags.push_back(
        {flag_name(name), std::is_integral_v<Number> ? "N" : "X",
         std::string(doc) + " (" + (forms.empty() ? "" : forms + "; ") + range_text(value, range) +
             ")",
         0, false,
         FlagValue{
             .type = std::is_integral_v<Number> ? ValueType::integer : type_of(quantity_of(name)),
             .range = range,
             .standard = std::isinf(static_cast<double>(value)) ? "" : default_text(value)}});
    if (name == k_strain_option) flags.push_back(material_flag());
  }
  void operator()(std::string_view name, const BorderFreedom& border, const char* doc) {
    flags.push_back({flag_name(name), "D",
                     std::string(doc) + " (" + list_of(border_names(border)) + ", default " +
                         names_in(border.rule).front() + ")",
                     0, false,
                     FlagValue{.type = ValueType::length,
                               .choices = names_in(border.rule),
                               .range = {.min = 0.0},
                               .standard = names_in(border.rule).front()}});
  }
  template <class Enum>
  void operator()(std::string_view name, Enum value, const char* doc) {
    std::string standard;
    for (const auto& entry : names_of(value)) {
      if (entry.first == value) standard = entry.second;
    }
    flags.push_back(
        {flag_name(name), "NAME",
         std::string(doc) + " (" + list_of(names_in(value)) + ", default " + standard + ")", 0,
         false, FlagValue{.choices = names_in(value), .standard = standard}});
  }
};

/// Sets every option that describe() visits and the command line names.
struct OptionSetter {
  const Arguments& arguments;

  void operator()(std::string_view name, double& value, const char*, Range range) const {
    const std::string flag = flag_name(name);
    if (name == k_strain_option) {
      const StrainLimits limits = limits_from(arguments);
      value = std::max(value, limits.both_ways());
    } else if (arguments.has(flag)) {
      value = quantity_value(flag, arguments.value(flag), quantity_of(name), range, arguments);
    }
  }
  void operator()(std::string_view name, int& value, const char*, Range range) const {
    const std::string flag = flag_name(name);
    if (arguments.has(flag)) value = whole_number_of(flag, arguments.value(flag), range);
  }
  void operator()(std::string_view name, BorderFreedom& border, const char*) const {
    const std::string flag = flag_name(name);
    if (!arguments.has(flag)) return;
    const Field value = arguments.value(flag);
    const bool is_length = field_text(value).find_first_of("0123456789") != std::string::npos;
    if (is_length) {
      border = {BorderFreedom::Rule::within,
                quantity_value(flag, value, quantity_of(name), Range{0.0}, arguments)};
      return;
    }
    const std::string known =
        known_name(std::string(name), field_text(value), border_names(border));
    for (const auto& [rule, rule_name] : names_of(border.rule)) {
      if (rule_name == known) border = {rule};
    }
  }
  template <class Enum>
  void operator()(std::string_view name, Enum& value, const char*) const {
    const std::string flag = flag_name(name);
    if (!arguments.has(flag)) return;
    const std::string known = known_name(std::string(name), arguments.text(flag), names_in(value));
    for (const auto& entry : names_of(value)) {
      if (entry.second == known) value = entry.first;
    }
  }
};

template <class Options>
std::vector<Flag> flags_of(Options options) {
  FlagMaker maker;
  describe(options, maker);
  return std::move(maker.flags);
}

/// Those of Stopping. Without --sweeps each method takes as many as it usually does.
std::vector<Flag> stopping_flags() {
  std::vector<Flag> flags = flags_of(Stopping{});
  for (Flag& flag : flags) {
    if (flag.name != "--sweeps") continue;
    flag.doc = "largest number of sweeps (default: the method's own)";
    flag.accepts.standard.clear();
  }
  return flags;
}

struct MethodFlags {
  std::string method;
  std::vector<Flag> flags;
  int usual_sweeps;

  bool has(std::string_view name) const {
    return std::any_of(flags.begin(), flags.end(), [&](const Flag& f) { return f.name == name; });
  }
};

template <std::size_t... I>
std::vector<MethodFlags> flags_of_methods(std::index_sequence<I...>) {
  return {{std::string(std::variant_alternative_t<I, Method>::name),
           flags_of(std::variant_alternative_t<I, Method>{}),
           std::variant_alternative_t<I, Method>::usual_sweeps}...};
}

std::vector<MethodFlags> flags_of_methods() {
  return flags_of_methods(std::make_index_sequence<k_named_methods>());
}

template <std::size_t... I>
std::vector<std::string> method_names(std::index_sequence<I...>) {
  return {std::string(std::variant_alternative_t<I, Method>::name)...};
}

void refuse_flags_of_other_methods(const std::string& chosen, const Arguments& arguments) {
  const auto methods = flags_of_methods();
  for (const auto& [flag, value] : arguments.flags) {
    std::vector<std::string> owners;
    for (const MethodFlags& method : methods) {
      if (method.has(flag)) owners.push_back(method.method);
    }
    if (owners.empty() || std::find(owners.begin(), owners.end(), chosen) != owners.end()) continue;
    throw UsageError("method " + chosen + " has no flag " + flag + "; it belongs to --method " +
                     list_of(owners));
  }
}

/// --closeness is of surfaces that stay near, --target-e-max of those that get flat, and
/// --max-bending of all but those that stay near.
void imply_preference(Auto& options, const Arguments& arguments) {
  const bool is_told = arguments.has("--prefer");
  if (arguments.has("--closeness")) {
    if (is_told && options.prefer != Prefer::near)
      throw UsageError("--closeness belongs to --prefer near: leave one of them out");
    options.prefer = Prefer::near;
  } else if (arguments.has("--target-e-max")) {
    if (is_told && options.prefer == Prefer::smooth)
      throw UsageError("--target-e-max belongs to --prefer flat or near: leave one of them out");
    if (!is_told) options.prefer = Prefer::flat;
  }
  if (options.max_bending > 0.0 && options.prefer == Prefer::near)
    throw UsageError("--max-bending belongs to --prefer smooth or flat, not to " +
                     std::string(arguments.has("--closeness") ? "--closeness" : "--prefer near"));
}

}  // namespace

std::vector<std::string> method_names() {
  return method_names(std::make_index_sequence<k_named_methods>());
}

std::vector<FlagGroup> method_flags(const Method& standard) {
  auto methods = flags_of_methods();
  const auto first = std::find_if(methods.begin(), methods.end(), [&](const MethodFlags& m) {
    return m.method == name_of(standard);
  });
  std::rotate(methods.begin(), first, first + 1);
  FlagGroup shared = {"How to evolve",
                      {{"--method",
                        "NAME",
                        list_of(method_names()) + " (default " + methods.front().method + ")",
                        0,
                        false,
                        {.choices = method_names(), .standard = methods.front().method}}}};
  for (Flag& flag : stopping_flags())
    shared.flags.push_back(std::move(flag));

  std::vector<FlagGroup> groups = {shared};
  const auto in_all = [&](const Flag& flag) {
    return std::all_of(methods.begin(), methods.end(),
                       [&](const MethodFlags& method) { return method.has(flag.name); });
  };
  for (const MethodFlags& method : methods) {
    FlagGroup own = {"With --method " + method.method + " (" + std::to_string(method.usual_sweeps) +
                         (method.usual_sweeps == 1 ? " sweep" : " sweeps") + " by default)",
                     {},
                     method.method};
    for (const Flag& flag : method.flags) {
      if (!in_all(flag)) own.flags.push_back(flag);
      if (in_all(flag) && &method == &methods.front()) groups.front().flags.push_back(flag);
    }
    groups.push_back(own);
  }
  return groups;
}

Method method_from(const Arguments& arguments, const Method& standard) {
  Method method = standard;
  if (arguments.has("--method"))
    method = method_named(known_name("method", arguments.text("--method"), method_names()));
  refuse_flags_of_other_methods(std::string(name_of(method)), arguments);
  std::visit([&](auto& options) { describe(options, OptionSetter{arguments}); }, method);
  if (auto* options = std::get_if<Auto>(&method)) imply_preference(*options, arguments);
  return method;
}

Stopping stopping_from(const Arguments& arguments, const Method& method) {
  Stopping stopping = usual_stopping(method);
  describe(stopping, OptionSetter{arguments});
  return stopping;
}

Flag remesh_flag() {
  return {"--remesh", "",
          "work on a mesh with fewer vertices, and write that mesh; all border vertices stay"};
}

Flag smooth_first_flag() {
  return {"--smooth-first",
          "LENGTH",
          "smooth the design first: takes out waves shorter than this, such as the noise of a scan "
          "(at most 20 mean edge lengths; as 5mm)",
          0,
          false,
          {.range = {.min = 0.0}}};
}

double smooth_first_from(const Arguments& arguments) {
  const std::string flag = "--smooth-first";
  if (!arguments.has(flag)) return 0.0;
  for (const char* other : {"--remesh", "--fix"}) {
    if (arguments.has(other)) throw UsageError(flag + " and " + other + " do not go together");
  }
  const double least = std::nextafter(0.0, 1.0);
  return quantity_value(flag, arguments.value(flag), Quantity::length, Range{least}, arguments);
}

FlagGroup compare_flags() {
  FlagGroup group = {"How to evolve",
                     {{"--methods",
                       "NAMES",
                       "methods to run, separated by commas: " + list_of(method_names()) +
                           "; with --with also none (default: all)",
                       0,
                       false,
                       {.choices = method_names()}}}};
  for (Flag& flag : stopping_flags())
    group.flags.push_back(std::move(flag));
  return group;
}

bool asks_for_all_methods(const Arguments& arguments) {
  return same_word(arguments.text("--methods", k_all_methods), k_all_methods);
}

bool asks_for_no_method(const Arguments& arguments) {
  return same_word(arguments.text("--methods"), "none");
}

std::vector<CompareRun> runs_from(const Arguments& arguments) {
  std::vector<CompareRun> runs;
  if (asks_for_all_methods(arguments)) {
    runs = runs_of_all_methods();
  } else {
    for (const Field& field : arguments.fields("--methods")) {
      const std::string name = field_text(field);
      const Method method = method_named(known_name("method", name, method_names()));
      for (const CompareRun& run : runs) {
        if (name_of(run.method) == name_of(method))
          throw UsageError("method " + name + " is named twice");
      }
      runs.push_back({method, usual_stopping(method)});
    }
  }
  for (CompareRun& run : runs)
    describe(run.stopping, OptionSetter{arguments});
  return runs;
}

}  // namespace planish::cli

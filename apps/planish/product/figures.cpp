#include "product/figures.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/struct_fields.h"

namespace planish::cli {

namespace {

constexpr StopReason last_of(StopReason) {
  return StopReason::design_kept;
}
constexpr Criterion last_of(Criterion) {
  return Criterion::flipped_triangles;
}
constexpr Unit last_of(Unit) {
  return Unit::in;
}

/// Puts each value behind the others of a list.
class Writer {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (list.push_back(written(values)), ...);
  }
  Json list = Json::array();

 private:
  template <class Value>
  static Json written(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      return static_cast<int>(value);
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string>) {
      return value;
    } else {
      Writer writer;
      with_fields(value, writer);
      return writer.list;
    }
  }
  template <std::size_t N>
  static Json written(const std::array<Index, N>& vertices) {
    return vertices;
  }
  template <class Value>
  static Json written(const std::optional<Value>& value) {
    return value ? written(*value) : Json(nullptr);
  }
  template <class Value>
  static Json written(const std::vector<Value>& values) {
    Json list = Json::array();
    for (const Value& value : values)
      list.push_back(written(value));
    return list;
  }
};

/// What stands there is not what Writer writes.
class BadFigures {};

/// Takes each value from a list; throws BadFigures.
class Reader {
 public:
  explicit Reader(const Json& list) : list_(list) {}

  template <class... Values>
  void operator()(Values&... values) const {
    if (!list_.is_array() || list_.size() != sizeof...(Values)) throw BadFigures();
    auto next = list_.begin();
    (read(*next++, values), ...);
  }

 private:
  template <class Value>
  static void read(const Json& json, Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      value = static_cast<Value>(whole_number(json, static_cast<int>(last_of(value))));
    } else if constexpr (std::is_same_v<Value, bool>) {
      if (!json.is_boolean()) throw BadFigures();
      value = json.get<bool>();
    } else if constexpr (std::is_integral_v<Value>) {
      value = whole_number(json, std::numeric_limits<Value>::max());
    } else if constexpr (std::is_floating_point_v<Value>) {
      if (!json.is_number()) throw BadFigures();
      value = json.get<Value>();
    } else if constexpr (std::is_same_v<Value, std::string>) {
      if (!json.is_string()) throw BadFigures();
      value = json.get<std::string>();
    } else {
      const Reader reader(json);
      with_fields(value, reader);
    }
  }
  template <std::size_t N>
  static void read(const Json& json, std::array<Index, N>& vertices) {
    if (!json.is_array() || json.size() != N) throw BadFigures();
    for (std::size_t k = 0; k < N; ++k)
      read(json[k], vertices[k]);
  }
  template <class Value>
  static void read(const Json& json, std::optional<Value>& value) {
    if (!json.is_null()) read(json, value.emplace());
  }
  template <class Value>
  static void read(const Json& json, std::vector<Value>& values) {
    if (!json.is_array()) throw BadFigures();
    for (const Json& some : json)
      read(some, values.emplace_back());
  }

  /// From 0 to the largest one.
  template <class Number>
  static Number whole_number(const Json& json, Number largest) {
    if (!json.is_number_unsigned()) throw BadFigures();
    const auto number = json.get<unsigned long long>();
    if (number > static_cast<unsigned long long>(largest)) throw BadFigures();
    return static_cast<Number>(number);
  }

  const Json& list_;
};

}  // namespace

Json figures_json(FinishedPatch patch) {
  patch.processed = {};
  patch.unfold.pattern.positions.clear();
  Writer writer;
  with_fields(patch, writer);
  return writer.list;
}

std::optional<FinishedPatch> patch_of_figures(const Json& figures) try {
  FinishedPatch patch;
  const Reader reader(figures);
  with_fields(patch, reader);
  const Pattern& pattern = patch.unfold.pattern;
  if (!pattern.unmatched_least_stretch.empty() || !pattern.least_stretch.empty())
    return std::nullopt;
  return patch;
} catch (const BadFigures&) {
  return std::nullopt;
}

}  // namespace planish::cli

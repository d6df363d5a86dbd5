#include "product/figures.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace planish::cli {

namespace {

// What is kept, listed once for writing and for reading.

template <class Visit>
void list(EdgeStrain& strain, const Visit& visit) {
  visit("max", strain.max);
  visit("rms", strain.rms);
  visit("p99", strain.p99);
  visit("worst_edge", strain.worst_edge);
  visit("max_stretch", strain.max_stretch);
  visit("p99_stretch", strain.p99_stretch);
  visit("max_compression", strain.max_compression);
  visit("p99_compression", strain.p99_compression);
}

template <class Visit>
void list(Vec3& place, const Visit& visit) {
  visit("x", place.x);
  visit("y", place.y);
  visit("z", place.z);
}

template <class Visit>
void list(StrainLimitCheck& check, const Visit& visit) {
  visit("kind", check.kind);
  visit("asked", check.asked);
  visit("reached", check.reached);
  visit("share_beyond", check.share_beyond);
  visit("edge", check.edge);
  visit("at", check.at);
}

template <class Visit>
void list(Vec2& place, const Visit& visit) {
  visit("x", place.x);
  visit("y", place.y);
}

template <class Visit>
void list(Overlap& overlap, const Visit& visit) {
  visit("low", overlap.low);
  visit("high", overlap.high);
  visit("crossings", overlap.crossings);
}

template <class Visit>
void list(OpenedCrossings& opened, const Visit& visit) {
  visit("crossings", opened.crossings);
  visit("largest_move", opened.largest_move);
  visit("vertex", opened.vertex);
}

template <class Visit>
void list(Pattern& pattern, const Visit& visit) {
  visit("width", pattern.width);
  visit("height", pattern.height);
  visit("area_ratio", pattern.area_ratio);
  visit("flipped_triangles", pattern.flipped_triangles);
  visit("overlaps", pattern.overlaps);
  visit("iterations", pattern.iterations);
  visit("converged", pattern.converged);
  visit("opened", pattern.opened);
  visit("unmatchable", pattern.is_unmatchable);
}

template <class Visit>
void list(UnfoldReport& unfold, const Visit& visit) {
  visit("pattern", unfold.pattern);
  visit("strain", unfold.strain);
  visit("unit", unfold.unit);
  visit("border_strain", unfold.border_strain);
  visit("unmatched_strain", unfold.unmatched_strain);
  visit("limits", unfold.limits);
  visit("unlimited_strain", unfold.unlimited_strain);
  visit("overlap", unfold.overlap);
}

template <class Visit>
void list(Deviation& deviation, const Visit& visit) {
  visit("rms", deviation.rms);
  visit("max", deviation.max);
  visit("rms_over_diagonal", deviation.rms_over_diagonal);
}

template <class Visit>
void list(LimitCheck& check, const Visit& visit) {
  visit("what", check.what);
  visit("limit", check.limit);
  visit("value", check.value);
  visit("met", check.met);
}

template <class Visit>
void list(FormFault& fault, const Visit& visit) {
  visit("what", fault.what);
  visit("text", fault.text);
}

template <class Visit>
void list(TwinOf& twin, const Visit& visit) {
  visit("of", twin.name);
  visit("mirrored", twin.mirrored);
}

template <class Visit>
void list(FinishedPatch& patch, const Visit& visit) {
  visit("unfold", patch.unfold);
  visit("deviation", patch.deviation);
  visit("stop", patch.stop);
  visit("twin_of", patch.twin_of);
  visit("rejected", patch.rejected);
  visit("limits", patch.limits);
  visit("form_faults", patch.form_faults);
  visit("cautions", patch.cautions);
}

constexpr StopReason last_of(StopReason) {
  return StopReason::design_kept;
}
constexpr StrainLimitKind last_of(StrainLimitKind) {
  return StrainLimitKind::p99_compression;
}
constexpr Criterion last_of(Criterion) {
  return Criterion::flipped_triangles;
}
constexpr Unit last_of(Unit) {
  return Unit::in;
}

/// Puts each value into an object.
class Writer {
 public:
  explicit Writer(Json& object) : object_(object) { object_ = Json::object(); }

  template <class Value>
  void operator()(const char* name, Value& value) const {
    write(object_[name], value);
  }

 private:
  template <class Value>
  static void write(Json& json, Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      json = static_cast<int>(value);
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string>) {
      json = value;
    } else {
      list(value, Writer(json));
    }
  }
  template <std::size_t N>
  static void write(Json& json, std::array<Index, N>& vertices) {
    json = vertices;
  }
  template <class Value>
  static void write(Json& json, std::optional<Value>& value) {
    json = nullptr;
    if (value) write(json, *value);
  }
  template <class Value>
  static void write(Json& json, std::vector<Value>& values) {
    json = Json::array();
    for (Value& value : values)
      write(json.emplace_back(), value);
  }

  Json& object_;
};

/// What stands there is not what Writer writes.
class BadFigures {};

/// Takes each value from an object; throws BadFigures.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {
    if (!object.is_object()) throw BadFigures();
  }

  template <class Value>
  void operator()(const char* name, Value& value) const {
    const auto found = object_.find(name);
    if (found == object_.end()) throw BadFigures();
    read(*found, value);
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
      list(value, Reader(json));
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

  const Json& object_;
};

}  // namespace

Json figures_json(const FinishedPatch& patch) {
  FinishedPatch figures = patch;
  Json json;
  list(figures, Writer(json));
  return json;
}

std::optional<FinishedPatch> patch_of_figures(const Json& figures) try {
  FinishedPatch patch;
  list(patch, Reader(figures));
  return patch;
} catch (const BadFigures&) {
  return std::nullopt;
}

}  // namespace planish::cli

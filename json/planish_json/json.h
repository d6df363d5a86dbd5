#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

// Library and program put JSON together from this type. It is one of nlohmann's, with a destructor
// that allocates nothing: theirs makes a list of what is to be destroyed, and where there is no
// memory for the list, the program is ended. Theirs so bears any depth; ours is for what we make
// ourselves and for what parse_shallow() lets in.

namespace planish {

/// Keeps keys in the order in which they are set. Integers are long long, so that this is a type
/// of its own, whatever others make of nlohmann's.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, long long,
                                  unsigned long long>;

}  // namespace planish

template <>
inline void planish::Json::json_value::destroy(value_t type) {
  switch (type) {
    case value_t::object:
      delete object;
      break;
    case value_t::array:
      delete array;
      break;
    case value_t::string:
      delete string;
      break;
    case value_t::binary:
      delete binary;
      break;
    default:
      break;
  }
}

namespace planish {

/// As text with an indent, or on one line where that is -1. What is no UTF-8 becomes U+FFFD, what
/// is no finite number null.
inline std::string json_text(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// What keys mean, where they stand: a change that a reader could trip over raises it
/// (docs/command-line.md, JSON).
inline constexpr int k_json_schema = 2;

/// An object as it is handed out: with its `schema` in front.
inline std::string json_document(const Json& object) {
  Json document = {{"schema", k_json_schema}};
  document.update(object);
  return json_text(document);
}

/// Reads text that anybody may have written: discarded, as of any text that is no JSON, where it
/// is nested so deep that walking through it could exhaust the stack.
inline Json parse_shallow(const std::string& text) {
  constexpr int k_deepest = 64;
  bool too_deep = false;
  Json json = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, const Json&) {
        too_deep = too_deep || depth > k_deepest;
        return !too_deep;
      },
      false);
  return too_deep ? Json(Json::value_t::discarded) : json;
}

}  // namespace planish

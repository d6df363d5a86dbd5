#include "text/json_text.h"

#include <planish_json/json.h>

namespace planish::cli {

namespace {

/// Paths may hold bytes that are no UTF-8: these become U+FFFD.
std::string text_of(const Json& json) {
  return json_document(json);
}

static_assert(k_json_schema == 2, "k_out_of_memory_json has the number too");

}  // namespace

const char* const k_out_of_memory_json =
    R"({"schema": 2, "error": {"code": "out_of_memory", "message": "out of memory"}})";

std::string json_failure(const std::string& code, const std::string& message) {
  return text_of({{"error", {{"code", code}, {"message", message}}}});
}

std::string json_version(const std::string& version) {
  return text_of({{"version", version}});
}

std::string json_written(const TriMesh& mesh, const std::string& output) {
  return text_of({{"vertices", mesh.positions.size()},
                  {"triangles", mesh.triangles.size()},
                  {"output", output}});
}

std::string json_page(const std::string& output) {
  return text_of({{"output", output}});
}

std::string json_samples(std::span<const Shape> shapes) {
  Json list = Json::array();
  for (const Shape& shape : shapes) {
    list.push_back({{"name", std::string(shape.name)},
                    {"description", std::string(shape.description)},
                    {"flattenable", shape.flattenable}});
  }
  Json object;
  object["samples"] = list;
  return text_of(object);
}

MoreFigures figures_of(const DirectionCounts& counts) {
  return {"directions",
          {{"flat", counts.flat},
           {"dome_or_cup", counts.dome_or_cup},
           {"saddle", counts.saddle},
           {"can_lower", counts.can_lower},
           {"stuck", counts.stuck}}};
}

}  // namespace planish::cli

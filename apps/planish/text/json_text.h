#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <planish/mesh/shapes.h>
#include <planish/report/json_report.h>

#include "evolve/direction.h"

namespace planish::cli {

/// A failure that is none of the library's: {"error": {"code", "message"}}.
std::string json_failure(const std::string& code, const std::string& message);

/// The failure of a run that has used up its memory, which may not even have enough to make text.
extern const char* const k_out_of_memory_json;

/// {"version"}
std::string json_version(const std::string& version);

/// A mesh that was written: {"vertices", "triangles", "output"}.
std::string json_written(const TriMesh& mesh, const std::string& output);

/// A page that was written: {"output"}.
std::string json_page(const std::string& output);

/// {"samples": [{"name", "description", "flattenable"}]}
std::string json_samples(std::span<const Shape> shapes);

/// A count of "directions": {"flat", "dome_or_cup", "saddle", "can_lower", "stuck"}, for a report.
MoreFigures figures_of(const DirectionCounts& counts);

}  // namespace planish::cli

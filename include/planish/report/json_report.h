#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <planish/core/error.h>
#include <planish/flatten/compare.h>
#include <planish/flatten/flatten.h>
#include <planish/flatten/frontier.h>
#include <planish/flatten/product.h>
#include <planish/io/mesh_format.h>
#include <planish/sheet/nest_sheet.h>

namespace planish {

/// Figures of a program's own, an object at the end of a report.
struct MoreFigures {
  std::string key;  ///< of the object
  /// What is in it, in this order: key and number.
  std::vector<std::pair<std::string, std::variant<std::size_t, double>>> figures;
};

/// Role -> path of what was written.
using WrittenFiles = std::map<std::string, std::string>;

/// The sheets of one material.
struct MaterialLayout {
  std::string material = {};  ///< empty for pieces without one
  NestOptions sheets = {};    ///< their size
  std::size_t first = 0;      ///< number of the first of them, from 0
  std::size_t count = 0;      ///< how many
  double used_length = 0.0;   ///< of the last of them, millimetres
  double used_share = 0.0;    ///< share of their area that ends up in pieces
};

/// Where patches were laid on sheets, or why they could not be.
struct LayoutReport {
  NestOptions sheets = {};                 ///< what was asked for; of several the first
  std::vector<MaterialLayout> materials;   ///< in the order of the sheets
  std::vector<std::string> names = {};     ///< of the patches, by their numbers
  std::vector<std::string> left_out = {};  ///< those without a pattern
  Nesting nesting = {};                    ///< where the pieces lie
  std::vector<std::string> files = {};     ///< paths of the drawings
  std::optional<Failure> failure = {};     ///< then all above but the sheets is not known
};

/// Adds the names in a job and how its pieces were laid, on sheets behind those that are there.
void add_layout(const std::string& material, const NestJob& job, const Nesting& nesting,
                LayoutReport& layout);

/// What was written of a product.
struct ProductFiles {
  std::vector<std::string> folders;  ///< of the patches, by their numbers
  std::vector<WrittenFiles> files;   ///< likewise
};

/// Reports as JSON text, keys as the command line documents them (docs/command-line.md): one
/// object, UTF-8, numbers in the shortest digits that read back to the same doubles, numbers that
/// are not finite as null.
/// With "strain" and "limits"; without a strain, as of what cannot be laid flat, null and empty.
/// @param cautions as find_cautions() of the patch
/// @param unit one unit of the model, for the messages of cautions
std::string json_report(const MeasuredPatch& patch,
                        const std::optional<StrainAsDesigned>& strain = {},
                        const std::vector<Caution>& cautions = {}, Unit unit = Unit::mm,
                        const std::vector<MoreFigures>& more = {});
/// With before and after, deviation and history.
/// @param cautions as find_cautions() of the patch
/// @param unit one unit of the model, for the messages of cautions
std::string json_report(const EvolveReport& report, const std::vector<Caution>& cautions = {},
                        Unit unit = Unit::mm, const std::vector<MoreFigures>& more = {});
/// With strain, sizes and limits.
/// @param cautions as find_cautions() of the patch
std::string json_report(const UnfoldReport& report, const std::vector<Caution>& cautions = {},
                        const std::vector<MoreFigures>& more = {});
/// @param layout as "nesting", where there is one
std::string json_report(const FlattenReport& report, const WrittenFiles& files,
                        const std::vector<MoreFigures>& more = {},
                        const std::optional<LayoutReport>& layout = {});
/// As docs/garments.md has it.
/// @param name of the product
/// @param layout as "nesting"; null without
/// @param cut as "cut", whatever its key: what was cut to make the patches; null without
std::string json_report(const ProductReport& report, const std::string& name,
                        const ProductFiles& files, const std::optional<LayoutReport>& layout = {},
                        const std::optional<MoreFigures>& cut = {});
/// With the runs in their order.
std::string json_report(const CompareReport& report);
/// With the points of the curve and of other methods.
std::string json_report(const FrontierReport& report);
/// {"error": {code, message, path, line, byte, first, count}}, keys that are not known left out.
std::string json_report(const Error& error);

/// The figures of vertices and triangles of a patch that JSON has the largest and the sums of.
/// Vertices: inner (1 or 0), defect, mean_curvature (vertex_mean_curvatures()) and, with a pattern,
/// edge_strain, the strain of largest size of the edges of the vertex with its sign. Triangles,
/// with a pattern: strain_max and strain_min, the principal stretches minus 1. Units and
/// definitions are in docs/fields.md.
/// @param pattern one position per vertex of the mesh, model units; none where there is no pattern
MeshFields fields_of(const Patch& patch, std::span<const Vec2> pattern = {});

/// The same of the processed patch, and of the input with "input_" before the name; of vertices
/// also offset, how far the vertex went along the normal of the input, and move, how far in all,
/// model units.
MeshFields fields_of(const FlattenReport& report);

/// The history as comma-separated values: a header line, then a line a sweep.
std::string history_csv(const std::vector<SweepRecord>& history);

/// The histories of all methods likewise, a line a sweep, methods in their order.
std::string history_csv(const CompareReport& report);

/// The border from corner to corner, as comma-separated values: loop, from_vertex, to_vertex,
/// length, length_on_model; with named edges also their names. Vertices from 0, lengths in
/// millimetres; in inches where the sheet has them, as length_in and length_on_model_in.
/// @param pattern a place for every vertex, model units
std::string edge_lengths_csv(const Patch& patch, std::span<const Vec2> pattern, Unit unit,
                             const PatternOptions& options = {});

}  // namespace planish

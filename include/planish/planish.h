#pragma once

/// @file
/// All of the library.

/// @namespace planish
/// Everything that the library has.

#include <planish/core/context.h>
#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/core/unit.h>
#include <planish/core/vec.h>
#include <planish/core/ways_on.h>
#include <planish/draw/color.h>
#include <planish/draw/drawing.h>
#include <planish/draw/format_drawing.h>
#include <planish/evolve/constraints.h>
#include <planish/evolve/evolve.h>
#include <planish/evolve/evolver.h>
#include <planish/evolve/method.h>
#include <planish/evolve/remesh.h>
#include <planish/flatten/compare.h>
#include <planish/flatten/flatten.h>
#include <planish/flatten/frontier.h>
#include <planish/flatten/product.h>
#include <planish/flatten/ways.h>
#include <planish/io/mesh_format.h>
#include <planish/io/model.h>
#include <planish/io/read_features.h>
#include <planish/io/read_mesh.h>
#include <planish/io/write_file.h>
#include <planish/measure/cautions.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/measure/form_change.h>
#include <planish/measure/limit_check.h>
#include <planish/measure/material.h>
#include <planish/measure/obstruction.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/geodesic.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>
#include <planish/mesh/shapes.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/mesh/wall.h>
#include <planish/mesh/weld.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/curve.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/nest.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/pattern_options.h>
#include <planish/pattern/piece_outline.h>
#include <planish/pattern/read_annotations.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>
#include <planish/sheet/nest_sheet.h>
#include <planish/sheet/pattern_geometry.h>
#include <planish/sheet/pattern_sheet.h>
#include <planish/sheet/product_sheet.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/suggest_cuts.h>
#include <planish/unfold/unfold.h>

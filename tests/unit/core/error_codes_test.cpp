// Every code of an error is one that happens: here is how to get each.

#include <filesystem>
#include <functional>
#include <map>

#include <planish/evolve/evolve.h>
#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>
#include <planish/mesh/symmetry.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/nest.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/read_annotations.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "platform/path.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Code = ErrorCode;
using Reproduction = std::function<void()>;

Reproduction reading(const std::string& text) {
  return [text] { parse_mesh(text, MeshFormat::obj, "a.obj"); };
}

const std::string k_corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n";

/// A mesh of those faces over four corners, wanted for a purpose.
Reproduction wanting(Purpose purpose, const std::string& faces) {
  return [=] { require(inspect(parse_mesh(k_corners + faces, MeshFormat::obj).mesh), purpose); };
}

Reproduction wanting(Purpose purpose, const TriMesh& mesh) {
  return [=] { require(inspect(mesh), purpose); };
}

/// The problem of that code, which blocks nothing, as an error.
Reproduction telling(Code code, const std::string& text) {
  return [=] {
    for (const Problem& problem : inspect(parse_mesh(text, MeshFormat::obj).mesh).problems) {
      if (problem.code == code) throw Error(problem.code, problem.message);
    }
  };
}

/// A bag of three corners around: laid flat its bottom is smaller than numbers can tell.
TriMesh bag() {
  TriMesh mesh = meshes::tube(3, 1500);
  mesh.triangles.push_back({2, 1, 0});
  return mesh;
}

PieceOutline square_piece(double side) {
  return {"piece", {{{0, 0}, {side, 0}, {side, side}, {0, side}}}, {{3, 7, 9, 20}}};
}

PieceOutline with_hole() {
  PieceOutline piece{"piece",
                     {square_piece(100).loops[0], {{40, 40}, {40, 45}, {45, 45}, {45, 40}}}};
  return piece;
}

TriMesh torus_with_a_hole() {
  TriMesh mesh = meshes::torus(6, 8);
  mesh.triangles.pop_back();
  return mesh;
}

std::filesystem::path folder_that_is_there() {
  const auto folder = path_of(testing::TempDir()) / "planish_folder.obj";
  std::filesystem::create_directories(folder);
  return folder;
}

const std::map<Code, Reproduction>& reproductions() {
  static const TriMesh grid = meshes::flat_grid(4, 4);
  static const std::string triangle = k_corners + "f 1 2 3\n";
  static const std::map<Code, Reproduction> all = {
      {Code::file_not_found, [] { read_mesh("no such file.obj"); }},
      {Code::file_unreadable, [] { read_mesh(folder_that_is_there()); }},
      {Code::file_unwritable, [] { write_mesh(folder_that_is_there(), grid); }},
      {Code::unsupported_format, [] { read_mesh("a.xyz"); }},
      {Code::malformed_file, reading("A letter.\n")},
      {Code::truncated_file, [] { parse_mesh("ply\nformat ascii 1.0\n", MeshFormat::ply); }},
      {Code::bad_number, reading("v 0 zero 0\n")},
      {Code::index_out_of_range, reading(k_corners + "f 1 2 9\n")},
      {Code::no_triangles, reading(k_corners)},
      {Code::too_large,
       [] {
         nest(std::vector<NestPiece>{{square_piece(10), 10'001}}, {});
       }},
      {Code::non_finite_coordinate, reading("v 0 nan 0\n")},
      {Code::repeated_index, wanting(Purpose::measure, "f 1 2 2\n")},
      {Code::duplicate_triangle, wanting(Purpose::measure, "f 1 2 3\nf 1 2 3\n")},
      {Code::zero_length_edge, wanting(Purpose::measure, "v 1 0 0\nf 1 2 5\n")},
      {Code::zero_area, telling(Code::zero_area, "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")},
      {Code::non_manifold_edge, wanting(Purpose::measure, "v 5 5 5\nf 1 2 3\nf 2 1 4\nf 1 2 5\n")},
      {Code::non_manifold_vertex, wanting(Purpose::measure, "v 5 5 5\nf 1 2 3\nf 1 4 5\n")},
      {Code::inconsistent_orientation, wanting(Purpose::measure, "f 1 2 3\nf 1 2 4\n")},
      {Code::non_orientable, wanting(Purpose::measure, meshes::moebius(9))},
      {Code::closed_surface, wanting(Purpose::evolve, meshes::tetrahedron())},
      {Code::open_surface,
       [] {
         const TriMesh dome = make_shape("dome", 100);
         evolve(Patch(dome), LocalPerturbation{}, {}, {.obstacle = grid}, {.threads = 1});
       }},
      {Code::several_components, wanting(Purpose::unfold, meshes::side_by_side(grid, grid))},
      {Code::several_border_loops, wanting(Purpose::unfold, meshes::tube(6, 3))},
      {Code::handles, wanting(Purpose::unfold, torus_with_a_hole())},
      {Code::no_inner_vertex, wanting(Purpose::evolve, "v 5 0 0\nv 6 0 0\nf 1 2 3\nf 4 5 6\n")},
      {Code::unreferenced_vertex, telling(Code::unreferenced_vertex, triangle)},
      {Code::option_out_of_range,
       [] { evolve(Patch(grid), ControllableLaplacian{.lambda_max = -1.0}); }},
      {Code::unknown_name, [] { make_shape("ball", 100); }},
      {Code::unsupported_constraint,
       [] {
         evolve(Patch(grid), ControllableLaplacian{}, {}, {.obstacle = grid}, {.threads = 1});
       }},
      {Code::misplaced_cut,
       [] {
         cut_open(Patch(grid), std::vector<CutPath>{{{0, 1}, {}}});
       }},
      {Code::not_symmetric,
       [] {
         const Patch patch(grid);
         require_symmetric(patch, symmetry_in(patch, {{1.0, 0.0, 0.0}, 0.0}));
       }},
      {Code::method_failed,
       [] {
         const OwnMethod loses = {.sweep = [](const SweepInput&) { return std::vector<Vec3>(); }};
         evolve(Patch(make_shape("dome", 100)), loses, {}, {}, {.threads = 1});
       }},
      {Code::unfold_failed,
       [] {
         const TriMesh mesh = bag();
         unfold(Patch(mesh));
       }},
      {Code::overlapping_outline,
       [] {
         offset_outline({"eight", {{{0, 0}, {9, 9}, {9, 0}, {0, 10}}}}, {.width = 1.0});
       }},
      {Code::allowance_too_wide, [] { offset_outline(with_hole(), {.width = 10.0}); }},
      {Code::misplaced_allowance,
       [] {
         with_edge_allowances({}, square_piece(100), std::vector<EdgeAllowance>{{3, 8, 1.0}});
       }},
      {Code::misplaced_mark, [] { parse_drawn_marks("v 0 0 99\np 1\n", Patch(grid), "m.obj"); }},
      {Code::misplaced_notch,
       [] {
         const PieceOutline piece = square_piece(100);
         place_notches(piece, piece.loops, std::vector<Notch>{Notch::at_fraction(1.5)}, {});
       }},
      {Code::no_grain_direction,
       [] {
         std::vector<Vec2> pattern;
         for (const Vec3& p : grid.positions)
           pattern.push_back({p.x, p.y});
         grain_direction(grid, pattern, {0, 0, 1}, "piece");
       }},
      {Code::piece_too_large, [] { nest(std::vector<NestPiece>{{square_piece(1e4)}}, {}); }}};
  return all;
}

TEST(ErrorCodes, AreAllThrownForAReasonWithAMessage) {
  for (int number = 0; to_string(static_cast<Code>(number)) != "unknown"; ++number) {
    const auto code = static_cast<Code>(number);
    const auto reproduction = reproductions().find(code);
    if (reproduction == reproductions().end()) {
      ADD_FAILURE() << "nothing here leads to " << to_string(code);
      continue;
    }
    try {
      reproduction->second();
      ADD_FAILURE() << "no error " << to_string(code);
    } catch (const Error& error) {
      EXPECT_EQ(to_string(error.code()), to_string(code)) << error.what();
      EXPECT_GT(error.message().size(), 10U);
      EXPECT_LT(error.message().size(), 400U);
    }
  }
}

}  // namespace
}  // namespace planish

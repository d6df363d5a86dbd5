#include <planish/core/ways_on.h>

namespace planish {

std::string_view way_on(ErrorCode code) {
  switch (code) {
    case ErrorCode::file_not_found:
      return "Check the name and the folder; planish sample makes a patch to try with";
    case ErrorCode::file_unreadable:
      return "Check what it is and who may read it; of a folder, mesh files in it are read";
    case ErrorCode::file_unwritable:
      return "Make room there, or write elsewhere with --output";
    case ErrorCode::unsupported_format:
      return "Give .obj, .ply, .stl or .off; planish convert writes each as another";
    case ErrorCode::malformed_file:
    case ErrorCode::bad_number:
      return "Mend the file at that place; a mesh can also be exported again as .obj, .ply, .stl "
             "or .off";
    case ErrorCode::truncated_file:
      return "Copy or export the file again";
    case ErrorCode::index_out_of_range:
      return "Mend or export the file again; in files of --fix and --weights the first vertex is 0";
    case ErrorCode::no_triangles:
      return "Export a mesh with faces; where flags leave nothing, look at --only and --without";
    case ErrorCode::too_large:
      return "Simplify the mesh, or work on fewer vertices with --remesh; for pages and sheets "
             "check "
             "--unit";
    case ErrorCode::non_finite_coordinate:
      return "Mend the coordinates in the program that made the file; --scale may be too large";
    case ErrorCode::repeated_index:
      return "Without --strict such triangles are left out";
    case ErrorCode::duplicate_triangle:
      return "Of two that face each other delete one in the program that made the mesh; of two "
             "that "
             "are alike the second is left out, but not with --strict";
    case ErrorCode::zero_length_edge:
      return "Merge these vertices in the program that made the mesh; planish measure tells how "
             "many there are";
    case ErrorCode::zero_area:
      return "It stops nothing; --remesh makes better triangles";
    case ErrorCode::non_manifold_edge:
      return "Panels that meet are divided there without --strict, if no triangle of theirs is "
             "there twice or turned over; --divide objects keeps those with names apart";
    case ErrorCode::non_manifold_vertex:
      return "Without --strict parts are divided there; --weld joins edges that lie on each other, "
             "--fill-holes LENGTH closes holes that touch";
    case ErrorCode::inconsistent_orientation:
      return "Without --strict such triangles are turned over";
    case ErrorCode::non_orientable:
      return "Divide the band in the program that made it, and take one part after the other with "
             "--only NAME";
    case ErrorCode::closed_surface:
      return "Cut it open with --cut open, or along lines of your own with --cut FILE (planish "
             "suggest-cuts finds where); of a wall take --side outer; leave a piece out with "
             "--without NAME";
    case ErrorCode::open_surface:
      return "Close it in the program that made it, or leave --obstacle out";
    case ErrorCode::several_components:
      return "Take one with --only NAME, lay all flat with planish flatten, or join those that "
             "touch with --weld";
    case ErrorCode::several_border_loops:
      return "Cut a tube open with --cut open, or along lines of your own with --cut FILE; join an "
             "open seam with --weld";
    case ErrorCode::handles:
      return "Cut each handle open with --cut open, or along lines of your own with --cut FILE";
    case ErrorCode::no_inner_vertex:
      return "Join loose triangles with --weld; mesh a piece that is one with several rows of "
             "facets "
             "across";
    case ErrorCode::unreferenced_vertex:
      return "It stops nothing";
    case ErrorCode::option_out_of_range:
      return "planish describe lists the range of every flag";
    case ErrorCode::unknown_name:
      return "planish describe lists the names that flags take";
    case ErrorCode::unsupported_constraint:
      return "Leave one of them out, or choose another --method";
    case ErrorCode::misplaced_cut:
      return "Mend that --cut; planish panels finds where to cut";
    case ErrorCode::not_symmetric:
      return "Leave --symmetric out, or take one half for both: --symmetric PLANE --mirror-surface";
    case ErrorCode::method_failed:
      return "Mend the method, or its program; docs/research.md says what it is given and must "
             "give";
    case ErrorCode::unfold_failed:
      return "Cut it with --cut FILE (planish suggest-cuts finds where), or mesh it anew with "
             "--remesh";
    case ErrorCode::overlapping_outline:
      return "Leave --allowance out, or divide the patch with --cut FILE";
    case ErrorCode::allowance_too_wide:
      return "Make --allowance less, set it edge by edge with --edge-allowances FILE, or leave it "
             "out "
             "in holes with --hole-allowance no";
    case ErrorCode::misplaced_allowance:
      return "Give other vertices to --edge-allowances or --fold";
    case ErrorCode::misplaced_notch:
      return "Give other places to --notches or --seam-notches";
    case ErrorCode::misplaced_mark:
      return "Draw it over the mesh for --marks or --inner-lines, or give the mesh its --unit";
    case ErrorCode::no_grain_direction:
      return "Give the grain as an angle, as in --grain 90";
    case ErrorCode::piece_too_large:
      return "Take a larger --sheet, allow more with --turn, or divide the patch with --cut FILE";
  }
  return "planish measure tells more";
}

std::string with_way_on(const Error& error) {
  const std::string said = error.what();
  const bool is_question = said.ends_with('?');
  return said + (is_question ? " " : ". ") + std::string(way_on(error.code()));
}

}  // namespace planish

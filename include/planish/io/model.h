#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/io/read_mesh.h>

namespace planish {

/// What makes pieces of a file. Where triangles of one part do not hang together by edges, each
/// connected part is a piece, whatever it is.
enum class Divide {
  objects,    ///< its objects, else its groups
  materials,  ///< its materials
  parts,      ///< nothing else
};

/// A side of a wall, a sheet that was given a thickness.
enum class Side {
  outer,  ///< the one that bulges, with normals away from the other
  inner,
};

/// "objects", "outer"
std::string_view to_string(Divide divide);
/// The same of a side.
std::string_view to_string(Side side);

/// How the mesh of a file becomes pieces.
struct ModelOptions {
  /// Take the mesh as it is: nothing is mended, turned or left out that was not asked for.
  bool strict = false;
  /// Join borders that lie on each other within this length, model units; 0 for a length that fits
  /// the size of the mesh. None: nothing is joined.
  std::optional<double> weld = {};
  /// Close holes whose border is at most this long, model units; 0 for none.
  double fill_holes = 0.0;
  Divide divide = Divide::objects;  ///< what makes pieces
  /// Take these pieces, by the names of their objects, groups and materials or their own; empty for
  /// all.
  std::vector<std::string> only = {};
  std::vector<std::string> without = {};  ///< leave these out
  std::optional<Side> side = {};          ///< of walls, take this side only
  bool flip = false;                      ///< turn the surface over at the end
};

/// What preparing a model did, and what it found that one may want to ask for: counts, 0 for none.
struct ModelWork {
  std::size_t collapsed = 0;        ///< triangles left out that named a vertex twice
  std::size_t repeated = 0;         ///< and that were there already
  std::size_t backs = 0;            ///< and of the back of a doubled sheet
  std::size_t fins = 0;             ///< and of crumbs that stand on the surface
  std::size_t turned = 0;           ///< triangles turned over, as they ran against their neighbours
  std::size_t parted_edges = 0;     ///< edges of more than two triangles, where it was divided
  std::size_t parted_vertices = 0;  ///< vertices that parts shared, where it was divided
  double weld_length = 0.0;         ///< that borders were welded within, model units, the largest
  std::size_t joined = 0;           ///< border edges that became one with another
  std::size_t unjoined = 0;         ///< border edges that lie on others and could not be joined
  std::size_t held = 0;             ///< border vertices whose edges are too short for weld_length
  /// Where welding was asked for and joined nothing.
  struct NothingJoined {
    std::optional<double> gap = {};  ///< nearest_border_gap() of the pieces
    bool is_between_names = false;   ///< it is within the length, but between different names
  };
  std::optional<NothingJoined> nothing_joined = {};  ///< else nothing
  std::size_t crumbs = 0;                            ///< connected parts left out
  double crumb_share = 0.0;                          ///< of the area, that they held
  std::size_t filled = 0;                            ///< holes that were closed
  std::size_t unfilled = 0;  ///< holes short enough that could not be closed
  /// A part, or a piece of one, that is a wall of which no side was asked for.
  struct FoundWall {
    std::string name;        ///< of the part or piece
    double thickness = 0.0;  ///< model units
    bool is_open = false;    ///< one sheet with a border, as a flat sleeve has too
  };
  /// In the order of the parts.
  std::vector<FoundWall> walls = {};
  /// Walls of which a side was taken though nothing tells the outer one: Wall::is_level.
  std::vector<std::string> level_walls = {};
  /// Two walls side by side of which sides were taken that do not meet.
  struct ClashingSides {
    std::string one, other;  ///< names of the parts or pieces
  };
  /// Also with one that is left out.
  std::vector<ClashingSides> clashing_sides = {};
  /// Parts, or pieces of them, of which a side was asked for and that are no wall.
  std::vector<std::string> without_wall = {};
  /// A piece that lies on another one all over, as one sheet that is there twice does.
  struct Lying {
    std::string piece;  ///< name of the one that lies
    std::string on;     ///< name of the other one
  };
  std::vector<Lying> lying = {};  ///< in the order of the pieces
  std::size_t touching = 0;       ///< pieces that touch others along whole sides
  std::size_t welded = 0;         ///< pieces that welding would make of these
  bool renumbered = false;        ///< vertices have other numbers than in the file
};

/// A piece that `only` and `without` leave out. Its place tells how the others have to lie.
struct LeftOutPiece {
  std::string name;        ///< as in the whole file
  TriMesh mesh;            ///< prepared as the others are
  std::size_t before = 0;  ///< in the file it comes before this piece of the model
};

/// The mesh of a file as everything works on it, and its pieces.
struct Model {
  /// Vertices in the order of the file, new ones behind. What is left out is gone with its
  /// vertices. Pieces may share vertices: divided() gives each its own.
  TriMesh mesh;
  MeshFormat format = MeshFormat::obj;  ///< of the file
  std::vector<std::string> notes = {};  ///< what its reader did
  ModelWork work = {};                  ///< what was done then
  /// Their names, no two alike; empty where the options leave nothing. They do not depend on what
  /// is left out.
  std::vector<std::string> pieces = {};
  std::vector<Index> piece_of = {};  ///< of each triangle: the number of its piece
  std::string divided_by = {};       ///< what they are in the file: "o", "usemtl"; empty: nothing
  std::vector<std::string> names = {};      ///< all that `only` and `without` may name, in order
  std::vector<LeftOutPiece> left_out = {};  ///< in the order of the file
  /// Its one piece was turned over, as it was inside out against one that is left out. For those
  /// who judge that: prepare_model() does not.
  bool turned = false;
};

/// Mends a mesh, takes of it what was asked for, and divides it into pieces. A piece has the name
/// of its part of the file, or that of the file; of several with one name each has a number behind
/// it, as in "sleeve-2", and names that differ by capitals only get one too. Crumbs are left out:
/// connected parts with less than 1 % of the area of the part that has their name. A part with a
/// name of its own is never a crumb. Notes say what was done, and how often. A sound mesh
/// comes out as it is, with every bit.
/// @param name of the file
/// @throws Error option_out_of_range for lengths below 0; no_triangles where nothing is left;
///   as weld() and fill_holes(). Names that are not there: see check_names()
Model prepare_model(ReadResult file, const ModelOptions& options, const std::string& name);

/// @param names what there is, as in Model
/// @throws Error unknown_name where `only` or `without` has another one, which lists those there
/// are
void check_names(const ModelOptions& options, std::span<const std::string> names);

/// The mesh of a model in which pieces share no vertices: copies come behind all others.
TriMesh divided(const Model& model);

}  // namespace planish

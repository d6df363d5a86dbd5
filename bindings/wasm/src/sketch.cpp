#include "sketch.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#include <planish/core/error.h>
#include <planish/core/ways_on.h>
#include <planish/io/model.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include "core/thread_pool.h"
#include "cut/cut_flag.h"
#include "panels/cells/thinned_product.h"
#include "parse.h"
#include "shell/file_name.h"
#include "shell/session.h"

namespace planish::wasm {

namespace {

constexpr std::size_t k_vertices = 1800;  // in all, about
constexpr std::size_t k_least = 60;       // of a part
constexpr int k_steps = 40;               // Newton's, at most

/// Part by part, as each has to keep its shape.
TriMesh thinned(const TriMesh& mesh, const std::string& name, std::size_t vertices) {
  if (mesh.positions.size() <= vertices) return mesh;
  const ThreadPool pool(1);
  TriMesh all;
  for (const NamedPatch& part : split(mesh, name)) {
    const std::size_t share = vertices * part.mesh.positions.size() / mesh.positions.size();
    const Patch thin = thinned_product(Patch(part.mesh), std::max(k_least, share), pool);
    const auto first = static_cast<Index>(all.positions.size());
    all.positions.insert(all.positions.end(), thin.positions().begin(), thin.positions().end());
    for (const Triangle& t : thin.mesh().triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return all;
}

bool is_same(const TriMesh& a, const TriMesh& b) {
  return a.triangles == b.triangles && a.positions == b.positions;
}

void lay_flat(SketchPiece& piece) {
  const Patch patch(piece.surface);
  const Pattern pattern = unfold(patch, {.max_iterations = k_steps, .least_stretch = true});
  piece.pattern = flat_mesh(piece.surface, pattern);
  const auto stretches = principal_stretches(piece.surface, pattern.positions);
  piece.strain.clear();
  for (const double strain : signed_strains(stretches))
    piece.strain.push_back(static_cast<float>(strain));
}

}  // namespace

Sketch::Sketch(std::span<const std::string> paths) {
  for (const std::string& path : paths) {
    const TriMesh mesh = divided(prepare_model(read_mesh(path), {}, path));
    parts_.push_back({path, thinned(mesh, path, k_vertices / paths.size())});
  }
}

TriMesh Sketch::cut(const Part& part, const std::vector<std::string>& words,
                    SketchPieces& made) const {
  if (parts_.size() > 1) return part.mesh;
  const cli::Parsed parsed = cli::parse(words);
  std::ostringstream said;
  const cli::RunContext context;
  cli::Session session(parsed.arguments, said, context);
  TriMesh mesh = part.mesh;
  try {
    mesh = cli::cut_as_asked(part.mesh, part.path, parsed.arguments, session).mesh;
  } catch (const Error& error) {
    said << with_way_on(error);
  }
  made.hint = said.str();
  return mesh;
}

SketchPiece Sketch::laid(NamedPatch part, std::string& hint) const {
  const auto known = std::find_if(last_.begin(), last_.end(), [&](const SketchPiece& piece) {
    return is_same(piece.surface, part.mesh);
  });
  SketchPiece piece{std::move(part.name), std::move(part.mesh), {}, {}};
  if (known != last_.end()) {
    piece.pattern = known->pattern;
    piece.strain = known->strain;
    return piece;
  }
  piece.strain.assign(piece.surface.triangles.size(), 0.0F);
  try {
    lay_flat(piece);
  } catch (const Error& error) {
    if (hint.empty()) hint = with_way_on(error);
  }
  return piece;
}

SketchPieces Sketch::laid(const std::vector<std::string>& words) {
  SketchPieces made;
  for (const Part& part : parts_) {
    for (NamedPatch& piece : split(cut(part, words, made), cli::stem_of(part.path)))
      made.pieces.push_back(laid(std::move(piece), made.hint));
  }
  last_ = made.pieces;
  return made;
}

}  // namespace planish::wasm

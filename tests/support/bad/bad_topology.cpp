#include <algorithm>

#include "support/bad/sound_files.h"
#include "support/meshes.h"

namespace planish::bad {
namespace {

/// A mesh in every format that keeps vertex numbers.
class MeshFiles {
 public:
  void same(const std::string& name, const TriMesh& mesh) {
    for_formats(mesh, [&](Collection& files, const std::string& bytes) {
      files.same("topology_" + name, bytes);
    });
  }
  void accept(const std::string& name, const TriMesh& mesh, std::optional<ErrorCode> told = {}) {
    for_formats(mesh, [&](Collection& files, const std::string& bytes) {
      files.accept("topology_" + name, bytes, told);
    });
  }
  void refuse(const std::string& name, const TriMesh& mesh, ErrorCode code,
              std::optional<std::size_t> first, Purpose blocks = Purpose::measure) {
    for_formats(mesh, [&](Collection& files, const std::string& bytes) {
      files.as_mesh("topology_" + name, bytes, code, first, blocks);
    });
  }
  BadMeshes take() {
    BadMeshes all;
    for (Collection* files : {&obj_, &off_, &ply_})
      append(all, files->take());
    return all;
  }

 private:
  template <class Add>
  void for_formats(const TriMesh& mesh, Add add) {
    add(obj_, sound_obj(mesh).lines.text());
    add(off_, sound_off(mesh).lines.text());
    add(ply_, binary_ply(mesh));
  }

  Collection obj_{"obj_", ".obj"}, off_{"off_", ".off"}, ply_{"ply_", ".ply"};
};

TriMesh with_triangle(TriMesh mesh, Triangle triangle) {
  mesh.triangles.push_back(triangle);
  return mesh;
}

TriMesh with_vertex(TriMesh mesh, Vec3 p) {
  mesh.positions.push_back(p);
  return mesh;
}

TriMesh with_flipped(TriMesh mesh, std::size_t begin, std::size_t end, std::size_t step = 1) {
  for (std::size_t t = begin; t < end; t += step)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  return mesh;
}

TriMesh without_cells(TriMesh mesh, const std::vector<std::size_t>& cells) {
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) {
    const auto at = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(2 * *cell);
    mesh.triangles.erase(at, at + 2);
  }
  return mesh;
}

/// Two copies of a mesh that share one vertex.
TriMesh glued_at(const TriMesh& mesh, Index vertex) {
  TriMesh both = meshes::side_by_side(mesh, mesh);
  const auto copy = static_cast<Index>(mesh.positions.size()) + vertex;
  for (Triangle& t : both.triangles) {
    for (Index& v : t)
      v = v == copy ? vertex : v > copy ? v - 1 : v;
  }
  both.positions.erase(both.positions.begin() + copy);
  return both;
}

/// Cut open along the middle row of the grid, from column `begin` to `end`: those vertices double.
TriMesh with_slit(TriMesh mesh, Index begin, Index end) {
  for (Index column = begin; column <= end; ++column) {
    const Index v = 10 + column;
    mesh.positions.push_back(mesh.positions[v]);
    const auto copy = static_cast<Index>(mesh.positions.size() - 1);
    for (std::size_t t = 16; t < 32; ++t)
      std::replace(mesh.triangles[t].begin(), mesh.triangles[t].end(), v, copy);
  }
  return mesh;
}

/// A torus glued with a flip: no inside and no outside.
TriMesh klein_bottle() {
  constexpr std::size_t n = 6;
  TriMesh mesh;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i)
      mesh.positions.push_back({static_cast<double>(i), static_cast<double>(j),
                                0.25 * static_cast<double>((i * i + j) % 4)});
  }
  const auto at = [](std::size_t i, std::size_t j) {
    const std::size_t column = i < n ? i : 0, row = i < n ? j % n : (n - j % n) % n;
    return static_cast<Index>(row * n + column);
  };
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Half an icosahedron with opposite border points glued.
TriMesh projective_plane() {
  TriMesh mesh = meshes::fan(5, 1.0);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  return mesh;
}

/// A middle of an edge that only one of its triangles knows.
TriMesh with_t_junction() {
  TriMesh mesh = sound();
  mesh.positions.push_back(0.5 * (mesh.positions[6] + mesh.positions[12]));
  mesh.triangles[10] = {6, 7, 25};  // was 6 7 12
  mesh.triangles.push_back({25, 7, 12});
  return mesh;
}

void add_unmeasurable(MeshFiles& files) {
  const TriMesh patch = sound();
  const TriMesh point = with_vertex(patch, {2, 2, 5});
  files.refuse("third_face_inside", with_triangle(point, {6, 7, 25}), ErrorCode::non_manifold_edge,
               6);
  files.refuse("two_faces_more_on_the_border",
               with_triangle(with_triangle(with_vertex(point, {0, 0, 9}), {0, 1, 25}), {0, 1, 26}),
               ErrorCode::non_manifold_edge, 0);
  files.refuse("inner_wall", with_triangle(with_triangle(point, {6, 12, 25}), {12, 18, 25}),
               ErrorCode::non_manifold_edge, 6);
  files.refuse("face_against_the_border", with_triangle(point, {0, 1, 25}),
               ErrorCode::inconsistent_orientation, 32);
  files.refuse("face_twice", with_triangle(patch, patch.triangles[5]),
               ErrorCode::duplicate_triangle, 32);
  files.refuse(
      "face_twice_turned",
      with_triangle(patch, {patch.triangles[5][1], patch.triangles[5][2], patch.triangles[5][0]}),
      ErrorCode::duplicate_triangle, 32);
  files.refuse(
      "face_twice_reversed",
      with_triangle(patch, {patch.triangles[5][1], patch.triangles[5][0], patch.triangles[5][2]}),
      ErrorCode::duplicate_triangle, 32);
  TriMesh doubled = patch;
  doubled.triangles.insert(doubled.triangles.end(), patch.triangles.begin(), patch.triangles.end());
  files.refuse("all_faces_twice", doubled, ErrorCode::duplicate_triangle, 32);
  files.refuse("pillow", TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}},
               ErrorCode::duplicate_triangle, 1);
  for (const Triangle& t :
       {Triangle{3, 4, 4}, Triangle{4, 3, 4}, Triangle{4, 4, 3}, Triangle{12, 12, 12}}) {
    files.refuse("repeated_" + std::to_string(t[0]) + "_" + std::to_string(t[1]) + "_" +
                     std::to_string(t[2]),
                 with_triangle(patch, t), ErrorCode::repeated_index, 32);
  }
  files.refuse("bow_tie_at_a_corner", glued_at(patch, 0), ErrorCode::non_manifold_vertex, 0);
  files.refuse("bow_tie_inside", glued_at(patch, 12), ErrorCode::non_manifold_vertex, 12);
  files.refuse(
      "two_triangles_at_a_vertex",
      TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}},
      ErrorCode::non_manifold_vertex, 0);
  files.refuse("cones_of_one_apex", glued_at(meshes::fan(6, 1.0), 0),
               ErrorCode::non_manifold_vertex, 0);
  files.refuse("holes_that_touch", without_cells(patch, {5, 10}), ErrorCode::non_manifold_vertex,
               12);
  files.refuse("hole_that_touches_the_border", without_cells(patch, {0, 5}),
               ErrorCode::non_manifold_vertex, 6);
  for (const NamedPlace& place : places_in(32)) {
    files.refuse("flipped_" + place.name, with_flipped(patch, place.number, place.number + 1),
                 ErrorCode::inconsistent_orientation, place.number);
  }
  files.refuse("half_flipped", with_flipped(patch, 16, 32), ErrorCode::inconsistent_orientation,
               16);
  files.refuse("every_other_flipped", with_flipped(patch, 1, 32, 2),
               ErrorCode::inconsistent_orientation, 1);
  files.refuse("flipped_in_the_second_part",
               with_flipped(meshes::side_by_side(patch, patch), 40, 41),
               ErrorCode::inconsistent_orientation, 40);
  files.refuse("moebius_strip", meshes::moebius(9), ErrorCode::non_orientable, {});
  files.refuse("klein_bottle", klein_bottle(), ErrorCode::non_orientable, {});
  files.refuse("projective_plane", projective_plane(), ErrorCode::non_orientable, {});
  TriMesh crosscap = projective_plane();
  crosscap.triangles.pop_back();
  files.refuse("projective_plane_with_a_hole", crosscap, ErrorCode::non_orientable, {});
}

void add_not_evolvable(MeshFiles& files) {
  const TriMesh patch = sound();
  files.refuse("tetrahedron", meshes::tetrahedron(), ErrorCode::closed_surface, {},
               Purpose::evolve);
  files.refuse("torus", meshes::torus(6, 8), ErrorCode::closed_surface, {}, Purpose::evolve);
  files.refuse("two_tetrahedra", meshes::side_by_side(meshes::tetrahedron(), meshes::tetrahedron()),
               ErrorCode::closed_surface, {}, Purpose::evolve);
  files.refuse("patch_and_closed_part", meshes::side_by_side(patch, meshes::tetrahedron()),
               ErrorCode::closed_surface, {}, Purpose::evolve);
  files.refuse("soup", meshes::soup_of(patch), ErrorCode::no_inner_vertex, {}, Purpose::evolve);
}

void add_not_unfoldable(MeshFiles& files) {
  const TriMesh patch = sound();
  const auto refuse = [&](const std::string& name, const TriMesh& mesh, ErrorCode code) {
    files.refuse(name, mesh, code, {}, Purpose::unfold);
  };
  refuse("two_patches", meshes::side_by_side(patch, patch), ErrorCode::several_components);
  refuse("patch_and_lost_triangle",
         meshes::side_by_side(patch, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
         ErrorCode::several_components);
  refuse("patch_and_tube", meshes::side_by_side(patch, meshes::tube(5, 3)),
         ErrorCode::several_components);
  refuse("tube", meshes::tube(6, 4), ErrorCode::several_border_loops);
  files.accept("one_hole", without_cells(patch, {5}));
  files.accept("two_holes", without_cells(meshes::rough_grid(6, 6, 7), {7, 22}));
  TriMesh missing = patch;
  missing.triangles.erase(missing.triangles.begin() + 12);
  files.accept("triangle_missing_inside", missing);
  refuse("t_junction", with_t_junction(), ErrorCode::several_border_loops);
  refuse("slit_inside", with_slit(patch, 2, 2), ErrorCode::several_border_loops);
  TriMesh torus = meshes::torus(6, 8);
  torus.triangles.pop_back();
  refuse("torus_with_a_hole", torus, ErrorCode::handles);
}

void add_sound_ones(MeshFiles& files) {
  const TriMesh patch = sound();
  files.same("all_flipped", with_flipped(patch, 0, 32));
  TriMesh reversed = patch;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  files.same("faces_in_other_order", reversed);
  files.accept("unused_vertices", with_vertex(with_vertex(patch, {9, 9, 9}), {1e9, 0, 0}),
               ErrorCode::unreferenced_vertex);
  files.accept("unused_vertex_at_a_used_one", with_vertex(patch, patch.positions[12]),
               ErrorCode::unreferenced_vertex);
  files.accept("one_triangle", TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
               ErrorCode::no_inner_vertex);
  files.accept("two_triangles",
               TriMesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}},
               ErrorCode::no_inner_vertex);
  files.accept("strip", meshes::rough_grid(9, 1, 3), ErrorCode::no_inner_vertex);
  for (const std::size_t valence : {3, 4, 5, 300})
    files.accept("fan_of_" + std::to_string(valence), meshes::fan(valence, 0.5));
  files.accept("ruffled_fan", meshes::ruffled_fan(12, 0.5));
  files.accept("slit_from_the_border", with_slit(patch, 0, 2));
  TriMesh eared = patch;
  eared.triangles.push_back({1, 0, 25});
  files.accept("ear", with_vertex(eared, {0, -1, 0}));
  files.accept("corner_missing", without_cells(patch, {0}), ErrorCode::unreferenced_vertex);
}

}  // namespace

BadMeshes bad_topology() {
  MeshFiles files;
  add_unmeasurable(files);
  add_not_evolvable(files);
  add_not_unfoldable(files);
  add_sound_ones(files);
  BadMeshes all = files.take();
  // Without vertex numbers, what is at one place is one vertex.
  Collection stl("stl_topology_", ".stl");
  const auto bytes = [](const TriMesh& mesh) { return binary_stl(mesh); };
  stl.same("soup", bytes(meshes::soup_of(sound())), "welded 96 corners to 25 vertices");
  stl.same("slit_closed", bytes(with_slit(sound(), 0, 2)), "an open seam would be closed");
  stl.same("all_flipped", bytes(with_flipped(sound(), 0, 32)));
  stl.as_mesh("face_twice", bytes(with_triangle(sound(), sound().triangles[5])),
              ErrorCode::duplicate_triangle, 32);
  stl.as_mesh("flipped", bytes(with_flipped(sound(), 7, 8)), ErrorCode::inconsistent_orientation,
              7);
  stl.as_mesh("tube", bytes(meshes::tube(6, 4)), ErrorCode::several_border_loops, {},
              Purpose::unfold);
  stl.as_mesh("tetrahedron", bytes(meshes::tetrahedron()), ErrorCode::closed_surface, {},
              Purpose::evolve);
  TriMesh jitter = meshes::soup_of(sound());
  meshes::Random random(5);
  for (Vec3& p : jitter.positions)
    p += 1e-3 * Vec3{random.number(), random.number(), random.number()};
  stl.as_mesh("corners_that_nearly_meet", bytes(jitter), ErrorCode::no_inner_vertex, {},
              Purpose::evolve, "weld");
  append(all, stl.take());
  return all;
}

}  // namespace planish::bad

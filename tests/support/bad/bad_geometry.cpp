#include <cmath>
#include <limits>

#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

template <class Change>
TriMesh changed(Change change) {
  TriMesh mesh = sound();
  for (Vec3& p : mesh.positions)
    p = change(p);
  return mesh;
}

TriMesh with_place(std::size_t vertex, Vec3 p) {
  TriMesh mesh = sound();
  mesh.positions[vertex] = p;
  return mesh;
}

std::string text_of(const TriMesh& mesh) {
  return sound_obj(mesh).lines.text();
}

void add_sizes(Collection& files) {
  for (const int power : {3, 30, 100, 150, 154, 155, 200, 250, 300, 307}) {
    const double up = std::pow(10.0, power), down = std::pow(10.0, -power);
    files.same("size_1e" + std::to_string(power), text_of(changed([&](Vec3 p) { return up * p; })));
    const TriMesh small = changed([&](Vec3 p) { return down * p; });
    if (power <= 300) files.same("size_1e_minus_" + std::to_string(power), text_of(small));
    if (power > 300) files.either("size_1e_minus_" + std::to_string(power), text_of(small));
  }
  for (const int power : {310, 316, 320, 323}) {
    files.either(
        "size_1e_minus_" + std::to_string(power),
        text_of(changed([&](Vec3 p) { return 1e-300 * (std::pow(10.0, 300 - power) * p); })));
  }
  const double most = std::numeric_limits<double>::max();
  files.either("size_largest", text_of(changed([&](Vec3 p) { return 0.2 * most * p; })));
  files.either("corners_at_opposite_ends", [&] {
    TriMesh mesh = with_place(0, {-most, -most, -most});
    mesh.positions[24] = {most, most, most};
    return text_of(mesh);
  }());
  for (const int power : {3, 6, 8, 12, 15}) {
    const double away = std::pow(10.0, power);
    const std::string name = "offset_1e" + std::to_string(power);
    const std::string bytes = text_of(changed([&](Vec3 p) { return p + Vec3{away, -away, away}; }));
    if (power <= 12) {
      files.accept(name, bytes);
    } else {
      files.either(name, bytes);
    }
  }
  files.either("offset_1e300", text_of(changed([](Vec3 p) { return p + Vec3{1e300, 0, 0}; })));
  for (const int power : {-15, -9, -6, -3, 3, 6, 9}) {
    const double stretch = std::pow(10.0, power);
    files.either(
        "stretched_1e" + std::string(power < 0 ? "_minus_" : "") + std::to_string(std::abs(power)),
        text_of(changed([&](Vec3 p) {
          return Vec3{stretch * p.x, p.y, p.z};
        })));
  }
  for (const double far : {1e6, 1e15, 1e100, 1e200, 1e300}) {
    const std::string power = std::to_string(static_cast<int>(std::round(std::log10(far))));
    files.either("spike_1e" + power, text_of(with_place(12, {2, 2, far})));
    files.either("border_spike_1e" + power, text_of(with_place(2, {2, -far, 0})));
  }
}

void add_shapes(Collection& files) {
  files.accept("flat", text_of(changed([](Vec3 p) { return Vec3{p.x, p.y, 0}; })));
  files.accept("flat_and_tilted", text_of(changed([](Vec3 p) {
                 return Vec3{p.x, p.y, 0.3 * p.x - 0.7 * p.y};
               })));
  files.accept("minus_zero", text_of(changed([](Vec3 p) { return Vec3{p.x, p.y, -0.0}; })));
  files.either("folded_over", text_of(changed([](Vec3 p) {
                 return Vec3{std::abs(p.x - 2), p.y, 0};
               })));
  files.either("folded_over_twice", text_of(changed([](Vec3 p) {
                 return Vec3{std::abs(p.x - 2), std::abs(p.y - 2), 0};
               })));
  files.either("inner_vertex_outside", text_of(with_place(12, {20, 20, 0})));
  files.either("mirrored_inside_out", text_of(changed([](Vec3 p) {
                 return Vec3{-p.x, p.y, p.z};
               })));
  files.either("collinear", text_of(changed([](Vec3 p) { return Vec3{p.x + 10 * p.y, 0, 0}; })));
  files.as_mesh("one_place", text_of(changed([](Vec3) {
                  return Vec3{1, 2, 3};
                })),
                ErrorCode::zero_length_edge, 0);
  files.as_mesh("origin", text_of(changed([](Vec3) { return Vec3{}; })),
                ErrorCode::zero_length_edge, 0);
  files.as_mesh("two_at_one_place", text_of(with_place(13, sound().positions[12])),
                ErrorCode::zero_length_edge, 12);
  files.as_mesh("two_at_one_place_on_the_border", text_of(with_place(1, sound().positions[0])),
                ErrorCode::zero_length_edge, 0);
  files.accept("far_ones_at_one_place", text_of(with_place(24, sound().positions[0])));
  TriMesh near = sound();
  near.positions[13] = near.positions[12];
  near.positions[13].x = std::nextafter(near.positions[13].x, 100.0);
  files.either("one_bit_apart", text_of(near));
  files.accept("zero_area_inside", text_of([] {
                 TriMesh mesh = sound();
                 mesh.positions[12] = 0.5 * (mesh.positions[6] + mesh.positions[7]);
                 return mesh;
               }()),
               ErrorCode::zero_area);
  files.accept("zero_area_on_the_border", text_of([] {
                 TriMesh mesh = sound();  // the corner's triangle 0 1 6
                 mesh.positions[1] = 0.5 * (mesh.positions[0] + mesh.positions[6]);
                 return mesh;
               }()),
               ErrorCode::zero_area);
  for (const int power : {3, 9, 15, 100}) {
    TriMesh mesh = sound();
    mesh.positions[12] = mesh.positions[6] + std::pow(10.0, -power) * Vec3{1, 1, 0};
    files.either("needle_1e_minus_" + std::to_string(power), text_of(mesh));
  }
  meshes::Random random(11);
  files.either("noise_of_an_edge", text_of(changed([&](Vec3 p) {
                 return p + Vec3{random.number(), random.number(), random.number()};
               })));
  files.either("noise_only", text_of(changed([&](Vec3) {
                 return Vec3{random.number(), random.number(), random.number()};
               })));
  files.either("lattice", text_of(changed([&](Vec3) {
                 return Vec3{std::round(2 * random.number()), std::round(2 * random.number()),
                             std::round(2 * random.number())};
               })));
  TriMesh balloon = meshes::height_field(8, 8, [](double, double) { return 0.0; });
  for (Vec3& p : balloon.positions) {
    const double turn = 0.7 * std::hypot(p.x - 4, p.y - 4), around = std::atan2(p.y - 4, p.x - 4);
    p = {std::sin(turn) * std::cos(around), std::sin(turn) * std::sin(around), std::cos(turn)};
  }
  files.either("nearly_closed_ball", text_of(balloon));
}

}  // namespace

BadMeshes bad_geometry() {
  Collection files("obj_geometry_", ".obj");
  add_sizes(files);
  add_shapes(files);
  return files.take();
}

BadMeshes bad_meshes() {
  BadMeshes all;
  for (const auto make : {bad_numbers, bad_indices, bad_encodings, bad_obj, bad_ply, bad_off,
                          bad_stl, bad_topology, bad_geometry})
    append(all, make());
  return all;
}

}  // namespace planish::bad

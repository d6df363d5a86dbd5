#include <array>
#include <cmath>

#include <planish/core/error.h>
#include <planish/pattern/notches.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/jacket.h"
#include "support/meshes.h"

namespace planish {
namespace {

using testing::HasSubstr;

/// A curved strip of 6 x 4 cells cut in two after the third column.
struct TwoHalves {
  std::vector<TriMesh> patches;
  std::vector<std::string> names = {"front", "back"};
  std::vector<Seam> seams;
};

TwoHalves two_halves() {
  const TriMesh mesh = meshes::height_field(6, 4, [](double x, double y) { return 0.2 * x * y; });
  std::vector<Index> group;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    group.push_back(t / 2 % 6 < 3 ? 0 : 1);
  TwoHalves halves;
  for (NamedPatch& patch : split(mesh, group, halves.names))
    halves.patches.push_back(std::move(patch.mesh));
  halves.seams = find_seams(halves.patches);
  return halves;
}

std::vector<std::vector<Notch>> notches_of(const TwoHalves& halves, const SeamNotch& notch,
                                           double unit = 1.0) {
  return notches_of_patches(std::vector<SeamNotch>{notch}, halves.seams, halves.patches,
                            halves.names, unit);
}

Vec3 place_of(const Notch& notch, const TriMesh& mesh) {
  const Vec3 a = mesh.positions[notch.edge->front()], b = mesh.positions[notch.edge->back()];
  return a + notch.fraction * (b - a);
}

/// Of a side's length, where a notch on it is.
double share_of(const Notch& notch, const SeamSide& side, const TriMesh& mesh) {
  double way = 0.0;
  for (std::size_t k = 0; k + 1 < side.vertices.size(); ++k) {
    const Vec3 edge = mesh.positions[side.vertices[k + 1]] - mesh.positions[side.vertices[k]];
    const bool is_it = notch.edge == std::array{side.vertices[k], side.vertices[k + 1]};
    way += (is_it ? notch.fraction : 1.0) * norm(edge);
    if (is_it) break;
  }
  return way / length_of(side, std::span<const Vec3>(mesh.positions));
}

/// Along the seam of the halves, which is at x = 3.
double way_to(Vec3 place, const TwoHalves& halves) {
  const SeamSide& side = halves.seams.front().sides[0];
  const Vec3 start = halves.patches[side.patch].positions[side.vertices.front()];
  return std::abs(place.y - start.y) * std::hypot(1.0, 0.6);  // z = 0.6 y there
}

TEST(SeamNotches, AreAtOnePlaceOfTheModelOnBothSides) {
  const TwoHalves halves = two_halves();
  ASSERT_EQ(halves.seams.size(), 1U);
  for (const double share : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const auto notches = notches_of(halves, {.place = share, .kind = NotchKind::v});
    ASSERT_EQ(notches.size(), 2U);
    ASSERT_EQ(notches[0].size(), 1U);
    ASSERT_EQ(notches[1].size(), 1U);
    const Vec3 front = place_of(notches[0][0], halves.patches[0]);
    EXPECT_NEAR(norm(front - place_of(notches[1][0], halves.patches[1])), 0.0, 1e-14);
    EXPECT_NEAR(way_to(front, halves), share * 4.0 * std::hypot(1.0, 0.6), 1e-12);
    EXPECT_EQ(notches[0][0].kind, NotchKind::v);
  }
}

TEST(SeamNotches, MayBeGivenInMillimetresOfAnyUnit) {
  const TwoHalves halves = two_halves();
  const SeamNotch notch = {.seam = 0, .place = 15.0, .in_millimetres = true, .is_double = true};
  const auto notches = notches_of(halves, notch, 10.0);  // a model in cm
  const Vec3 place = place_of(notches[1].at(0), halves.patches[1]);
  EXPECT_NEAR(way_to(place, halves), 1.5, 1e-12);
  EXPECT_TRUE(notches[1][0].is_double);
}

TEST(SeamNotches, AreOnBothEdgesOfADart) {
  TriMesh mesh = meshes::flat_grid(4, 2);
  // The middle row's first two vertices are opened to a slit: the upper side has its own.
  const auto row = [](Index column) { return static_cast<Index>(5 + column); };
  const auto copies = static_cast<Index>(mesh.positions.size());
  for (const Index column : {0U, 1U})
    mesh.positions.push_back(mesh.positions[row(column)]);
  for (std::size_t t = 8; t < mesh.triangles.size(); ++t) {
    for (Index& v : mesh.triangles[t]) {
      if (v == row(0) || v == row(1)) v = copies + (v - row(0));
    }
  }
  const std::vector<Seam> seams = find_seams({&mesh, 1});
  ASSERT_EQ(seams.size(), 1U);
  const std::vector<std::string> names = {"panel"};
  const auto notches =
      notches_of_patches(std::vector<SeamNotch>{{.place = 0.25}}, seams, {&mesh, 1}, names, 1.0);
  ASSERT_EQ(notches[0].size(), 2U);
  EXPECT_EQ(place_of(notches[0][0], mesh), place_of(notches[0][1], mesh));
  EXPECT_NE(notches[0][0].edge->front(), notches[0][1].edge->front());
}

TEST(SeamNotches, MeetOnSidesThatWereMeshedApart) {
  std::vector<TriMesh> patches;
  std::vector<std::string> names;
  for (const NamedPatch& panel : meshes::Jacket::panels()) {
    patches.push_back(panel.mesh);
    names.push_back(panel.name);
  }
  const std::vector<Seam> seams = find_seams(patches);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const auto& sides = seams[s].sides;
    for (const double share : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      const std::vector<SeamNotch> asked = {{.seam = s, .place = share}};
      const auto notches = notches_of_patches(asked, seams, patches, names, 1.0);
      const Notch first = notches[sides[0].patch].front(), second = notches[sides[1].patch].back();
      const Vec3 place = place_of(first, patches[sides[0].patch]);
      EXPECT_LT(norm(place - place_of(second, patches[sides[1].patch])), 0.4) << s;
      std::array<double, 2> shares{};
      for (std::size_t k = 0; k < 2; ++k)
        shares[k] = share_of(k == 0 ? first : second, sides[k], patches[sides[k].patch]);
      EXPECT_NEAR(shares[0], share, 1e-9);
      EXPECT_NEAR(shares[1], share, 1e-3) << s;
    }
  }
}

std::string error_of(const SeamNotch& notch) {
  const TwoHalves halves = two_halves();
  try {
    notches_of(halves, notch);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_notch);
    return error.what();
  }
  return "no error";
}

TEST(SeamNotches, BeyondTheSeamAreRefusedWithItsNameAndLength) {
  const std::string text = error_of({.seam = 0, .place = 5.0, .in_millimetres = true});
  EXPECT_THAT(text, HasSubstr("the notch at 5 mm is beyond seam 1"));
  EXPECT_THAT(text, HasSubstr("\"front\" and \"back\""));
  EXPECT_THAT(text, HasSubstr("4.665 mm long"));
  EXPECT_THAT(error_of({.place = 1.2}), HasSubstr("120 %"));
  EXPECT_THAT(error_of({.place = -0.1}), HasSubstr("beyond"));
  EXPECT_THAT(error_of({.seam = 7}), HasSubstr("no seam 8"));
  EXPECT_THAT(error_of({.seam = 7}), HasSubstr("from 1 to 1"));
}

TEST(SeamNotchesAt, AreWherePlacesOfTheModelLie) {
  const TwoHalves halves = two_halves();
  ASSERT_EQ(halves.seams.size(), 1U);
  const SeamSide& side = halves.seams[0].sides[0];
  const std::vector<Vec3>& positions = halves.patches[side.patch].positions;
  const Vec3 a = positions[side.vertices[1]], b = positions[side.vertices[2]];
  const std::vector<Vec3> places = {a + 0.25 * (b - a), positions[side.vertices.back()]};
  const std::vector<SeamNotch> notches = seam_notches_at(places, halves.seams, halves.patches);
  ASSERT_EQ(notches.size(), 2U);
  EXPECT_EQ(notches[1].place, 1.0);
  const auto of = notches_of(halves, notches[0]);
  for (std::size_t p = 0; p < 2; ++p) {
    ASSERT_EQ(of[p].size(), 1U);
    EXPECT_NEAR(norm(place_of(of[p][0], halves.patches[p]) - places[0]), 0.0, 1e-12);
  }
}

TEST(SeamNotchesAt, RefusesPlacesOffAllSeams) {
  const TwoHalves halves = two_halves();
  const std::vector<Vec3> places = {{100.0, 0.0, 0.0}};
  try {
    seam_notches_at(places, halves.seams, halves.patches);
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_notch);
    EXPECT_THAT(error.message(), HasSubstr("notch 1 is on no seam"));
  }
}

}  // namespace
}  // namespace planish

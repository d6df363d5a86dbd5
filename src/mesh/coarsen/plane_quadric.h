#pragma once

#include <planish/core/vec.h>

namespace planish {

/// Sum of weighted squares of the distances to planes and lines (Garland and Heckbert 1997).
class PlaneQuadric {
 public:
  /// The plane through p with the unit normal n.
  void add_plane(Vec3 p, Vec3 n, double weight) {
    const Vec3 wn = weight * n;
    add({wn.x * n.x, wn.y * n.y, wn.z * n.z, wn.x * n.y, wn.y * n.z, wn.z * n.x}, p);
    weight_ += weight;
  }

  /// The line through p along the unit vector e.
  /// @param stress how many times as much its squares count as those of planes
  void add_line(Vec3 p, Vec3 e, double weight, double stress) {
    const double w = weight * stress;
    const Vec3 we = -w * e;
    add({w + we.x * e.x, w + we.y * e.y, w + we.z * e.z, we.x * e.y, we.y * e.z, we.z * e.x}, p);
    weight_ += weight;
  }

  PlaneQuadric& operator+=(const PlaneQuadric& other) {
    matrix_ += other.matrix_;
    linear_ += other.linear_;
    constant_ += other.constant_;
    weight_ += other.weight_;
    return *this;
  }

  /// The weighted mean of the squares at p; 0 without planes.
  double mean(Vec3 p) const {
    const double sum = dot(p, matrix_ * p) + 2.0 * dot(linear_, p) + constant_;
    return weight_ > 0.0 && sum > 0.0 ? sum / weight_ : 0.0;
  }

 private:
  struct Symmetric {
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
    void operator+=(const Symmetric& m) {
      xx += m.xx, yy += m.yy, zz += m.zz, xy += m.xy, yz += m.yz, zx += m.zx;
    }
    Vec3 operator*(Vec3 p) const {
      return {xx * p.x + xy * p.y + zx * p.z, xy * p.x + yy * p.y + yz * p.z,
              zx * p.x + yz * p.y + zz * p.z};
    }
  };

  void add(Symmetric m, Vec3 p) {
    const Vec3 mp = m * p;
    matrix_ += m;
    linear_ += -mp;
    constant_ += dot(p, mp);
  }

  Symmetric matrix_;
  Vec3 linear_;
  double constant_ = 0.0, weight_ = 0.0;
};

}  // namespace planish

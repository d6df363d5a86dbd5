#pragma once

namespace planish {

/// A symmetric matrix of three rows.
struct Block {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

}  // namespace planish

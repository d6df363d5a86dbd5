#pragma once

#include <cmath>

/// Elementary functions that give the same bits on every machine. They are made of additions,
/// multiplications, divisions and square roots, each of which IEEE 754 rounds in one way only;
/// those of the C library differ between libraries in the last digit. The same holds for sqrt, abs,
/// floor, ceil, round and fmod of the standard library, which stay in use; of all others,
/// tools/check_layers.py allows none.
///
/// Error bounds are in units in the last place (ulp); tests check them against MPFR. NaN gives NaN.
/// Each function does what the one in <cmath> does, unless its comment says otherwise.
namespace planish::math {

/// x of |x| <= 1e6, else NaN: no angle here is so many turns. 1.1 ulp.
double sin(double x);
double cos(double x);
/// 2.5 ulp.
double tan(double x);

struct SineCosine {
  double sine, cosine;
};
/// Both at once, for little more than one.
SineCosine sincos(double x);

/// x of -1 to 1, else NaN. 3 ulp.
double asin(double x);
double acos(double x);
/// 2.5 ulp. The angle of the vector (x, y), -pi to pi; 0 or pi, with the sign of y, where y is 0.
double atan2(double y, double x);

/// 1.5 ulp; 0 where the result is below 1e-300.
double exp(double x);
/// 1.5 ulp; -infinity of 0.
double log(double x);
/// 2.5 ulp, and exact where x is a power of ten from 1e-22 to 1e22.
double log10(double x);
/// x >= 0. (4 + 2 |y log x|) ulp: it is exp(y log x), and rounding y log x counts by its size.
double pow(double x, double y);
/// 10^n; exact for n of 0 to 22, and rounded once for n of -22 to -1.
double power_of_ten(int n);

/// 1.3 ulp, also where the squares would overflow or vanish.
double hypot(double x, double y);
double hypot(double x, double y, double z);

}  // namespace planish::math

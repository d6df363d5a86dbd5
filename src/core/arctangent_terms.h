#pragma once

namespace planish {

/// arctan(t) for |t| <= tan(pi / 8) is t times the polynomial in t^2 with these coefficients, the
/// constant first. It interpolates arctan(t) / t at the eleven Chebyshev points of that interval;
/// relative error 3.5e-17 before rounding.
inline constexpr double k_arctangent_terms[] = {
    1.0,
    -0.3333333333332844,
    0.1999999999885511,
    -0.14285714180976467,
    0.11111106180455946,
    -0.09090773074808414,
    0.07689953496306857,
    -0.06640233930429408,
    0.056883492268090106,
    -0.04348052215716462,
    0.021135373157693246,
};

/// tan(pi / 8) = sqrt(2) - 1
inline constexpr double k_tan_eighth = 0.41421356237309503;

}  // namespace planish

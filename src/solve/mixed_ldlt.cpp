#include "solve/mixed_ldlt.h"

#include <cmath>

namespace planish {

namespace {

// Of the right side: what a first solution may leave, or float does not do.
constexpr double k_far_off = 0.1;
constexpr int k_most_refinements = 8;

/// The power of two nearest to one over the root; 1 for 0.
double root_scale(double diagonal) {
  int exponent = 0;
  std::frexp(diagonal, &exponent);
  return diagonal == 0.0 || !std::isfinite(diagonal) ? 1.0 : std::ldexp(1.0, -exponent / 2);
}

Eigen::VectorXd scale_of(const SparseMatrix& lower) {
  Eigen::VectorXd scale(lower.cols());
  for (int j = 0; j < lower.outerSize(); ++j) {
    double diagonal = 0.0;
    for (SparseMatrix::InnerIterator entry(lower, j); entry && entry.row() <= j; ++entry) {
      if (entry.row() == j) diagonal = entry.value();
    }
    scale[j] = root_scale(diagonal);
  }
  return scale;
}

Buffer<float> scaled(const SparseMatrix& lower, const Eigen::VectorXd& scale) {
  Buffer<float> values(static_cast<std::size_t>(lower.nonZeros()));
  float* value = values.data();
  for (int j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
      *value++ = static_cast<float>(scale[entry.row()] * scale[j] * entry.value());
  }
  return values;
}

/// The symmetric matrix times x.
Eigen::VectorXd product(const SparseMatrix& lower, const Eigen::VectorXd& x) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (int j = 0; j < lower.outerSize(); ++j) {
    double sum = 0.0;
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      if (entry.row() < j) continue;
      sum += entry.value() * x[entry.row()];
      if (entry.row() > j) result[entry.row()] += entry.value() * x[j];
    }
    result[j] += sum;
  }
  return result;
}

}  // namespace

MixedLdlt::MixedLdlt(const SparseMatrix& lower, std::span<const Index> order, Precision precision)
    : order_(order.begin(), order.end()) {
  if (precision == Precision::mixed) narrow_.emplace(lower, order);
}

bool MixedLdlt::factor(const SparseMatrix& lower, ThreadPool& pool) {
  if (!narrow_) return factor_in_double(lower, pool);
  scale_ = scale_of(lower);
  is_double_ = false;
  return narrow_->factor(scaled(lower, scale_).data(), pool) || factor_in_double(lower, pool);
}

bool MixedLdlt::factor_in_double(const SparseMatrix& lower, ThreadPool& pool) {
  is_double_ = true;
  if (!wide_) wide_.emplace(lower, order_);
  return wide_->factor(lower, pool);
}

/// Nothing where float does not do.
std::optional<Eigen::VectorXd> MixedLdlt::refined(const SparseMatrix& lower,
                                                  const Eigen::VectorXd& right, ThreadPool& pool,
                                                  double accuracy) const {
  const Eigen::VectorXd target = scale_.cwiseProduct(right);
  const double size = target.norm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), residual = target;
  double left = size;
  for (int solves = 0; solves <= k_most_refinements && left > accuracy * size; ++solves) {
    const Eigen::VectorXd next = x + scale_.cwiseProduct(narrow_->solve(residual, pool).col(0));
    Eigen::VectorXd after = scale_.cwiseProduct(right - product(lower, next));
    const double now = after.norm();
    if (!(now <= (solves == 0 ? k_far_off * size : left))) {
      if (solves == 0) return std::nullopt;
      break;
    }
    x = next;
    residual = std::move(after);
    left = now;
  }
  return x;
}

void MixedLdlt::release() {
  if (narrow_) narrow_->release();
  wide_.reset();
}

Eigen::VectorXd MixedLdlt::solve(const SparseMatrix& lower, const Eigen::VectorXd& right,
                                 ThreadPool& pool, double accuracy) {
  if (!is_double_) {
    if (auto x = refined(lower, right, pool, accuracy)) return *std::move(x);
    if (!factor_in_double(lower, pool)) {
      is_double_ = false;
      return Eigen::VectorXd::Zero(right.size());
    }
  }
  return wide_->solve(right, pool).col(0);
}

}  // namespace planish

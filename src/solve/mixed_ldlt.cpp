#include "solve/mixed_ldlt.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planish {

namespace {

constexpr std::size_t k_most_solves = 12;

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

/// Flexible GMRES (Saad 1993): of all combinations of the directions z_k that were added the one
/// whose image under A is nearest to the right side. The QR factors of the Hessenberg matrix are
/// kept up to date by Givens rotations.
class FlexibleGmres {
 public:
  explicit FlexibleGmres(const Eigen::VectorXd& right) : size_(right.norm()), rest_(1, size_) {
    basis_.push_back(size_ > 0.0 ? Eigen::VectorXd(right / size_) : right);
  }

  /// What is left of the right side, as a share of it.
  double residual() const { return size_ > 0.0 ? std::abs(rest_.back()) / size_ : 0.0; }
  std::size_t size() const { return directions_.size(); }
  /// The vector that the next direction is to be made from.
  const Eigen::VectorXd& next() const { return basis_.back(); }

  /// False where the direction is no number, or brings nothing new.
  bool add(Eigen::VectorXd direction, Eigen::VectorXd image) {
    std::vector<double> column;
    for (const Eigen::VectorXd& v : basis_) {
      column.push_back(v.dot(image));
      image -= column.back() * v;
    }
    const double length = image.norm();
    if (!std::isfinite(length)) return false;
    for (std::size_t k = 0; k < rotations_.size(); ++k)
      rotations_[k].apply(column[k], column[k + 1]);
    const double corner = std::sqrt(column.back() * column.back() + length * length);
    if (!(corner > 0.0)) return false;
    rotations_.push_back({column.back() / corner, length / corner});
    column.back() = corner;
    columns_.push_back(std::move(column));
    rest_.push_back(0.0);
    rotations_.back().apply(rest_[rest_.size() - 2], rest_.back());
    directions_.push_back(std::move(direction));
    basis_.push_back(length > 0.0 ? Eigen::VectorXd(image / length) : image);
    return length > 0.0;
  }

  Eigen::VectorXd solution() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(basis_.front().size());
    std::vector<double> factors(rest_.begin(), rest_.end());
    for (std::size_t k = directions_.size(); k-- > 0;) {
      factors[k] /= columns_[k][k];
      for (std::size_t i = 0; i < k; ++i)
        factors[i] -= columns_[k][i] * factors[k];
      x += factors[k] * directions_[k];
    }
    return x;
  }

 private:
  struct GivensRotation {
    double cosine, sine;
    void apply(double& a, double& b) const {
      const double before = a;
      a = cosine * before + sine * b;
      b = cosine * b - sine * before;
    }
  };

  double size_;
  std::vector<double> rest_;  // the right side, rotated; the last is the residual
  std::vector<Eigen::VectorXd> basis_, directions_;
  std::vector<std::vector<double>> columns_;  // of R
  std::vector<GivensRotation> rotations_;
};

}  // namespace

MixedLdlt::MixedLdlt(const SparseMatrix& lower, std::span<const Index> order, Precision precision,
                     const ThreadPool* pool)
    : order_(order.begin(), order.end()), is_narrow_(precision != Precision::full) {
  if (precision == Precision::mixed) mixed_.emplace(lower, order, pool);
  if (precision == Precision::rounded) rounded_.emplace(lower, order, pool);
}

bool MixedLdlt::factor(const SparseMatrix& lower, ThreadPool& pool) {
  is_solvable_ = true;
  if (!is_narrow_) return factor_in_double(lower, pool);
  scale_ = scale_of(lower);
  is_double_ = false;
  return factor_in_float(lower, pool) || factor_in_double(lower, pool);
}

bool MixedLdlt::factor_in_float(const SparseMatrix& lower, ThreadPool& pool) {
  const std::span<const double> scale(scale_.data(), static_cast<std::size_t>(scale_.size()));
  return mixed_ ? mixed_->factor(lower.valuePtr(), scale, pool)
                : rounded_->factor(lower.valuePtr(), scale, pool);
}

bool MixedLdlt::factor_in_double(const SparseMatrix& lower, ThreadPool& pool) {
  is_double_ = true;
  release_float();
  if (!wide_) wide_.emplace(lower, order_, &pool);
  return wide_->factor(lower, pool);
}

/// Nothing where float does not do.
std::optional<Eigen::VectorXd> MixedLdlt::refined(const SparseMatrix& lower,
                                                  const Eigen::VectorXd& right, ThreadPool& pool,
                                                  double accuracy, double enough) const {
  FlexibleGmres gmres(scale_.cwiseProduct(right));
  while (gmres.residual() > accuracy && gmres.size() < k_most_solves) {
    Eigen::VectorXd direction =
        (mixed_ ? mixed_->solve(gmres.next(), pool) : rounded_->solve(gmres.next(), pool)).col(0);
    Eigen::VectorXd image = scale_.cwiseProduct(product(lower, scale_.cwiseProduct(direction)));
    if (!gmres.add(std::move(direction), std::move(image))) break;
  }
  if (!(gmres.residual() <= enough)) return std::nullopt;
  return scale_.cwiseProduct(gmres.solution());
}

void MixedLdlt::release_float() {
  if (mixed_) mixed_->release();
  if (rounded_) rounded_->release();
}

void MixedLdlt::release() {
  release_float();
  wide_.reset();
}

Eigen::VectorXd MixedLdlt::solve(const SparseMatrix& lower, const Eigen::VectorXd& right,
                                 ThreadPool& pool, double accuracy, double enough) {
  if (!is_double_) {
    if (auto x = refined(lower, right, pool, accuracy, enough)) return *std::move(x);
    is_solvable_ = factor_in_double(lower, pool);
  }
  if (!is_solvable_) return Eigen::VectorXd::Zero(right.size());
  return wide_->solve(right, pool).col(0);
}

}  // namespace planish

#include "io/svg/svg_chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math.h"

namespace planish {

namespace {

constexpr int k_most_chords = 100'000;
constexpr std::size_t k_most_shape_points = 5'000'000;  // of one shape
constexpr double k_farthest = 1e12;                     // millimetres

double angle_of(Vec2 v) {
  return math::atan2(v.y, v.x);
}

/// An elliptic arc by its middle, as SVG 2 converts it (appendix B.2.4).
struct Arc {
  Vec2 middle, radii;
  double cosine = 1.0, sine = 0.0;  // of the turn of the first axis
  double begin = 0.0, sweep = 0.0;  // radians

  Vec2 at(double share) const {
    const auto [s, c] = math::sincos(begin + share * sweep);
    const Vec2 p = {radii.x * c, radii.y * s};
    return middle + Vec2{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  }
};

Arc arc_between(Vec2 from, Vec2 radii, double turn, bool large, bool sweep, Vec2 to) {
  Arc arc;
  const auto [sine, cosine] = math::sincos(std::fmod(turn, 360.0) * std::numbers::pi / 180.0);
  arc.sine = sine;
  arc.cosine = cosine;
  const Vec2 half = 0.5 * (from - to);
  const Vec2 p = {cosine * half.x + sine * half.y, cosine * half.y - sine * half.x};
  radii = {std::abs(radii.x), std::abs(radii.y)};
  const Vec2 q = {p.x / radii.x, p.y / radii.y};
  const double too_far = dot(q, q);
  if (too_far > 1.0) radii = std::sqrt(too_far) * radii;
  const double rest = too_far < 1.0 ? 1.0 / too_far - 1.0 : 0.0;
  const double root = (large == sweep ? -1.0 : 1.0) * std::sqrt(rest);
  const Vec2 off = {root * radii.x * p.y / radii.y, -root * radii.y * p.x / radii.x};
  arc.middle =
      0.5 * (from + to) + Vec2{cosine * off.x - sine * off.y, sine * off.x + cosine * off.y};
  arc.radii = radii;
  arc.begin = angle_of({(p.x - off.x) / radii.x, (p.y - off.y) / radii.y});
  const double end = angle_of({(-p.x - off.x) / radii.x, (-p.y - off.y) / radii.y});
  arc.sweep = end - arc.begin;
  if (sweep && arc.sweep < 0.0) arc.sweep += 2.0 * std::numbers::pi;
  if (!sweep && arc.sweep > 0.0) arc.sweep -= 2.0 * std::numbers::pi;
  return arc;
}

/// How many equal steps keep each chord within the error, which falls with their square; 0 where
/// that are too many.
/// @param bend the largest second derivative over the whole, millimetres
int steps_for(double bend) {
  const double steps = std::max(1.0, std::ceil(std::sqrt(bend / (8.0 * k_chord_error))));
  return steps <= k_most_chords ? static_cast<int>(steps) : 0;
}

/// The part of a path's data that is read.
class PathData {
 public:
  PathData(std::string_view data, SvgChords& chords) : numbers_(data), chords_(chords) {}

  std::string run() {
    while (numbers_.peek() != 0) {
      if (is_command(numbers_.peek())) {
        command_ = numbers_.letter();
        if (!begun_ && command_ != 'M' && command_ != 'm') return "path data begin without M";
        begun_ = true;
        if (command_ == 'Z' || command_ == 'z') {
          chords_.close();
          bend_ = {};
          command_ = 0;
          continue;
        }
      } else if (command_ == 0) {
        return begun_ ? "a command is missing in path data" : "path data begin without M";
      }
      if (!step())
        return std::string("a number is missing or wrong in path data after ") + command_;
      // More pairs behind a move are lines.
      if (command_ == 'M') command_ = 'L';
      if (command_ == 'm') command_ = 'l';
    }
    return {};
  }

 private:
  enum class Bend { none, cubic, quadratic };

  static bool is_command(char c) {
    return std::string_view("MmLlHhVvCcSsQqTtAaZz").find(c) != std::string_view::npos;
  }
  bool is_relative() const { return command_ >= 'a'; }

  bool read(double& value) {
    const auto number = numbers_.number();
    if (number) value = *number;
    return number.has_value();
  }
  /// A point, absolute.
  bool read(Vec2& p) {
    if (!read(p.x) || !read(p.y)) return false;
    if (is_relative()) p = p + chords_.at();
    return true;
  }
  /// The last control point mirrored at where the line is.
  Vec2 mirrored(Bend wanted) const {
    return bend_ == wanted ? 2.0 * chords_.at() - control_ : chords_.at();
  }

  bool step() {
    const Bend before = bend_;
    bend_ = Bend::none;
    const char kind = is_relative() ? static_cast<char>(command_ - 'a' + 'A') : command_;
    switch (kind) {
      case 'H':
      case 'V':
        return straight(kind == 'H');
      case 'C':
      case 'S':
        bend_ = before;
        return cubic(kind == 'S');
      case 'Q':
      case 'T':
        bend_ = before;
        return quadratic(kind == 'T');
      case 'A':
        return arc();
      default:
        break;
    }
    Vec2 p;
    if (!read(p)) return false;
    if (kind == 'M') {
      chords_.move_to(p);
    } else {
      chords_.line_to(p);
    }
    return true;
  }

  bool straight(bool level) {
    double value = 0.0;
    if (!read(value)) return false;
    Vec2 p = chords_.at();
    double& changed = level ? p.x : p.y;
    changed = is_relative() ? changed + value : value;
    chords_.line_to(p);
    return true;
  }

  bool cubic(bool smooth) {
    Vec2 c1 = mirrored(Bend::cubic), c2, p;
    if ((!smooth && !read(c1)) || !read(c2) || !read(p)) return false;
    chords_.cubic_to(c1, c2, p);
    control_ = c2;
    bend_ = Bend::cubic;
    return true;
  }

  bool quadratic(bool smooth) {
    Vec2 c = mirrored(Bend::quadratic), p;
    if ((!smooth && !read(c)) || !read(p)) return false;
    chords_.quadratic_to(c, p);
    control_ = c;
    bend_ = Bend::quadratic;
    return true;
  }

  bool arc() {
    Vec2 radii, p;
    double turn = 0.0;
    if (!read(radii.x) || !read(radii.y) || !read(turn)) return false;
    const auto large = numbers_.flag(), sweep = large ? numbers_.flag() : std::nullopt;
    if (!sweep || !read(p)) return false;
    chords_.arc_to(radii, turn, *large, *sweep, p);
    return true;
  }

  SvgNumbers numbers_;
  SvgChords& chords_;
  char command_ = 0;
  bool begun_ = false;
  Vec2 control_;
  Bend bend_ = Bend::none;
};

}  // namespace

void SvgChords::add(Vec2 mm) {
  const bool is_near = std::abs(mm.x) <= k_farthest && std::abs(mm.y) <= k_farthest;
  if (!is_near || ++points_ > k_most_shape_points) failed_ = true;
  if (!failed_) lines_.back().push_back(mm);
}

void SvgChords::move_to(Vec2 p) {
  lines_.emplace_back();
  at_ = start_ = p;
  closed_ = false;
  add(to_mm_(p));
}

void SvgChords::line_to(Vec2 p) {
  if (closed_) move_to(start_);
  at_ = p;
  add(to_mm_(p));
}

void SvgChords::add_curve(const Vec2 (&mm)[4]) {
  const double bend =
      6.0 * std::max(norm(mm[0] - 2.0 * mm[1] + mm[2]), norm(mm[1] - 2.0 * mm[2] + mm[3]));
  const int steps = steps_for(bend);
  failed_ = failed_ || steps == 0;
  for (int i = 1; i <= steps && !failed_; ++i) {
    const double t = static_cast<double>(i) / steps, s = 1.0 - t;
    add(i == steps ? mm[3]
                   : s * s * s * mm[0] + 3.0 * s * s * t * mm[1] + 3.0 * s * t * t * mm[2] +
                         t * t * t * mm[3]);
  }
}

void SvgChords::cubic_to(Vec2 c1, Vec2 c2, Vec2 p) {
  if (closed_) move_to(start_);
  add_curve({to_mm_(at_), to_mm_(c1), to_mm_(c2), to_mm_(p)});
  at_ = p;
}

void SvgChords::quadratic_to(Vec2 c, Vec2 p) {
  cubic_to(at_ + 2.0 / 3.0 * (c - at_), p + 2.0 / 3.0 * (c - p), p);
}

void SvgChords::arc_to(Vec2 radii, double turn, bool large, bool sweep, Vec2 p) {
  if (p == at_) return;
  if (radii.x == 0.0 || radii.y == 0.0) return line_to(p);
  if (closed_) move_to(start_);
  const Arc arc = arc_between(at_, radii, turn, large, sweep, p);
  // The second derivative of an ellipse is as long as its radius there.
  const double largest =
      std::max(arc.radii.x, arc.radii.y) *
      math::hypot(math::hypot(to_mm_.a, to_mm_.b), math::hypot(to_mm_.c, to_mm_.d));
  const int steps = steps_for(largest * arc.sweep * arc.sweep);
  failed_ = failed_ || steps == 0;
  for (int i = 1; i <= steps && !failed_; ++i)
    add(to_mm_(i == steps ? p : arc.at(static_cast<double>(i) / steps)));
  at_ = p;
}

void SvgChords::close() {
  if (closed_ || lines_.empty()) return;
  if (!failed_ && lines_.back().size() > 1 && !(lines_.back().back() == lines_.back().front()))
    lines_.back().push_back(lines_.back().front());
  at_ = start_;
  closed_ = true;
}

std::string add_path(std::string_view data, SvgChords& chords) {
  return PathData(data, chords).run();
}

void add_ellipse(Vec2 middle, Vec2 radii, SvgChords& chords) {
  const Vec2 right = {middle.x + radii.x, middle.y}, left = {middle.x - radii.x, middle.y};
  chords.move_to(right);
  chords.arc_to(radii, 0.0, false, true, left);
  chords.arc_to(radii, 0.0, false, true, right);
  chords.close();
}

void add_rectangle(Vec2 corner, Vec2 size, Vec2 round, SvgChords& chords) {
  const Vec2 far = corner + size;
  chords.move_to({corner.x + round.x, corner.y});
  chords.line_to({far.x - round.x, corner.y});
  chords.arc_to(round, 0.0, false, true, {far.x, corner.y + round.y});
  chords.line_to({far.x, far.y - round.y});
  chords.arc_to(round, 0.0, false, true, {far.x - round.x, far.y});
  chords.line_to({corner.x + round.x, far.y});
  chords.arc_to(round, 0.0, false, true, {corner.x, far.y - round.y});
  chords.line_to({corner.x, corner.y + round.y});
  chords.arc_to(round, 0.0, false, true, {corner.x + round.x, corner.y});
  chords.close();
}

}  // namespace planish

#include "walkthroughs/model/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/certified/fraction.hpp"
#include "core/complete.hpp"
#include "core/gjk.hpp"
#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::model {
namespace {

using gjk::Status;
using Integer = boost::multiprecision::cpp_int;

// -- Decimals ---------------------------------------------------------------------------------------------------------

/// Calls use(number) for each number that a length or a place is made of.
struct Numbers {
  const std::function<void(double)>& use;

  double length(double x) const { return use(x), x; }
  Point point(const Point& p) const { return use(p.x()), use(p.y()), use(p.z()), p; }
  Point direction(const Point& d) const { return d; }
};

void visit_numbers(const Object& object, const std::function<void(double)>& use) {
  const Numbers numbers{use};
  converted<double>(object.form, numbers);
  numbers.point(object.pose.translation);
}

/// A number as its shortest decimal says it: digits · 10^exponent.
struct ShortDecimal {
  Integer digits = 0;
  int exponent = 0;

  explicit ShortDecimal(double x) {
    std::array<char, 32> text{};
    std::to_chars(text.data(), text.data() + text.size(), std::abs(x), std::chars_format::scientific);
    const std::string all(text.data());
    const std::size_t e = all.find('e');
    std::string mantissa = all.substr(0, e);
    exponent = std::atoi(all.c_str() + e + 1);
    if (mantissa.size() > 1) {
      exponent -= static_cast<int>(mantissa.size()) - 2;
      mantissa.erase(1, 1);
    }
    digits.assign(mantissa);
    if (x < 0) digits = -digits;
  }
};

/// Multiplies decimals by powers of ten, such that all of a scene's become whole numbers. What a matrix is multiplied with has
/// another power than radii and heights, which it leaves as they are.
struct Times10 {
  int power, power_of_lengths;
  bool& is_exact;  ///< becomes false where no double holds the product

  double times(double x, int power) const {
    if (x == 0) return x;
    const ShortDecimal decimal(x);
    const Integer whole = decimal.digits * pow(Integer(10), static_cast<unsigned>(decimal.exponent + power));
    const double nearest = whole.convert_to<double>();
    if (!std::isfinite(nearest) || Integer(nearest) != whole) is_exact = false;
    return nearest;
  }
  double length(double x) const { return times(x, power_of_lengths); }
  double size(double x) const { return times(x, power); }
  Point point(const Point& p) const { return {size(p.x()), size(p.y()), size(p.z())}; }
  Point direction(const Point& d) const { return d; }
};

/// The powers of ten of the last digits.
struct LastDigits {
  std::optional<int> least = {}, most = {};

  void look_at(double x) {
    if (x == 0) return;
    const int exponent = ShortDecimal(x).exponent;
    least = std::min(least.value_or(exponent), exponent);
    most = std::max(most.value_or(exponent), exponent);
  }
  /// Doubles hold no more digits than this.
  bool may_be_exact() const { return !least || *most - *least <= 40; }
  int power() const { return -least.value_or(0); }
};

std::array<double*, 4> numbers_of(gjk::Quaternion& q) { return {&q.w, &q.x, &q.y, &q.z}; }

/// Of poses that have decimals.
Status answer_of_scaled(Object a, Object b) {
  LastDigits of_lengths, of_matrices;
  for (const Object* object : {&a, &b}) {
    visit_numbers(*object, [&](double x) { of_lengths.look_at(x); });
    if (!object->pose.quaternion)
      for (const double x : object->pose.rotation.reshaped()) of_matrices.look_at(x);
  }
  if (!of_lengths.may_be_exact()) return Status::undecided;
  const int power = of_lengths.power(), of_both = power + of_matrices.power();
  bool is_exact = true;
  for (Object* object : {&a, &b}) {
    Pose& pose = object->pose;
    object->form = converted<double>(object->form, Times10{pose.quaternion ? of_both : power, of_both, is_exact});
    pose.translation = Times10{of_both, 0, is_exact}.point(pose.translation);
    if (!pose.quaternion)
      for (double& x : pose.rotation.reshaped()) x = Times10{of_matrices.power(), 0, is_exact}.size(x);
    else {
      LastDigits digits;
      for (const double* x : numbers_of(*pose.quaternion)) digits.look_at(*x);
      if (!digits.may_be_exact()) return Status::undecided;
      for (double* x : numbers_of(*pose.quaternion)) *x = Times10{digits.power(), 0, is_exact}.size(*x);
    }
  }
  return is_exact ? exact_answer(a, b).status : Status::undecided;
}

gjk::Fraction decimal_fraction(double x) {
  if (x == 0) return 0;
  const ShortDecimal decimal(x);
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(decimal.exponent)));
  return decimal.exponent < 0 ? gjk::Fraction(decimal.digits, power) : gjk::Fraction(decimal.digits * power);
}

/// Requires: points.
gjk::PointSet<gjk::Fraction> in_fractions(const Object& object) {
  const auto fractions = [](const Point& p) {
    return gjk::Vec3<gjk::Fraction>(decimal_fraction(p.x()), decimal_fraction(p.y()), decimal_fraction(p.z()));
  };
  gjk::Pose<gjk::Fraction> pose{{}, fractions(object.pose.translation)};
  for (int axis = 0; axis < 3; ++axis) pose.rotation.col(axis) = fractions(object.pose.rotation.col(axis));
  std::vector<gjk::Vec3<gjk::Fraction>> points;
  for (const Point& p : std::get<Points>(object.form)) points.push_back(pose(fractions(p)));
  return gjk::PointSet<gjk::Fraction>(std::move(points));
}

bool has_whole_matrix(const Pose& pose) {
  return !pose.quaternion && pose.rotation == Eigen::Matrix3d(pose.rotation.array().round().matrix());
}

/// Whether the pose is a turn by degrees whose sines were rounded.
bool has_rounded_matrix(const Pose& pose) {
  return !pose.quaternion && !pose.matrix_as_written && !has_whole_matrix(pose);
}

/// Returns: the exact answer about the decimals; undecided where it is not known. A turn by degrees has no decimals, unless its
/// matrix is of whole numbers.
Status answer_of_decimals(const Object& a, const Object& b) {
  if (has_rounded_matrix(a.pose) || has_rounded_matrix(b.pose)) return Status::undecided;
  if (const Status status = answer_of_scaled(a, b); status != Status::undecided) return status;
  const auto has_fractions = [](const Object& object) {
    return std::holds_alternative<Points>(object.form) && !object.pose.quaternion;
  };
  if (!has_fractions(a) || !has_fractions(b)) return Status::undecided;
  return gjk::collision<gjk::Fraction, gjk::Complete<>>(in_fractions(a), in_fractions(b), {}).status;
}

// -- Exchanged --------------------------------------------------------------------------------------------------------

/// Whether the search begins between the centers, as read: then it does so from the other side with a and b exchanged.
bool begins_between_centers(const Scene& scene) {
  if (gjk::first_point(scene.rules) != gjk::FirstPoint::tested) return false;
  Scene as_read = scene;
  as_read.a = a_as_read(scene);
  as_read.b = b_as_read(scene);
  as_read.scalar = Scalar::binary64;
  as_read = from_center_to_center(std::move(as_read));
  if (scene.scalar == Scalar::binary32) as_read = in_float(std::move(as_read));
  return as_read.options.first_direction == scene.options.first_direction;
}

Status answer_exchanged(Scene scene) {
  if (begins_between_centers(scene)) scene.options.first_direction *= -1;
  std::swap(scene.a, scene.b);
  return answer_of(run(scene));
}

}  // namespace

Truth truth_of(const Scene& scene, Status shown) {
  if (scene.leaves_truth_out) return {};
  const Object &a = a_as_read(scene), &b = b_as_read(scene);
  Truth truth{exact_answer(a, b)};
  if (is_near_contact(a, b, Scalar::binary64)) {  // else what rounds by half a unit in the last place changes nothing
    truth.by_rounded_turn = has_rounded_matrix(a.pose) || has_rounded_matrix(b.pose);
    const Status of_decimals = answer_of_decimals(a, b);
    const Status known = truth.answer.status != Status::undecided ? truth.answer.status : shown;
    const bool is_told = is_open(truth) || truth.by_rounded_turn;  // that nothing is certain
    if (of_decimals != known && !(of_decimals == Status::undecided && is_told)) truth.of_decimals = of_decimals;
  }
  if (!scene.mistake && !scene.certified)  // a mistake is about one of them, and a proof comes to the truth
    if (const Status exchanged = answer_exchanged(scene); exchanged != shown) truth.exchanged = exchanged;
  return truth;
}

}  // namespace walkthroughs::model

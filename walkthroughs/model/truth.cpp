#include "walkthroughs/model/truth.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
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
    std::to_chars(text.begin(), text.end(), std::abs(x), std::chars_format::scientific);
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

/// Multiplies decimals by a power of ten, such that all of a scene's become whole numbers.
struct Times10 {
  int power;
  bool& is_exact;  ///< becomes false where no double holds the product

  double length(double x) const {
    if (x == 0) return x;
    const ShortDecimal decimal(x);
    const Integer whole = decimal.digits * pow(Integer(10), static_cast<unsigned>(decimal.exponent + power));
    const double nearest = whole.convert_to<double>();
    if (!std::isfinite(nearest) || Integer(nearest) != whole) is_exact = false;
    return nearest;
  }
  Point point(const Point& p) const { return {length(p.x()), length(p.y()), length(p.z())}; }
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
  bool may_be_exact() const { return least && *most - *least <= 40; }
};

/// Of shapes whose pose has whole numbers.
Status answer_of_scaled(Object a, Object b) {
  LastDigits digits;
  for (const Object* object : {&a, &b}) visit_numbers(*object, [&](double x) { digits.look_at(x); });
  if (!digits.may_be_exact()) return Status::undecided;
  bool is_exact = true;
  for (Object* object : {&a, &b}) {
    const Times10 times10{-*digits.least, is_exact};
    object->form = converted<double>(object->form, times10);
    object->pose.translation = times10.point(object->pose.translation);
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
  if (has_whole_matrix(a.pose) && has_whole_matrix(b.pose))
    if (const Status status = answer_of_scaled(a, b); status != Status::undecided) return status;
  const auto has_decimals = [](const Object& object) {
    return std::holds_alternative<Points>(object.form) &&
           (has_whole_matrix(object.pose) || object.pose.matrix_as_written);
  };
  if (!has_decimals(a) || !has_decimals(b)) return Status::undecided;
  return gjk::collision<gjk::Fraction, gjk::Complete<>>(in_fractions(a), in_fractions(b), {}).status;
}

// -- Exchanged --------------------------------------------------------------------------------------------------------

/// Whether exchanging the objects could matter: a mistake is about one of them, a proof comes to the truth, and between
/// centers the search is the same, mirrored.
bool is_worth_exchanging(const Scene& scene) {
  return !scene.mistake && !scene.certified &&
         !(gjk::first_point(scene.rules) == gjk::FirstPoint::tested &&
           from_center_to_center(scene).options.first_direction == scene.options.first_direction);
}

Status answer_exchanged(Scene scene) {
  std::swap(scene.a, scene.b);
  return answer_of(run(scene));
}

}  // namespace

Truth truth_of(const Scene& scene, Status shown) {
  if (scene.leaves_truth_out) return {};
  const Object &a = a_as_read(scene), &b = b_as_read(scene);
  Truth truth{exact_answer(a, b)};
  if (is_near_contact(a, b, Scalar::binary64)) {  // else what rounds by half a unit in the last place changes nothing
    const Status of_decimals = answer_of_decimals(a, b);
    const Status known = truth.answer.status != Status::undecided ? truth.answer.status : shown;
    if (of_decimals != Status::undecided && of_decimals != known) truth.of_decimals = of_decimals;
    truth.by_rounded_turn = has_rounded_matrix(a.pose) || has_rounded_matrix(b.pose);
  }
  if (is_worth_exchanging(scene))
    if (const Status exchanged = answer_exchanged(scene); exchanged != shown) truth.exchanged = exchanged;
  return truth;
}

}  // namespace walkthroughs::model

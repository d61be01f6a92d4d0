#include "walkthroughs/model/truth.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>

#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::model {
namespace {

using gjk::Status;

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
  boost::multiprecision::cpp_int digits = 0;
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
    const auto whole = boost::multiprecision::cpp_int(
        decimal.digits * pow(boost::multiprecision::cpp_int(10), static_cast<unsigned>(decimal.exponent + power)));
    const double nearest = whole.convert_to<double>();
    if (!std::isfinite(nearest) || boost::multiprecision::cpp_int(nearest) != whole) is_exact = false;
    return nearest;
  }
  Point point(const Point& p) const { return {length(p.x()), length(p.y()), length(p.z())}; }
  Point direction(const Point& d) const { return d; }
};

/// A turn by degrees has no decimals, unless its matrix is of whole numbers. A matrix as typed has, and it is multiplied, too:
/// only points are moved so.
bool has_decimals(const Object& object) {
  const Eigen::Matrix3d& R = object.pose.rotation;
  return (R == R.array().round().matrix() && !object.pose.quaternion) ||
         (object.pose.matrix_as_written && std::holds_alternative<Points>(object.form));
}

/// The powers of ten of the last digits.
struct LastDigits {
  int least = 0, most = 0;

  void look_at(double x) {
    if (x == 0) return;
    const int exponent = ShortDecimal(x).exponent;
    least = std::min(least, exponent);
    most = std::max(most, exponent);
  }
  /// Doubles hold no more digits than this.
  bool may_be_exact() const { return most - least <= 40; }
};

/// Returns: the exact answer about the decimals; undecided where it is not known, or cannot be another.
Status answer_of_decimals(const Object& a, const Object& b) {
  if (!has_decimals(a) || !has_decimals(b)) return Status::undecided;
  LastDigits of_lengths, of_matrices;
  for (const Object* object : {&a, &b}) {
    visit_numbers(*object, [&](double x) { of_lengths.look_at(x); });
    for (const double x : object->pose.rotation.reshaped()) of_matrices.look_at(x);
  }
  const int of_points = -of_lengths.least, of_both = of_points - of_matrices.least;
  const bool is_round = !std::holds_alternative<Points>(a.form) || !std::holds_alternative<Points>(b.form);
  if (of_both == 0 || (is_round && of_matrices.least < 0) || !of_lengths.may_be_exact()) return Status::undecided;
  bool is_exact = true;
  const auto scaled = [&](Object object) {
    object.form = converted<double>(object.form, Times10{of_points, is_exact});
    for (double& x : object.pose.rotation.reshaped()) x = Times10{-of_matrices.least, is_exact}.length(x);
    object.pose.translation = Times10{of_both, is_exact}.point(object.pose.translation);
    return object;
  };
  const Object scaled_a = scaled(a), scaled_b = scaled(b);
  return is_exact ? exact_answer(scaled_a, scaled_b).status : Status::undecided;
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
  Truth truth{exact_answer(a_as_read(scene), b_as_read(scene))};
  const Status of_decimals = answer_of_decimals(a_as_read(scene), b_as_read(scene));
  const Status known = truth.answer.status != Status::undecided ? truth.answer.status : shown;
  if (of_decimals != Status::undecided && of_decimals != known) truth.of_decimals = of_decimals;
  if (is_worth_exchanging(scene))
    if (const Status exchanged = answer_exchanged(scene); exchanged != shown) truth.exchanged = exchanged;
  return truth;
}

}  // namespace walkthroughs::model

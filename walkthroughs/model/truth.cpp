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
  mutable bool is_exact = true;  ///< whether doubles hold all of them

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

  Object object(Object object) const {
    object.form = converted<double>(object.form, *this);
    object.pose.translation = point(object.pose.translation);
    return object;
  }
};

/// A matrix of small whole numbers is what its decimals say.
bool is_turned_by_decimals(const Object& object) {
  const Eigen::Matrix3d& R = object.pose.rotation;
  return R == R.array().round().matrix();
}

/// Returns: the exact answer about the decimals; undecided where it is not known, or cannot be another.
Status answer_of_decimals(const Object& a, const Object& b) {
  if (!is_turned_by_decimals(a) || !is_turned_by_decimals(b)) return Status::undecided;
  int least = 0, most = 0;
  const auto look_at = [&](double x) {
    if (x == 0) return;
    const int exponent = ShortDecimal(x).exponent;
    least = std::min(least, exponent);
    most = std::max(most, exponent);
  };
  visit_numbers(a, look_at);
  visit_numbers(b, look_at);
  constexpr int beyond_exactness = 40;  // no double holds as many digits
  if (least == 0 || most - least > beyond_exactness) return Status::undecided;
  const Times10 scaled{-least};
  const Object scaled_a = scaled.object(a), scaled_b = scaled.object(b);
  return scaled.is_exact ? exact_answer(scaled_a, scaled_b).status : Status::undecided;
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

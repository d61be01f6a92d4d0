/// Scene files at random: everything that one may say, at every scale that is allowed, under every kind of name.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "walkthroughs/model/words_of.hpp"

namespace walkthroughs::test {

using namespace program;

struct RandomSceneFile {
  std::string name, text;
};

class RandomSceneFiles {
 public:
  explicit RandomSceneFiles(unsigned seed) : random_(seed) {}

  RandomSceneFile next() {
    is_plane_ = one_in(3);
    is_float_ = one_in(3);
    size_ = is_float_ ? power_of_ten(-44, 37) : power_of_ten(-323, 149);
    Json scene{{"a", object()}};
    const double of_a = size_;
    if (one_in(4)) size_ *= power_of_ten(-8, 0);
    scene["b"] = object();
    size_ = of_a;
    add_options(scene);
    return {file_name(), scene.dump()};
  }

  /// The next whose search is the same to the last bit whatever computes sines: turned by quarters at most.
  RandomSceneFile next_without_sines() {
    while (true)
      if (RandomSceneFile file = next(); !has_sines(Json::parse(file.text))) return file;
  }

 private:
  using Json = nlohmann::ordered_json;

  static bool has_sines(const Json& scene) {
    const auto is_turned = [&](const char* key) {
      const Json pose = scene[key].value("pose", Json::object());
      return pose.contains("rotation") && std::fmod(pose["rotation"]["degrees"].get<double>(), 90) != 0;
    };
    return is_turned("a") || is_turned("b");
  }

  // -- Numbers --------------------------------------------------------------------------------------------------------

  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  bool one_in(int count) { return pick(count) == 0; }
  double share() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  /// Many searches are made at everyday scales, where most decisions are taken; the others at all scales alike.
  double power_of_ten(int low, int high) {
    const int power = one_in(2) ? std::uniform_int_distribution<int>(low, high)(random_)
                                : std::uniform_int_distribution<int>(-3, 0)(random_);
    return std::strtod(("1e" + std::to_string(power)).c_str(), nullptr);  // the same to the last bit on any machine
  }
  double number() {
    constexpr std::array<double, 5> round{0, -0.0, 1, -1, 0.5};  // of many that touch, or coincide
    return (one_in(3) ? round[static_cast<std::size_t>(pick(5))] : share()) * size_;
  }
  /// Positive also in floats.
  double length() {
    const double least = is_float_ ? 0x1p-149 : 0x1p-1074;
    return std::max(std::abs(one_in(4) ? size_ : share() * size_), least);
  }
  Json point() { return is_plane_ ? Json{number(), number()} : Json{number(), number(), number()}; }
  Json axis() {
    const double size = power_of_ten(-150, 149);
    const int longest = pick(3);
    Json direction;
    for (int i = 0; i < 3; ++i) direction.push_back((i == longest ? 1 : one_in(2) ? 0 : share()) * size);
    return direction;
  }

  // -- Objects --------------------------------------------------------------------------------------------------------

  Json shape(int sums) {
    switch (pick(sums > 0 ? 5 : 4)) {
      case 0: return {{"sphere", {{"center", point()}, {"radius", length()}}}};
      case 1:
        if (is_plane_) return points();
        return {{"cylinder", {{"center", point()}, {"axis", axis()}, {"radius", length()}, {"height", length()}}}};
      case 4: return {{"sum", {shape(sums - 1), shape(sums - 1)}}};
      default: return points();
    }
  }
  Json points() {
    Json list = Json::array();
    for (int i = pick(9); i >= 0; --i) list.push_back(point());
    return {{"points", list}};
  }

  Json object() {
    Json object = shape(4);
    if (one_in(4)) object["name"] = one_in(2) ? "x" : "forty characters, of which some are ä ∞.";
    if (one_in(2)) return object;
    if (!one_in(3)) object["pose"]["translation"] = point();
    if (!one_in(3)) {
      object["pose"]["rotation"]["degrees"] = one_in(2) ? 90 * (pick(9) - 4) : share() * 720;
      if (!is_plane_) object["pose"]["rotation"]["axis"] = axis();
    }
    return object;
  }

  // -- The rest ---------------------------------------------------------------------------------------------------------

  template <std::size_t count>
  void add_word(Json& scene, const char* key, const std::array<std::string_view, count>& words) {
    if (one_in(2)) scene[key] = words[static_cast<std::size_t>(pick(static_cast<int>(count)))];
  }

  void add_options(Json& scene) {
    if (is_plane_) scene["dimension"] = 2;
    if (is_float_) scene["scalar"] = "float";
    add_word(scene, "rules", words_of::rules);
    add_word(scene, "crossing_test", words_of::crossing_test);
    add_word(scene, "zero_test", words_of::zero_test);
    const auto is_certifiable = [&](const char* key) {
      return scene[key].contains("points") && !scene[key].contains("pose");
    };
    if (is_certifiable("a") && is_certifiable("b") && !one_in(4)) scene["certified"] = true;
    if (one_in(4)) scene["iteration_limit"] = 1 + pick(20);
    if (one_in(4)) scene["title"] = one_in(2) ? "A title" : std::string(120, 'W');
    if (one_in(2)) return;
    Json direction = point();
    direction[static_cast<std::size_t>(pick(2))] = size_;  // not zero, also in floats
    scene["first_direction"] = direction;
  }

  /// Any bytes but '/' and 0, up to the 255 of most file systems.
  std::string file_name() {
    std::string stem;
    switch (pick(4)) {
      case 0:
        for (int i = pick(4); i >= 0; --i) stem += "._- ~aZ9"[pick(8)];
        break;
      case 1:
        for (int i = pick(20); i >= 0; --i) stem += static_cast<char>(pick(255) + 1);
        break;
      case 2:
        for (int i = pick(250); i >= 0; --i) stem += "ab_.\xC3\xA4"[pick(6)];
        break;
      default: stem = std::string(1 + static_cast<std::size_t>(pick(250)), "x._-"[pick(4)]);
    }
    for (char& c : stem)
      if (c == '/') c = ':';
    return stem + (one_in(4) ? ".JSON" : ".json");
  }

  std::mt19937 random_;
  double size_ = 1;
  bool is_plane_ = false, is_float_ = false;
};

}  // namespace walkthroughs::test

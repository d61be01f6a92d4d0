#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "tests/study/report/gnuplot.hpp"
#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"

namespace study {
namespace {

struct Point {
  double nanoseconds, rate;
};

/// Does some scalar change more than a tenth of the truths by writing the pairs? Such pairs are others in float (most sets at
/// 1e12 are points there), and say nothing about float and double.
bool is_lost_in_rounding(const Settings& settings, const std::string& family) {
  return std::ranges::any_of(settings.study().rows, [&](const Row& row) {
    return row.family == family && 10 * row.tally.truth_changed > row.tally.pairs();
  });
}

/// Returns: the families that every method was asked about, so that all points speak of the same families. Those that
/// consist of pairs known to cycle are left out: no rules help there.
std::vector<std::string> shared_families(const Settings& settings) {
  std::vector<std::string> shared;
  for (const FamilyNote& family : settings.study().families) {
    const bool is_shared = std::ranges::all_of(settings.study().rows, [&](const Row& row) {
      return row.family != family.name ||
             (counts_at(row.tally, settings.limits().back()).pairs > 0 && !row.timings.empty());
    });
    if (is_shared && !family.name.starts_with("cycles") && !is_lost_in_rounding(settings, family.name))
      shared.push_back(family.name);
  }
  return shared;
}

/// Returns: the mean over families, each counting alike.
Point point_of(const Settings& settings, const std::vector<std::string>& families, const Setting& setting) {
  Point point{0, 0};
  const auto n = static_cast<double>(families.size());
  for (const std::string& family : families) {
    const Row& row = *settings.find(family, setting);
    point.nanoseconds += row.timings.at(setting.limit).per_query() / n;
    point.rate += failure_rate(counts_at(row.tally, setting.limit)).share() / n;
  }
  return point;
}

// -- Words beside points ----------------------------------------------------------------------------------------------

/// In shares of a panel's width and height.
struct Box {
  double left, right, low, high;
  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

Box around(double x, double y, double half_width, double half_height) {
  return {x - half_width, x + half_width, y - half_height, y + half_height};
}

/// Where words stand, seen from their point.
enum class Side { above, below, right, left };

/// Puts words beside points where there is room.
class Labels {
 public:
  explicit Labels(const std::vector<Box>& taken) : taken_(taken) {}

  /// Returns: the command that puts the words on the first side where there is room, "" where there is none. `x`, `y`: of
  /// the point, in shares of the panel.
  std::string place(const std::string& words, double x, double y, const std::vector<Side>& sides) {
    for (const Side side : sides) {
      const Box box = box_of(words, x, y, side);
      const bool is_inside = box.left > 0 && box.right < 1 && box.low > 0 && box.high < 1;
      if (!is_inside || std::ranges::any_of(taken_, [&](const Box& other) { return box.overlaps(other); })) continue;
      taken_.push_back(box);
      std::ostringstream command;
      command << "set label " << in_quotes(words) << " at graph " << (box.left + box.right) / 2 << ','
              << (box.low + box.high) / 2 << " center font ',10' front\n";
      return command.str();
    }
    return "";
  }

 private:
  static Box box_of(const std::string& words, double x, double y, Side side) {
    const double half_width = 0.017 * static_cast<double>(letters(words)) + 0.006, half_height = 0.022;
    const double aside = 0.03 + half_width, away = 0.045;
    switch (side) {
      case Side::above: return around(x, y + away, half_width, half_height);
      case Side::below: return around(x, y - away, half_width, half_height);
      case Side::right: return around(x + aside, y, half_width, half_height);
      case Side::left: return around(x - aside, y, half_width, half_height);
    }
    return around(x, y, half_width, half_height);
  }

  static std::ptrdiff_t letters(const std::string& utf8) {
    return std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; });
  }

  std::vector<Box> taken_;
};

/// Returns: "certified: 0 of 123456 wrong or undecided", in these families and all scalars.
std::string certified_title(const Settings& settings, const std::vector<std::string>& families,
                            const std::string& rules) {
  Counts sum;
  for (const Row& row : settings.study().rows)
    if (row.rules == rules && std::ranges::count(families, row.family)) sum += counts_at(row.tally, no_limit);
  return rules + ": " + std::to_string(failure_rate(sum).count) + " of " + std::to_string(sum.pairs) +
         " wrong or undecided";
}

// -- Panels -----------------------------------------------------------------------------------------------------------

/// A panel of the picture: all methods of one scalar, with a time axis of its own, which is logarithmic: a mean over families
/// may be that of a few which take ten times as long.
class Panel {
 public:
  Panel(const Settings& settings, const std::vector<std::string>& families, std::string scalar)
      : settings_(settings), scalar_(std::move(scalar)) {
    for (const std::string& rules : settings_.rules())
      for (const std::string& zero_test : settings_.zero_tests())
        if (settings_.find(families.front(), {rules, scalar_, zero_test, 0}) != nullptr)
          add_curve(families, rules, zero_test);
  }

  double worst() const { return worst_; }

  /// Returns: the commands that draw it, with rates up to `top`, the same in all panels.
  std::string text(double top) const {
    const bool is_slow = slowest_ > 20000;
    const double per = is_slow ? 1000 : 1;
    std::ostringstream script;
    script << "set title " << in_quotes(scalar_) << " font ',13'\nset xlabel '"
           << (is_slow ? "microseconds" : "nanoseconds") << " per query'\nset xrange [" << begin() / per << ":"
           << end() / per << "]\nset yrange [" << bottom * top << ":" << top << "]\nset xtics ("
           << round_numbers(begin() / per, end() / per) << ")\n"
           << labels(top);
    std::string lines;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      script << "$curve" << i << " << EOD\n";
      for (const Point& p : curves_[i].points) script << p.nanoseconds / per << ' ' << p.rate << '\n';
      script << "EOD\n";
      lines += (i == 0 ? "plot $curve" : ", $curve") + std::to_string(i) + " with linespoints " + curves_[i].style;
    }
    return script.str() + lines + '\n';
  }

 private:
  static constexpr double bottom = -0.06;  // where the axis begins, in shares of its top

  struct Curve {
    std::vector<Point> points;  ///< by limit
    std::string style;
    bool is_certified;
  };

  void add_curve(const std::vector<std::string>& families, const std::string& rules, const std::string& zero_test) {
    Curve curve{{}, style_of(families, rules, zero_test), is_certified(rules)};
    for (const int limit : limits_for(rules, settings_.limits())) {
      const Point p = point_of(settings_, families, {rules, scalar_, zero_test, limit});
      slowest_ = std::max(slowest_, p.nanoseconds);
      fastest_ = std::min(fastest_, p.nanoseconds);
      worst_ = std::max(worst_, p.rate);
      curve.points.push_back(p);
    }
    curves_.push_back(std::move(curve));
  }

  /// The first limit of each curve has its number, and those that follow one number for all, as they lie near to each other.
  std::string labels(double top) const {
    const auto x = [&](const Point& p) { return std::log(p.nanoseconds / begin()) / std::log(end() / begin()); };
    const auto y = [&](const Point& p) { return (p.rate / top - bottom) / (1 - bottom); };
    std::vector<Box> marks;
    for (const Curve& curve : curves_)
      for (const Point& p : curve.points) marks.push_back(around(x(p), y(p), 0.025, 0.017));
    Labels labels(marks);
    std::string commands;
    const std::vector<int>& limits = settings_.limits();
    const std::string others = limits.size() < 2    ? ""
                               : limits.size() == 2 ? std::to_string(limits[1])
                                                    : std::to_string(limits[1]) + "–" + std::to_string(limits.back());
    // Curves fall, as more iterations leave less undecided: above their beginning and below their end no line is crossed.
    const std::vector<Side> at_first{Side::above, Side::left, Side::right, Side::below},
        at_last{Side::below, Side::left, Side::right, Side::above};
    const auto place = [&](const std::string& words, const Point& p, const std::vector<Side>& sides) {
      commands += labels.place(words, x(p), y(p), sides);
    };
    for (const Curve& curve : curves_)  // first, as they have no other number, and off the line of zero
      if (curve.is_certified)
        place(in_short(curve.points.front().rate) + " wrong", curve.points.front(), {Side::above, Side::below});
    for (const Curve& curve : curves_) {
      if (curve.is_certified) continue;
      place(std::to_string(limits.front()), curve.points.front(), at_first);
      if (!others.empty()) place(others, curve.points.back(), at_last);
    }
    return commands;
  }

  /// Squares for the usual rules, triangles and diamonds for others; filled for the first zero test.
  std::string style_of(const std::vector<std::string>& families, const std::string& rules,
                       const std::string& zero_test) const {
    if (is_certified(rules))
      return std::string("lc rgb ") + purple + " ps 1.4 pt " + (rules == certified_rules[0].name ? "7" : "6") +
             " title " + in_quotes(certified_title(settings_, families, rules));
    const bool is_filled = zero_test == settings_.zero_tests().front();
    const std::string title = " title " + in_quotes("rules " + rules + ", zero test " + zero_test);
    if (rules == settings_.usual().rules)
      return std::string("lc rgb ") + blue + " dt 1 lw 1.5 ps 1.4 pt " + (is_filled ? "5" : "4") + title;
    if (rules == "eager")
      return std::string("lc rgb ") + green + " dt '.' lw 1.5 ps 1.4 pt " + (is_filled ? "13" : "12") + title;
    if (rules == "as-printed")
      return std::string("lc rgb ") + vermilion + " dt '-' lw 1.5 ps 1.4 pt " + (is_filled ? "9" : "8") + title;
    if (rules == "complete")
      return std::string("lc rgb ") + orange + " dt '_' lw 1.5 ps 1.4 pt " + (is_filled ? "11" : "10") + title;
    throw std::logic_error("rules '" + rules + "' have no line style");
  }

  // Where the time axis begins and ends. A clock may have seen no time pass.
  double begin() const { return std::max(fastest_, 1.0) / 1.4; }
  double end() const { return std::max(slowest_, 1.0) * 1.4; }

  /// Returns: "100, 200, 500", those between the two.
  static std::string round_numbers(double low, double high) {
    std::ostringstream list;
    for (double power = std::pow(10, std::floor(std::log10(low))); power < high; power *= 10)
      for (const int first : {1, 2, 5})
        if (first * power >= low && first * power <= high) list << (list.tellp() > 0 ? ", " : "") << first * power;
    return list.str();
  }

  const Settings& settings_;
  std::string scalar_;
  std::vector<Curve> curves_;
  double fastest_ = std::numeric_limits<double>::infinity(), slowest_ = 0, worst_ = 0;
};

std::string heading(const Settings& settings, std::size_t families) {
  std::string limits;
  for (const int limit : settings.limits()) limits += (limits.empty() ? "" : ", ") + std::to_string(limit);
  return "Wrong or undecided against time, means of the " + std::to_string(families) + " of " +
         std::to_string(settings.study().families.size()) +
         " families that float can hold and every setting is asked about; iteration limits " + limits;
}

}  // namespace

Picture error_vs_time(const Settings& settings) {
  const std::vector<std::string> families = shared_families(settings);
  std::ostringstream script;
  script << canvas(1060, 570);
  if (families.empty())
    return {"error-vs-time.png",
            script.str() + "set title 'no family was asked in every setting'\nplot [0:1] [0:1] NaN notitle\n"};
  std::vector<Panel> panels;
  double top = 0;
  for (const std::string& scalar : settings.scalars()) {
    panels.emplace_back(settings, families, scalar);
    top = std::max(top, 1.12 * panels.back().worst());
  }
  if (top == 0) top = 1;  // nothing went wrong
  const std::string made = small_print(settings) + "; CPU time on " + processors_of(settings.study());
  script << "set logscale x\nset multiplot layout 1," << panels.size()
         << " margins 0.06,0.985,0.135,0.705 spacing 0.045,0.1 title " << in_quotes(heading(settings, families.size()))
         << " font ',10'\nset label " << in_quotes(made)
         << " at screen 0.985,0.025 right font ',9'\nset grid\nset xzeroaxis lt 1 lc rgb 'black'\n"
         << "set ylabel 'share wrong or undecided, mean of families'\n"
         << "set key at screen 0.5,0.935 center top vertical maxrows 5 samplen 4\n";
  for (const Panel& panel : panels) script << panel.text(top) << "unset ylabel\nunset key\nunset label\n";
  script << "unset multiplot\n";
  return {"error-vs-time.png", script.str()};
}

}  // namespace study

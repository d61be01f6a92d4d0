#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "tests/study/gnuplot.hpp"
#include "tests/study/pictures.hpp"
#include "tests/study/tables.hpp"

namespace study {
namespace {

struct Point {
  double nanoseconds, rate;
};

/// Returns: the families that every method was asked about, so that all points speak of the same families. Those that
/// consist of pairs known to cycle are left out: no setting helps there.
std::vector<std::string> shared_families(const Settings& settings) {
  std::vector<std::string> shared;
  for (const FamilyNote& family : settings.study().families) {
    const bool is_shared = std::ranges::all_of(settings.study().rows, [&](const Row& row) {
      return row.family != family.name ||
             (counts_at(row.tally, settings.limits().back()).pairs > 0 && !row.timings.empty());
    });
    if (is_shared && !family.name.starts_with("cycles")) shared.push_back(family.name);
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

/// A panel of the picture: all methods of one scalar, with a time axis of its own.
class Panel {
 public:
  Panel(const Settings& settings, const std::vector<std::string>& families, std::string scalar)
      : settings_(settings), families_(families), scalar_(std::move(scalar)) {
    for (const std::string& rules : settings_.rules())
      for (const std::string& zero_test : settings_.zero_tests())
        if (settings_.find(families_.front(), {rules, scalar_, zero_test, 0}) != nullptr) add_curve(rules, zero_test);
  }

  double slowest() const { return slowest_; }
  double worst() const { return worst_; }

  /// Returns: the commands that draw it.
  std::string text() const {
    const bool is_slow = slowest_ > 20000;
    std::ostringstream script;
    script << data_.str() << "per = " << (is_slow ? "1000.0" : "1.0") << "\nset title " << in_quotes(scalar_)
           << " font ',13'\nset xlabel '" << (is_slow ? "microseconds" : "nanoseconds")
           << " per query'\nset xrange [0:" << 1.12 * slowest_ / (is_slow ? 1000 : 1) << "]\nset xtics "
           << step(slowest_ / (is_slow ? 1000 : 1)) << '\n'
           << "plot " << lines_ << labels_ << '\n';
    return script.str();
  }

 private:
  void add_curve(const std::string& rules, const std::string& zero_test) {
    const std::string curve = "$curve" + std::to_string(curves_), labels = "$labels" + std::to_string(curves_);
    ++curves_;
    std::ostringstream points, words;
    for (const int limit : settings_.limits()) {
      const Point p = point_of(settings_, families_, {rules, scalar_, zero_test, limit});
      slowest_ = std::max(slowest_, p.nanoseconds);
      worst_ = std::max(worst_, p.rate);
      points << p.nanoseconds << ' ' << p.rate << '\n';
      if (const std::string label = label_of(limit); !label.empty())
        words << p.nanoseconds << ' ' << p.rate << ' ' << label << '\n';
    }
    data_ << curve << " << EOD\n" << points.str() << "EOD\n" << labels << " << EOD\n" << words.str() << "EOD\n";
    lines_ += (lines_.empty() ? "" : ", \\\n  ") + curve + " using ($1/per):2 with linespoints " +
              style_of(rules, zero_test) + " title " + in_quotes("rules " + rules + ", zero test " + zero_test);
    labels_ += ", \\\n  " + labels + " using ($1/per):2:3 with labels font ',10' offset " +
               (is_usual(rules) ? "0,-0.8" : "0,0.8") + " notitle";
  }

  bool is_usual(const std::string& rules) const { return rules == settings_.usual().rules; }

  /// Squares for the usual rules, triangles for others; filled for the first zero test.
  std::string style_of(const std::string& rules, const std::string& zero_test) const {
    const bool is_filled = zero_test == settings_.zero_tests().front();
    if (is_usual(rules)) return std::string("lc rgb ") + blue + " dt 1 lw 1.5 ps 1.4 pt " + (is_filled ? "5" : "4");
    return std::string("lc rgb ") + vermilion + " dt '-' lw 1.5 ps 1.4 pt " + (is_filled ? "9" : "8");
  }

  /// Returns: the words beside the point. Where more iterations no longer help points lie on each other, and share a label.
  std::string label_of(int limit) const {
    const std::vector<int>& all = settings_.limits();
    if (limit == all.front()) return std::to_string(limit);
    if (limit != settings_.usual().limit) return "";
    return all.size() == 2 ? std::to_string(limit) : std::to_string(all[1]) + "–" + std::to_string(all.back());
  }

  /// Returns: a round distance of marks on an axis from 0 to `end`, at most five of them.
  static double step(double end) {
    const double power = std::pow(10, std::floor(std::log10(end / 4)));
    const double first = end / 4 / power;
    return power * (first <= 1 ? 1 : first <= 2 ? 2 : first <= 5 ? 5 : 10);
  }

  const Settings& settings_;
  const std::vector<std::string>& families_;
  std::string scalar_;
  std::ostringstream data_;
  std::string lines_, labels_;
  double slowest_ = 0, worst_ = 0;
  int curves_ = 0;
};

std::string heading(const Settings& settings, std::size_t families) {
  std::string limits;
  for (const int limit : settings.limits()) limits += (limits.empty() ? "" : ", ") + std::to_string(limit);
  return "Wrong or undecided against time, means of " + std::to_string(families) + " of " +
         std::to_string(settings.study().families.size()) +
         " families (those that every scalar can hold); along each line the iteration limit is " + limits;
}

}  // namespace

Picture error_vs_time(const Settings& settings) {
  const std::vector<std::string> families = shared_families(settings);
  std::ostringstream script;
  script << canvas(1180, 600);
  if (families.empty())
    return {"error-vs-time.png",
            script.str() + "set title 'no family was asked in every setting'\nplot [0:1] [0:1] NaN notitle\n"};
  double worst = 0;
  for (const std::string& scalar : settings.scalars())
    worst = std::max(worst, Panel(settings, families, scalar).worst());
  script
      << "set multiplot layout 1," << settings.scalars().size()
      << " margins 0.055,0.985,0.13,0.76 spacing 0.04,0.1 title " << in_quotes(heading(settings, families.size()))
      << " font ',11'\nset yrange [" << -0.05 * worst << ":" << 1.12 * worst << "]\nset grid\n"
      << "set ylabel 'share wrong or undecided, mean of families'\nset key at screen 0.5,0.925 center top vertical maxrows 2 samplen 4\n"
      << "set label 1 " << in_quotes(small_print(settings) + "; " + processors_of(settings.study()))
      << " at screen 0.985,0.02 right font ',9'\n";
  for (const std::string& scalar : settings.scalars())
    script << Panel(settings, families, scalar).text() << "unset ylabel\nunset key\nunset label 1\n";
  script << "unset multiplot\n";
  return {"error-vs-time.png", script.str()};
}

}  // namespace study

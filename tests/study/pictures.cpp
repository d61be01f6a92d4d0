#include "tests/study/pictures.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <system_error>

#include "tests/study/tables.hpp"

namespace study {
namespace {

/// Colours that differ for colour-blind readers as well (Okabe and Ito), each with a mark of its own.
struct Look {
  const char* colour;
  int filled_mark, open_mark;
};
constexpr Look looks[] = {{"#D55E00", 7, 6}, {"#0072B2", 5, 4}, {"#009E73", 9, 8}, {"#000000", 13, 12}};

std::string setup(int width, int height) {
  return "set terminal pngcairo size " + std::to_string(width) + "," + std::to_string(height) +
         " background rgb 'white' font 'DejaVu Sans,11'\nset encoding utf8\n";
}

/// Returns: the text as gnuplot reads it: underscores and carets are no marks here.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? "''" : std::string(1, c);
  return "'" + inside + "'";
}

std::string small_print(const Settings& settings) {
  const Header& header = settings.study().header;
  return header.command + "; " + header.compiler;
}

// -- Error against time -----------------------------------------------------------------------------------------------

struct Point {
  double nanoseconds, rate;
  int limit;
};

/// Returns: the families that every method was asked about, so that all points speak of the same pairs.
std::vector<std::string> shared_families(const Settings& settings) {
  std::vector<std::string> shared;
  for (const FamilyNote& family : settings.study().families) {
    const bool is_shared = std::ranges::all_of(settings.study().rows, [&](const Row& row) {
      return row.family != family.name ||
             (counts_at(row.tally, settings.limits().back()).pairs > 0 && !row.timings.empty());
    });
    if (is_shared) shared.push_back(family.name);
  }
  return shared;
}

/// Returns: the mean over families, each counting alike.
Point point_of(const Settings& settings, const std::vector<std::string>& families, const Setting& setting) {
  Point point{0, 0, setting.limit};
  const auto n = static_cast<double>(families.size());
  for (const std::string& family : families) {
    const Row& row = *settings.find(family, setting);
    point.nanoseconds += row.timings.at(setting.limit).per_query() / n;
    point.rate += failure_rate(counts_at(row.tally, setting.limit)).value() / n;
  }
  return point;
}

/// One line of a picture: all limits of one method.
struct Curve {
  Setting setting;
  std::vector<Point> points;
};

std::vector<Curve> curves_of(const Settings& settings, const std::vector<std::string>& families) {
  std::vector<Curve> curves;
  for (const Row& row : settings.study().rows) {
    if (families.empty() || row.family != families.front()) continue;
    Curve curve{{row.rules, row.scalar, row.zero_test, 0}, {}};
    for (const int limit : settings.limits()) {
      curve.setting.limit = limit;
      curve.points.push_back(point_of(settings, families, curve.setting));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::size_t position(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

/// Colour and form of the mark tell the scalar, its filling the zero test, the dashes the rules.
std::string style_of(const Settings& settings, const Setting& setting) {
  const Look& look = looks[position(settings.scalars(), setting.scalar) % std::size(looks)];
  const bool is_first_test = setting.zero_test == settings.zero_tests().front();
  const bool is_first_rules = setting.rules == settings.usual().rules;
  return "lc rgb '" + std::string(look.colour) + "' pt " +
         std::to_string(is_first_test ? look.filled_mark : look.open_mark) + " ps 1.3 lw 1.5 dt " +
         (is_first_rules ? "1" : "'-'");
}

}  // namespace

Picture error_vs_time(const Settings& settings) {
  const std::vector<std::string> families = shared_families(settings);
  const std::vector<Curve> curves = curves_of(settings, families);
  std::ostringstream script;
  script << setup(1200, 800);
  std::string plots;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string block = "$curve" + std::to_string(i);
    script << block << " << EOD\n";
    for (const Point& p : curves[i].points) script << p.nanoseconds << ' ' << p.rate << ' ' << p.limit << '\n';
    script << "EOD\n";
    const Setting& s = curves[i].setting;
    plots += (i == 0 ? "plot " : ", \\\n  ") + block + " using 1:2 with linespoints " + style_of(settings, s) +
             " title " + quoted(s.scalar + ", " + s.rules + ", zero test " + s.zero_test);
  }
  script << "set logscale xy\nset xlabel 'nanoseconds per query'\nset ylabel 'wrong or undecided, mean of families'\n"
         << "set key outside right\nset grid\n"
         << plots << '\n';
  return {"error-vs-time.png", script.str()};
}

namespace {

// -- Heat map ---------------------------------------------------------------------------------------------------------

constexpr double least_shade = 1e-6;  // rates from here to 1 have a shade; none at all is white

/// Returns: the label in a cell, and its colour, so that the shade is not all that tells the rate.
std::string cell_label(std::size_t column, std::size_t row, const std::optional<Counts>& counts) {
  const double rate = counts ? failure_rate(*counts).value() : 0;
  const std::string text = counts ? in_short(rate) : "not asked";
  const char* const colour = !counts ? "#777777" : rate > 0.02 ? "#FFFFFF" : "#000000";
  return "set label " + quoted(text) + " at " + std::to_string(column) + "," + std::to_string(row) +
         " center front textcolor rgb '" + colour + "'\n";
}

std::string tics(const std::string& axis, const std::vector<std::string>& names) {
  std::string text = "set " + axis + "tics (";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : ", ") + quoted(names[i]) + " " + std::to_string(i);
  return text + ") scale 0\n";
}

std::string ends(std::size_t cells) { return "[-0.5:" + std::to_string(cells - 1) + ".5]"; }

std::string described(const Setting& setting) {
  return "rules " + setting.rules + ", zero test " + setting.zero_test + ", at most " + std::to_string(setting.limit) +
         " iterations";
}

}  // namespace

Picture heat_map(const Settings& settings) {
  std::vector<std::string> families;
  std::ostringstream cells, labels;
  for (const FamilyNote& family : settings.study().families) {
    for (std::size_t s = 0; s < settings.scalars().size(); ++s) {
      Setting setting = settings.usual();
      setting.scalar = settings.scalars()[s];
      const auto counts = settings.counts(family.name, setting);
      labels << cell_label(s, families.size(), counts);
      const double rate = counts ? failure_rate(*counts).value() : 0;
      if (rate > 0) cells << s << ' ' << families.size() << ' ' << std::log10(std::max(rate, least_shade)) << '\n';
    }
    families.push_back(family.name);
  }
  if (cells.str().empty()) cells << "0 0 NaN\n";
  std::ostringstream script;
  script << setup(1000, 190 + 24 * static_cast<int>(families.size())) << "$cells << EOD\n"
         << cells.str() << "EOD\n"
         << labels.str() << "set title " << quoted("Wrong or undecided, share of pairs: " + described(settings.usual()))
         << "\n"
         << tics("x", settings.scalars()) << tics("y", families) << "set xrange " << ends(settings.scalars().size())
         << "\nset yrange " << ends(families.size())
         << " reverse\nset palette defined (0 '#FFF3B0', 1 '#F6C667', 2 '#E58F4B', 3 '#B8504A', 4 '#6F2C5B', 5 "
            "'#2A1145')\n"
         << "set cbrange [-6:0]\nset cbtics ('1' 0, '0.1' -1, '0.01' -2, '1e-3' -3, '1e-4' -4, '1e-5' -5, '1e-6' -6)\n"
         << "set xlabel " << quoted(small_print(settings)) << " font ',9'\nset style fill solid noborder\nunset key\n"
         << "plot $cells using 1:2:(0.5):(0.5):3 with boxxyerror palette\n";
  return {"heat-map.png", script.str()};
}

namespace {

// -- Iterations -------------------------------------------------------------------------------------------------------

/// Returns: the share of queries that took k iterations, the mean of the families that have any; [0] is never taken.
std::vector<double> shares(const std::vector<Counts>& families, Histogram Counts::*iterations) {
  std::vector<double> mean;
  std::size_t asked = 0;
  for (const Counts& counts : families) asked += total(counts.*iterations) > 0;
  for (const Counts& counts : families) {
    const Histogram& histogram = counts.*iterations;
    const std::uint64_t all = total(histogram);
    mean.resize(std::max(mean.size(), histogram.size()));
    for (std::size_t k = 0; all > 0 && k < histogram.size(); ++k)
      mean[k] += static_cast<double>(histogram[k]) / static_cast<double>(all * asked);
  }
  return mean;
}

std::string histogram_data(const std::string& block, const std::vector<Counts>& families) {
  const std::vector<double> hits = shares(families, &Counts::hit_iterations),
                            misses = shares(families, &Counts::miss_iterations);
  std::ostringstream text;
  text << block << " << EOD\n";
  for (std::size_t k = 1; k < std::max(hits.size(), misses.size()); ++k)
    text << k << ' ' << (k < hits.size() ? hits[k] : 0) << ' ' << (k < misses.size() ? misses[k] : 0) << '\n';
  text << "EOD\n";
  return text.str();
}

std::string histogram_plot(const std::string& block, const std::string& title) {
  return "set title " + quoted(title) + "\nplot " + block +
         " using ($1-0.2):($2>0?$2:NaN) with boxes fs solid 1 lc rgb '#0072B2' title 'hits', " + block +
         " using ($1+0.2):($3>0?$3:NaN) with boxes fs pattern 2 lc rgb '#D55E00' title 'misses'\n";
}

}  // namespace

Picture iterations(const Settings& settings) {
  const Setting usual = settings.usual();
  std::vector<Counts> all;
  for (const FamilyNote& family : settings.study().families)
    if (auto counts = settings.counts(family.name, usual)) all.push_back(std::move(*counts));
  if (all.empty()) all.emplace_back();
  const std::string first = settings.study().families.empty() ? "" : settings.study().families.front().name;
  std::ostringstream script;
  script << setup(1200, 820) << histogram_data("$first", {all.front()}) << histogram_data("$all", all)
         << "set multiplot layout 2,1 title " << quoted("Iterations: " + usual.scalar + ", " + described(usual))
         << "\nset logscale y\nset yrange [1e-6:1]\nset format y '10^{%T}'\nset ylabel 'share of hits, of misses'\n"
         << "set xrange [0:" << usual.limit + 1 << "]\nset xtics 1\nset boxwidth 0.4\nset grid y\nset key top right\n"
         << histogram_plot("$first", "family " + first)
         << "set xlabel 'iterations; those that took the limit are undecided'\n"
         << histogram_plot("$all", "all families, each counting alike") << "unset multiplot\n";
  return {"iterations.png", script.str()};
}

bool draw(const Picture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / picture.file, unfinished = file.string() + ".unfinished";
  if (const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen("gnuplot 2>&1", "w"), pclose}; pipe) {
    const std::string text = "set output " + quoted(unfinished.string()) + "\n" + picture.script + "\nunset output\n";
    std::fputs(text.c_str(), pipe.get());
  }
  std::error_code error;
  const bool is_drawn = std::filesystem::file_size(unfinished, error) > 0 && !error;
  if (is_drawn) std::filesystem::rename(unfinished, file, error);
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  return is_drawn && !error;
}

}  // namespace study

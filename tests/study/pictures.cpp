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

[[maybe_unused]] std::string small_print(const Settings& settings) {
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

Picture heat_map(const Settings&) { return {"heat-map.png", setup(800, 800)}; }

Picture iterations(const Settings&) { return {"iterations.png", setup(800, 800)}; }

bool draw(const Picture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / picture.file, unfinished = file.string() + ".unfinished";
  bool drawn = false;
  if (const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen("gnuplot 2>&1", "w"), pclose}; pipe) {
    const std::string text = "set output " + quoted(unfinished.string()) + "\n" + picture.script + "\nunset output\n";
    std::fputs(text.c_str(), pipe.get());
  }
  std::error_code error;
  drawn = std::filesystem::file_size(unfinished, error) > 0 && !error;
  if (drawn) std::filesystem::rename(unfinished, file, error);
  return drawn && !error;
}

}  // namespace study

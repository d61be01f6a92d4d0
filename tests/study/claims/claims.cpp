#include "tests/study/claims/claims.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "tests/study/claims/claims_text.hpp"

namespace study {

void row(std::ostream& out, const Cells& cells) {
  for (const std::string& cell : cells) out << "| " << cell << ' ';
  out << "|\n";
}

void heading(std::ostream& out, const Cells& cells, std::size_t left) {
  row(out, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) out << (i < left ? "|---" : "|--:");
  out << "|\n";
}

std::string decimals(double x, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, x);
  return text;
}

void paragraph(std::ostream& out, const std::string& text) { out << text << "\n\n"; }

namespace {

Counted count_all(const ClaimsOptions& options) {
  const auto tell = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  Counted counted;
  counted.options = options;
  for (const Shape& shape : claim_shapes()) {
    tell("effort: " + shape.name);
    counted.efforts.push_back(measure_effort(shape, options));
  }
  for (const std::string& name : whole_number_shapes()) {
    tell("effort, in fractions: " + name);
    counted.in_fractions.push_back(measure_in_fractions(claim_shape(name), options));
  }
  for (const TriangleKind& kind : triangle_kinds()) {
    tell("Möller's test: " + kind.name);
    counted.moller.push_back(measure_moller(kind, options));
  }
  tell("Möller's test: " + common_vertex_kind().name);
  counted.common_vertex = measure_moller(common_vertex_kind(), options);
  tell("mistakes: triangles");
  counted.triangles = measure_mistakes(TestPairs::triangles, options);
  tell("mistakes: tetrahedra");
  counted.tetrahedra = measure_mistakes(TestPairs::tetrahedra, options);
  tell("mistakes: triangles on a grid");
  counted.grid = measure_mistakes(TestPairs::grid_triangles, options);
  return counted;
}

}  // namespace

void write_claims(std::ostream& out, const ClaimsOptions& options) {
  const Counted counted = count_all(options);
  const auto hard = std::ranges::find(claim_shapes(), Hardness::hard, &Shape::hardness);
  out << "# The report's claims, measured\n\n";
  paragraph(out, "Made by `gjkstep-study claims --pairs " + std::to_string(options.pairs) + " --seed " +
                     std::to_string(options.seed) + "`, compiled by " GJKSTEP_COMPILER ". " + grouped(options.pairs) +
                     " pairs of every kind, " + grouped(hard->pairs(options)) +
                     " of hard families, or all that there are. GJK is gjkstep's, in double, with the rules as "
                     "intended and exact zero tests, where nothing else is said. Intervals are Wilson's for 95 %.");
  write_claims_table(out, counted);
  write_effort(out, counted);
  write_moller(out, counted);
  write_mistakes(out, counted);
}

}  // namespace study

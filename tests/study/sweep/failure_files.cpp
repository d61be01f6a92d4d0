#include "tests/study/sweep/failure_files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "render/file.hpp"
#include "tests/study/methods/certified.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace study {
namespace {

std::string list_of(const Vec& v) {
  return "[" + walkthroughs::number_text(v.x()) + ", " + walkthroughs::number_text(v.y()) + ", " +
         walkthroughs::number_text(v.z()) + "]";
}

/// Writes one field after the other, as scene files have them.
struct FieldText {
  std::string& text;

  void operator()(walkthroughs::field::Places, const Points& points) const {
    for (const Vec& p : points) text += (text.empty() ? "[" : ",\n    ") + list_of(p);
    text += "]";
  }
  void operator()(walkthroughs::field::Length field, double x) const { add(field.name, walkthroughs::number_text(x)); }
  void operator()(auto field, const Vec& v) const { add(field.name, list_of(v)); }

 private:
  void add(std::string_view name, const std::string& value) const {
    text += std::string(text.empty() ? "{" : ", ").append("\"").append(name).append("\": ").append(value);
  }
};

std::string text_of(const Body& body) {
  const auto text = [](const auto& shape) {
    using Row = walkthroughs::RowOf<decltype(shape)>;
    std::string fields;
    Row::fields(FieldText{fields}, shape);
    return "{\"" + std::string(Row::key) + "\": " + fields + (fields.front() == '{' ? "}}" : "}");
  };
  return std::visit(text, body);
}

std::string to_string(Truth truth) {
  return truth == Truth::intersecting ? "they have a point in common" : "they are apart";
}

std::string answer_of(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return "intersecting";
    case Kind::false_negative: return "separated";
    case Kind::undecided: return "undecided";
    case Kind::false_certificate: return "right, with a certificate that does not hold";
  }
  return "";
}

/// Returns: the rules that a scene runs.
std::string rules_of(const Method& method) {
  const std::optional<gjk::RuleSet> first = first_search_of(method.rules);
  return first ? std::string(to_string(*first)) : method.rules;
}

/// Returns: "Rules as-intended, scalar double, zero test exact, at most 20 iterations."
std::string setting_of(const Failure& failure) {
  const Method& method = *failure.method;
  const std::string scalar = "scalar " + method.scalar.name;
  if (is_certified(method.rules))
    return "Asked by gjk::certified_collision(), " + scalar + ", rules of the first search " + rules_of(method) +
           ".\n// A scene cannot run the second search: what is drawn is the first, whose answer may be another one.";
  return "Rules " + method.rules + ", " + scalar + ", zero test " + method.zero_test + ", at most " +
         std::to_string(failure.limit) + " iterations.";
}

std::string comments(const Failure& failure, std::uint64_t seed) {
  const Method& method = *failure.method;
  std::string text = "// Truth: " + to_string(failure.truth) + ". Answer: " + answer_of(failure.kind) + ".\n// Pair " +
                     std::to_string(failure.index) + " of family " + failure.family + ", seed " + std::to_string(seed) +
                     ". " + setting_of(failure) + "\n";
  if (method.scalar.name != "float" && method.scalar.name != "double")
    text += "// A scene cannot run in this scalar: what is drawn is the run in double, which may end in another way.\n";
  return text;
}

/// Keys that have no default are written where they are needed only.
std::string keys_of(const Failure& failure) {
  const Method& method = *failure.method;
  std::string text = "  \"rules\": \"" + rules_of(method) + "\"";
  if (failure.limit != no_limit) text = "  \"iteration_limit\": " + std::to_string(failure.limit) + ",\n" + text;
  if (method.scalar.name == "float") text += ",\n  \"scalar\": \"float\"";
  if (method.zero_test != "exact") text += ",\n  \"zero_test\": \"" + method.zero_test + "\"";
  return text;
}

/// Whether a scene can hold these bodies: its numbers have an upper limit.
bool fits_scene(const Failure& failure) {
  return std::max(walkthroughs::largest_number(failure.pair.a), walkthroughs::largest_number(failure.pair.b)) <=
         walkthroughs::scene_limits::magnitude;
}

}  // namespace

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return "false positive";
    case Kind::false_negative: return "false negative";
    case Kind::undecided: return "undecided";
    case Kind::false_certificate: return "false certificate";
  }
  return "";
}

std::string scene_of(const Failure& failure, std::uint64_t seed) {
  return comments(failure, seed) + "{\n  \"title\": \"" + to_string(failure.kind) + ": " + failure.family + ", pair " +
         std::to_string(failure.index) + "\",\n  \"a\": " + text_of(failure.pair.a) +
         ",\n  \"b\": " + text_of(failure.pair.b) + ",\n" + keys_of(failure) + "\n}\n";
}

std::string scene_name(const Failure& failure) {
  std::string name = failure.family + "-" + failure.method->name() + "-" + to_string(failure.kind) + "-" +
                     std::to_string(failure.index) + ".json";
  std::ranges::replace(name, ' ', '-');
  return name;
}

Saved write_failures(const std::filesystem::path& folder, const std::vector<Failure>& failures, std::uint64_t seed) {
  render::make_folder(folder, "choose another with --save-failures");
  Saved saved;
  for (const Failure& failure : failures) {
    if (!fits_scene(failure)) {
      ++saved.left_out;
      continue;
    }
    render::write_file(folder / scene_name(failure), scene_of(failure, seed));
    ++saved.files;
  }
  return saved;
}

std::string left_out_words(const Saved& saved) {
  if (saved.left_out == 0) return "";
  return std::to_string(saved.left_out) + (saved.left_out == 1 ? " failure is" : " failures are") +
         " not saved: a number in them is beyond " + walkthroughs::number_text(walkthroughs::scene_limits::magnitude) +
         ", the largest that a scene file may hold";
}

}  // namespace study

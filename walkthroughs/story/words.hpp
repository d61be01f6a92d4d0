/// Numbers, vectors and expressions as captions print them, in the letters of the picture.
///
/// The events speak of roles (A is the newest vertex). A picture may keep to them, or name the corners of the hull A … G
/// (Naming). `Letters` translates: in a triangle of E, A and the newest vertex G, the event's "ABn·AO" becomes "GE_n·GO".
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/certificate.hpp"
#include "core/event_words.hpp"
#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::story {

/// Returns: whole numbers with up to eight digits, others with six significant ones; a true minus sign, never "-0".
std::string number(double value);

/// Returns: whole numbers with up to six digits, others with four significant ones, for where there is little room.
std::string short_number(double value);

/// Returns: a number's text with true minus signs.
std::string with_true_minus(std::string number);

/// Returns: "(x, y)" for vectors of the plane, "(x, y, z)" for those of space.
std::string vector(const Point& value, Dimension dimension = Dimension::plane);

/// Returns: what follows the number that decides: " > 0", " ≤ 0", or ", which counts as 0" where only the zero test takes it
/// for zero; nothing behind a zero that was found to be one, which speaks for itself. Of a vector `value` is the largest
/// component.
std::string compared_with_zero(const gjk::RegionTested<double>& region, double value);
/// Returns: the last of these, or nothing, for a value that counts as zero.
std::string as_zero(double value);

/// Returns: each reason for which regions were skipped, in the order told, with the names of these: "ruled out when the search
/// kept BC", "R4, R6". `feature`: what to call one that has no label.
std::vector<std::pair<std::string, std::string>> reasons_for_skipping(
    const std::vector<gjk::RegionTested<double>>& regions,
    const std::function<std::string(const gjk::Roles&)>& feature);

/// Returns: "(AB×AO)×AB": a trace does without brackets, a reader does not.
std::string with_brackets(const gjk::Expression& expression);

/// Returns: what `say` says of each, with `between` between them.
template <class All, class Say = std::identity>
std::string joined(const All& all, std::string_view between, const Say& say = {}) {
  std::string text;
  for (const auto& each : all) text.append(text.empty() ? "" : between).append(std::invoke(say, each));
  return text;
}

/// Returns: "a[0] − b[2]" and the like, by the places of the points in their sets.
std::vector<std::string> differences_told(const gjk::IndexPairs& pairs);

/// What the vertices are called at one moment.
class Names {
 public:
  Names(Naming naming, const LabelledHull& hull, const Moment& now) : naming_(naming), hull_(hull), now_(now) {}

  /// Returns: the name of the vertex at `w`, or an empty string where it has none. Where several vertices of the simplex
  /// lie at one place, that of the newest.
  std::string of(const Point& w) const;
  /// Returns: what to write beside that place: all names it has, "A = B".
  std::string label(const Point& w) const;
  /// Returns: the name of a vertex of the simplex that is being processed.
  std::string of(gjk::Role role) const;
  /// Returns: where roles have just moved on, what the vertex at `w` was called before the newest one came; empty where
  /// its name has stayed, or it is the newest.
  std::string before(const Point& w) const;
  /// Returns: the letters of roles, "ABCD", in order of the alphabet of the picture.
  std::string sorted(const gjk::Roles& roles) const;

  /// Returns: `text` with every word that is made of the roles A … D, O and a final n for "normal" in the letters of the
  /// picture, normals as subscripts: "ABn·AO" becomes "AB_n·AO".
  std::string translate(std::string_view text) const;
  std::string translate(const gjk::Expression& expression) const { return translate(with_brackets(expression)); }

  /// Returns: "[A, E]", oldest first as the report lists a simplex.
  std::string list(const Simplex& simplex) const;
  /// Returns: "segment AE", "triangle AEG", the letters sorted; the bare name of a single vertex.
  std::string simplex(const Simplex& simplex) const;

 private:
  /// Returns: the name that a place keeps for the whole search; empty where it has none.
  std::string own_name(const Point& w) const;
  std::vector<std::string> names_of(const Simplex& simplex) const;

  Naming naming_;
  const LabelledHull& hull_;
  const Moment& now_;
};

/// Returns: "segment AE", "triangle AEG", or the bare name of a single vertex.
std::string with_kind(const std::string& feature);

/// Returns: `text` with a capital where it begins with a word of two letters or more: "d = 3" stays as it is.
std::string as_sentence(std::string text);

/// Returns: "a box", "an octahedron"; a name of one letter, or one that begins with a capital, as it is.
std::string with_article(const std::string& name);

/// Returns: `text` with its underscores marked as such, so that a user's own words are drawn as they are.
std::string literal(std::string_view text);

/// Returns: `text` without markup, for files and terminals.
std::string plain(std::string_view text);

}  // namespace walkthroughs::story

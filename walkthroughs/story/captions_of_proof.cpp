#include <algorithm>
#include <cmath>

#include "walkthroughs/story/captions.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/number_line.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

using Mark = Fact::Mark;

const char* sign_words(int sign) { return sign > 0 ? " > 0" : sign < 0 ? " < 0" : " = 0"; }

std::string with_error(const gjk::SignTaken<double>& sign) {
  const std::string numbers = short_number(sign.value) + " ± " + short_number(sign.error);
  return sign.power ? "(" + numbers + ") · 2^(" + short_number(-*sign.power) + ")" : numbers;
}

/// Where an error bound comes from: so many times u, of `what`.
void append_bound(std::vector<Fact>& facts, int roundings, const std::string& what) {
  facts.push_back({Mark::none, "the error bound is " + std::to_string(roundings) + "u times " + what});
  facts.push_back({Mark::none, "u is the largest relative error of one rounding; the bound is derived, not measured"});
}

const std::string undecided = "the answer may be right or wrong: the exact fallback decides",
                  fallback_decides = "the exact fallback decides, from the vertices that were found";

Frame caption_of_direction(const gjk::FilterTried<double>& event, const Names& names) {
  if (event.numbers.empty())
    return frame_about(Focus::proof, "the filter cannot prove the direction: some numbers are too large or too small");
  const gjk::FilterValue& gap = event.numbers[0];
  const std::string number = name_of(gap, names) + " = " + short_number(gap.value) + (event.holds ? " > " : " ≤ ") +
                             short_number(event.bound) + ", the error bound";
  Frame frame =
      frame_by_number(Focus::proof, number,
                      event.holds ? "proven. All of the difference stays short of the origin, whatever was rounded"
                                  : "not proven. Rounding alone may have made so small a gap",
                      {event.holds ? Mark::yes : Mark::no, number});
  append_bound(frame.facts, 16, "the sum of (|a| + |b|)·|d| of x, y and z, with the largest |a| and |b|");
  if (!event.holds) frame.facts.push_back({Mark::none, undecided});
  return frame;
}

Frame caption_of_tetrahedron(const gjk::FilterTried<double>& event, const Names& names, const Moment& now) {
  if (event.numbers.empty() && now.simplex.size() < 4) {
    if (now.result && now.result->status == gjk::Status::undecided)
      return frame_about(Focus::proof, "the filter has nothing to prove: the first search has no answer",
                         {{Mark::none, fallback_decides}});
    const std::string found = now.simplex.size() == 0 ? "nothing" : names.simplex(now.simplex);
    return frame_about(
        Focus::proof, "the filter proves nothing: the first search leaves " + found,
        {{Mark::none, "only a tetrahedron can hold the origin by more than rounding"}, {Mark::none, fallback_decides}});
  }
  if (event.numbers.empty())
    return frame_about(Focus::proof,
                       "the filter cannot prove the tetrahedron: some numbers are too large or too small");
  const std::string list = joined(event.numbers, ", ", [&](const gjk::FilterValue& each) {
    return name_of(each, names) + " = " + short_number(each.value);
  });
  const std::string lie = "all four lie beyond ±" + short_number(event.bound) + ", on one side of 0";
  Frame frame = event.holds
                    ? frame_about(Focus::proof, "proven: the origin lies inside the tetrahedron, whatever was rounded",
                                  {{Mark::yes, lie},
                                   {Mark::none, list},
                                   {Mark::none, "each is the volume, six times, between the origin and one face"}})
                    : frame_about(Focus::proof,
                                  "not proven. The origin may lie outside the tetrahedron, or nearer to "
                                  "a face than rounding can tell",
                                  {{Mark::no, "not " + lie}, {Mark::none, list}});
  append_bound(frame.facts, 64, "the largest product of three coordinates");
  if (!event.holds) frame.facts.push_back({Mark::none, undecided});
  return frame;
}

constexpr std::size_t signs_in_a_line = 3, most_signs = 6;

/// Returns: of the signs of this iteration the last ones, which decide, some in each line.
std::vector<Fact> signs_taken(const Moment& now, const Names& names, Dimension dimension) {
  std::vector<std::string> signs;
  for (const gjk::SignTaken<double>& sign : now.signs)
    if (sign.exact.empty())
      signs.push_back(sign_in_words(sign, names));
    else if (dimension == Dimension::space || !is_out_of_plane(sign))
      signs.push_back(name_of(sign, names) + (sign.sign == 0 ? " = 0 exactly" : sign_words(sign.sign)));
  const std::size_t left_out = signs.size() > most_signs ? signs.size() - most_signs : 0;
  std::vector<Fact> facts;
  for (std::size_t i = left_out; i < signs.size(); ++i)
    if ((i - left_out) % signs_in_a_line == 0)
      facts.push_back({Mark::none, signs[i]});
    else
      facts.back().text += ", " + signs[i];
  if (left_out > 0) facts.push_back({Mark::none, "and before these " + std::to_string(left_out) + " more"});
  if (!std::ranges::all_of(now.signs, [](const auto& sign) { return !sign.exact.empty(); }))
    facts.push_back({Mark::none, "± is a bound on what was rounded"});
  return facts;
}

/// "exactly 3/2 > 0".
std::string exactly(const gjk::SignTaken<double>& sign) {
  const std::string fraction = short_fraction(sign.exact);
  return "exactly " + std::string(fraction.starts_with("≈") ? "a long fraction, " : "") + fraction +
         (sign.sign == 0 ? "" : sign_words(sign.sign));
}

/// Returns: the sign which shows that no point reaches across the origin; none where the search has not ended so.
const gjk::SignTaken<double>* of_the_farthest(const Moment& now) {
  const bool is_told = !now.signs.empty() && now.signs.back().expression.form == gjk::Expression::Form::largest_reach &&
                       now.signs.back().sign < 0;
  return is_told ? &now.signs.back() : nullptr;
}

/// Returns: the points of the difference that it names.
gjk::IndexPairs pairs_of(const gjk::Certificate& certificate) {
  if (const auto* feature = std::get_if<gjk::SeparatingFeature>(&certificate)) return feature->of;
  if (const auto* simplex = std::get_if<gjk::CommonSimplex>(&certificate)) return simplex->of;
  return {};
}

}  // namespace

bool is_out_of_plane(const gjk::SignTaken<double>& sign) {
  const gjk::Expression& asked = sign.expression;
  if (asked.form == gjk::Expression::Form::component_of_product) return asked.axis != 2;
  const bool is_height = asked.form == gjk::Expression::Form::dot && asked.Y == gjk::AO;
  return is_height && asked.X.kind == gjk::NamedVector::Kind::normal && sign.face.empty();
}

std::string sign_in_words(const gjk::SignTaken<double>& sign, const Names& names) {
  return name_of(sign, names) + " = " + with_error(sign) + sign_words(sign.sign);
}

std::optional<Frame> caption_of(const gjk::FilterTried<double>& event, const Names& names, const Moment& now,
                                const Scene&) {
  return event.proof == gjk::Proof::direction ? caption_of_direction(event, names)
                                              : caption_of_tetrahedron(event, names, now);
}

std::optional<Frame> caption_of(const gjk::SignTaken<double>& event, const Names& names, const Moment&,
                                const Scene& scene) {
  if (event.exact.empty() || (scene.dimension == Dimension::plane && is_out_of_plane(event))) return std::nullopt;
  const std::string name = name_of(event, names);
  const bool is_largest = event.expression.form != gjk::Expression::Form::reach && event.vertex;
  Frame frame = frame_by_number(
      Focus::sign, as_sentence(name) + " = " + with_error(event),
      is_largest ? "whether any point reaches across is in doubt. Those that reach farthest are compared in integers"
                 : "the sign is in doubt. It is computed again in integers",
      {Mark::none, name + " = " + with_error(event) + ": of either sign, or 0"});
  frame.facts.push_back({Mark::answer, exactly(event)});
  frame.facts.push_back(
      {Mark::none, "times a power of two, the same for all, the coordinates are integers: nothing is rounded"});
  if (!event.face.empty())
    frame.facts.push_back({Mark::none, "both are computed as " + names.translate(formula_of(event))});
  return frame;
}

std::optional<Frame> caption_of(const gjk::FeatureKept<double>& event, const Names& names, const Moment& now,
                                const Scene& scene) {
  const std::string kept = names.simplex(event.after);
  const gjk::Roles gone = event.dropped();
  const bool is_vertex = event.after.size() == 1;
  std::string caption;
  if (event.contains_origin)
    caption = is_vertex ? kept + " is the origin"
                        : "the origin lies " + std::string(event.after.size() == 2 ? "on " : "in ") + kept;
  else
    caption =
        is_vertex ? kept + " is the point nearest to the origin" : "the point nearest to the origin lies on " + kept;
  Frame frame = frame_about(Focus::kept, caption, signs_taken(now, names, scene.dimension));
  if (!gone.empty())
    frame.facts.insert(frame.facts.begin(),
                       {Mark::none, names.list(event.before) + " becomes " + names.list(event.after) + ": without " +
                                        joined(gone, ", ", [&](gjk::Role role) { return names.of(role); }) +
                                        " it is just as near to the origin"});
  return frame;
}

std::optional<Frame> caption_of(const gjk::Certified<double>& event, const Names& names, const Moment& now,
                                const Scene& scene) {
  const gjk::CertifiedResult& result = event.result;
  const bool is_apart = result.status == gjk::Status::separated;
  const std::string of_what =
      scene.a_as_read || scene.b_as_read ? "it is proven of the numbers rounded to floats: " : "it is proven: ";
  Frame frame =
      frame_about(Focus::proven, of_what + (is_apart ? "the objects do not intersect" : "the objects intersect"),
                  {{Mark::answer, std::string(gjk::to_string(result.status)) + ", proven"}});
  if (const auto* direction = std::get_if<gjk::SeparatingDirection>(&result.certificate))
    frame.facts.push_back({Mark::none, "the certificate is d = " + vector(direction->d, scene.dimension) +
                                           ": p·d < q·d for each point p of a and q of b"});
  else
    frame.facts.push_back({Mark::none, "the certificate is " + names.simplex(now.simplex) + ", of " +
                                           joined(differences_told(pairs_of(result.certificate)), ", ")});
  if (!std::holds_alternative<gjk::SeparatingDirection>(result.certificate))
    frame.facts.push_back(
        {Mark::none,
         is_apart
             ? "d leads from its point nearest to the origin to the origin: no difference a − b reaches the origin "
               "that way"
             : "the origin lies in it: it is the mean of these points, with weights of at least 0"});
  if (const gjk::SignTaken<double>* farthest = is_apart ? of_the_farthest(now) : nullptr)
    frame.facts.push_back({Mark::yes, farthest->exact.empty() ? sign_in_words(*farthest, names)
                                                              : name_of(*farthest, names) + ": " + exactly(*farthest)});
  if (now.guess && *now.guess != result.status)
    frame.facts.push_back({Mark::truth, "the first search had ended " + std::string(gjk::to_string(*now.guess))});
  return frame;
}

}  // namespace walkthroughs::story

#include "tests/study/sweep/study_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "tests/study/methods/certified.hpp"
#include "tests/study/sweep/checksum.hpp"
#include "tests/study/sweep/rate.hpp"
#include "tests/study/sweep/sense.hpp"

namespace study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 5;  // of the file; another one where a reader would misunderstand this one
constexpr const char* answer_names[answers] = {"intersecting", "separated", "unusable", "at_limit", "in_doubt"};
constexpr const char* proof_names[proofs] = {"predicates", "formulas", "certificate"};
constexpr const char* truth_names[2] = {"truly_separated", "truly_intersecting"};

// -- Out --------------------------------------------------------------------------------------------------------------

Json json_of(const Tally& tally) {
  Json json;
  for (std::size_t truth = 0; truth < 2; ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer)
      json[truth_names[truth]][answer_names[answer]] = tally.queries[truth][answer];
  for (std::size_t proof = 0; proof < proofs; ++proof) json["proven_by"][proof_names[proof]] = tally.proven[proof];
  json["returns"] = tally.returns;
  json["out_of_range"] = tally.out_of_range;
  json["not_askable"] = tally.not_askable;
  json["truth_changed"] = tally.truth_changed;
  json["exceptions"] = tally.exceptions;
  return json;
}

/// What certified queries have in addition.
Json json_of_certified(const Tally& tally) {
  return {{"second_iterations", tally.second_iterations},
          {"certificates", tally.certificates},
          {"false_certificates", tally.false_certificates}};
}

Json json_of(const Timing& timing) { return {{"queries", timing.queries}, {"nanoseconds", timing.nanoseconds}}; }

Json json_of(const Timings& timings) {
  Json json = Json::object();
  for (const auto& [limit, timing] : timings) json[limit_word(limit)] = json_of(timing);
  return json;
}

Json json_of(const TimesAlone& alone) {
  return {{"one_search", json_of(alone.one_search)},
          {"two_searches", json_of(alone.two_searches)},
          {"slowest", {{"pair", alone.slowest_pair}, {"nanoseconds", alone.slowest}}}};
}

/// Returns: null where there were no trials; of a census, which has no interval, the rate alone.
Json json_of(const Rate& rate) {
  if (rate.trials == 0) return nullptr;
  Json json{{"rate", rate.share()}};
  if (rate.has_interval()) json.update({{"low", rate.interval().low}, {"high", rate.interval().high}});
  return json;
}

/// What readers would work out of the tally, by iteration limit. Not read again: it says nothing that the tally does not.
Json rates_of(const FamilyNote& family, const Row& row, const std::vector<int>& limits) {
  Json json;
  for (const int limit : limits_for(row.rules, limits)) {
    const Counts counts = counts_at(family, row, limit);
    json[limit_word(limit)] = {{"hit", json_of(hit_rate(counts))},
                               {"false_positive", json_of(false_positive_rate(counts))},
                               {"false_negative", json_of(false_negative_rate(counts))},
                               {"undecided", json_of(undecided_rate(counts))}};
  }
  return json;
}

Json json_of(const FamilyNote& family, const Row& row, const std::vector<int>& limits) {
  Json json{{"family", row.family},           {"rules", row.rules},          {"scalar", row.scalar},
            {"zero_test", row.zero_test},     {"tally", json_of(row.tally)}, {"rates", rates_of(family, row, limits)},
            {"timings", json_of(row.timings)}};
  if (is_certified(row.rules)) {
    json["tally"].update(json_of_certified(row.tally));
    json["alone"] = json_of(row.alone);
  }
  return json;
}

Json json_of(const FamilyNote& family) {
  return {{"name", family.name},
          {"what", family.what},
          {"pairs", family.pairs},
          {"slow_pairs", family.slow_pairs},
          {"size", family.size ? Json(*family.size) : Json(nullptr)}};
}

// -- In ---------------------------------------------------------------------------------------------------------------

/// The library would read -1 and 1.7 as whole numbers, too.
std::uint64_t whole(const Json& json) {
  if (!json.is_number_unsigned()) throw std::invalid_argument("a count is no whole number from 0");
  return json.get<std::uint64_t>();
}

Histogram histogram_of(const Json& json) {
  Histogram histogram;
  for (const Json& each : json) histogram.push_back(whole(each));
  return histogram;
}

/// Words go into tables, and into what gnuplot is told to do.
std::string words_of(const Json& json) {
  std::string words = json.get<std::string>();
  if (std::ranges::any_of(words, [](unsigned char c) { return c < 0x20; }))
    throw std::invalid_argument("a text has control characters");
  return words;
}

Tally tally_of(const Json& json) {
  Tally tally;
  for (std::size_t truth = 0; truth < 2; ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer)
      tally.queries[truth][answer] = histogram_of(json.at(truth_names[truth]).at(answer_names[answer]));
  for (std::size_t proof = 0; proof < proofs; ++proof)
    tally.proven[proof] = whole(json.at("proven_by").at(proof_names[proof]));
  tally.returns = histogram_of(json.at("returns"));
  tally.out_of_range = whole(json.at("out_of_range"));
  tally.not_askable = whole(json.at("not_askable"));
  tally.truth_changed = whole(json.at("truth_changed"));
  tally.exceptions = whole(json.at("exceptions"));
  return tally;
}

void read_certified(const Json& json, Tally& tally) {
  tally.second_iterations = histogram_of(json.at("second_iterations"));
  tally.certificates = whole(json.at("certificates"));
  tally.false_certificates = whole(json.at("false_certificates"));
}

Timing timing_of(const Json& json) { return {whole(json.at("queries")), whole(json.at("nanoseconds"))}; }

TimesAlone times_alone_of(const Json& json) {
  const Json& slowest = json.at("slowest");
  return {timing_of(json.at("one_search")), timing_of(json.at("two_searches")), whole(slowest.at("pair")),
          whole(slowest.at("nanoseconds"))};
}

Timings timings_of(const Json& json, const std::vector<int>& limits) {
  Timings timings;
  if (json.empty()) return timings;  // nothing was asked
  for (const int limit : limits) timings[limit] = timing_of(json.at(limit_word(limit)));
  return timings;
}

Row row_of(const Json& json, const std::vector<int>& limits) {
  Row row{words_of(json.at("family")),    words_of(json.at("rules")), words_of(json.at("scalar")),
          words_of(json.at("zero_test")), tally_of(json.at("tally")), {}};
  row.timings = timings_of(json.at("timings"), limits_for(row.rules, limits));
  if (is_certified(row.rules)) {
    read_certified(json.at("tally"), row.tally);
    if (json.contains("alone")) row.alone = times_alone_of(json["alone"]);  // earlier versions did not time them
  }
  return row;
}

FamilyNote family_of(const Json& json) {
  FamilyNote family{words_of(json.at("name")), words_of(json.at("what")), whole(json.at("pairs")),
                    whole(json.at("slow_pairs"))};
  if (const Json& size = json.at("size"); !size.is_null()) family.size = whole(size);
  return family;
}

/// Returns: the limit, or one that is too large as well and is a number.
int limit_of(const Json& json) { return static_cast<int>(std::min(whole(json), std::uint64_t{no_limit - 1})); }

Header header_of(const Json& json) {
  std::vector<int> limits;
  for (const Json& each : json.at("limits")) limits.push_back(limit_of(each));
  return {words_of(json.at("command")), words_of(json.at("version")), words_of(json.at("compiler")),
          whole(json.at("seed")), std::move(limits)};
}

Study study_of(const Json& json) {
  Study study;
  study.header = header_of(json.at("header"));
  study.shard = {whole(json.at("shard").at("index")), whole(json.at("shard").at("count"))};
  for (const Json& each : json.at("processors")) study.processors.push_back(words_of(each));
  for (const Json& each : json.at("families")) study.families.push_back(family_of(each));
  for (const Json& each : json.at("rows")) study.rows.push_back(row_of(each, study.header.limits));
  expect_sense(study);
  return study;
}

}  // namespace

std::string to_json(const Study& study) {
  const Header& header = study.header;
  Json json;
  json["gjkstep_study"] = format;
  json["header"] = {{"command", header.command},
                    {"version", header.version},
                    {"compiler", header.compiler},
                    {"seed", header.seed},
                    {"limits", header.limits}};
  json["shard"] = {{"index", study.shard.index}, {"count", study.shard.count}};
  json["processors"] = study.processors;
  json["families"] = Json::array();
  for (const FamilyNote& family : study.families) json["families"].push_back(json_of(family));
  std::string rows;
  for (std::size_t r = 0; r < study.rows.size(); ++r) {
    const FamilyNote& family = study.families[r * study.families.size() / study.rows.size()];
    rows += (r == 0 ? "\n" : ",\n") + json_of(family, study.rows[r], header.limits).dump();
  }
  std::string text = json.dump();
  text.pop_back();
  return with_checksum(text + ",\"rows\":[" + rows + "\n]}");  // a line for each: a reader and diff can find them
}

Study from_json(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw StudyError(name + " is not JSON, or is cut off");
  if (!json.is_object() || !json.contains("gjkstep_study")) throw StudyError(name + " is not a file of gjkstep-study");
  const Json& found = json["gjkstep_study"];
  if (found != format)
    throw StudyError(name + " is of " + (found.is_number() ? "format " + found.dump() : "an unknown format") +
                     ", this program reads format " + std::to_string(format));
  try {
    if (!has_its_checksum(text)) throw std::invalid_argument("its checksum is not that of what it says");
    return study_of(json);
  } catch (const std::exception& error) {
    throw StudyError(name + " is damaged: " + error.what() + "; make it again with 'gjkstep-study run'");
  }
}

}  // namespace study

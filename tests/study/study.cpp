#include "tests/study/study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;  // of the file; another one where a reader would misunderstand this one
constexpr const char* answer_names[answers] = {"intersecting", "separated", "unusable", "at_limit"};
constexpr const char* truth_names[2] = {"truly_separated", "truly_intersecting"};

// -- Out --------------------------------------------------------------------------------------------------------------

Json json_of(const Tally& tally) {
  Json json;
  for (std::size_t truth = 0; truth < 2; ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer)
      json[truth_names[truth]][answer_names[answer]] = tally.queries[truth][answer];
  json["returns"] = tally.returns;
  json["out_of_range"] = tally.out_of_range;
  json["not_askable"] = tally.not_askable;
  json["truth_changed"] = tally.truth_changed;
  json["exceptions"] = tally.exceptions;
  return json;
}

Json json_of(const Timings& timings) {
  Json json = Json::object();
  for (const auto& [limit, timing] : timings)
    json[std::to_string(limit)] = {{"queries", timing.queries}, {"nanoseconds", timing.nanoseconds}};
  return json;
}

Json json_of(const Row& row) {
  return {{"family", row.family},       {"rules", row.rules},          {"scalar", row.scalar},
          {"zero_test", row.zero_test}, {"tally", json_of(row.tally)}, {"timings", json_of(row.timings)}};
}

Json json_of(const FamilyNote& family) {
  return {{"name", family.name}, {"what", family.what}, {"pairs", family.pairs}, {"slow_pairs", family.slow_pairs}};
}

// -- In ---------------------------------------------------------------------------------------------------------------

Tally tally_of(const Json& json) {
  Tally tally;
  for (std::size_t truth = 0; truth < 2; ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer)
      json.at(truth_names[truth]).at(answer_names[answer]).get_to(tally.queries[truth][answer]);
  json.at("returns").get_to(tally.returns);
  json.at("out_of_range").get_to(tally.out_of_range);
  json.at("not_askable").get_to(tally.not_askable);
  json.at("truth_changed").get_to(tally.truth_changed);
  json.at("exceptions").get_to(tally.exceptions);
  return tally;
}

Row row_of(const Json& json) {
  Row row{json.at("family"), json.at("rules"), json.at("scalar"), json.at("zero_test"), tally_of(json.at("tally")), {}};
  for (const auto& [limit, timing] : json.at("timings").items())
    row.timings[std::stoi(limit)] = {timing.at("queries"), timing.at("nanoseconds")};
  return row;
}

Study study_of(const Json& json) {
  Study study;
  const Json& header = json.at("header");
  study.header = {header.at("command"), header.at("version"), header.at("compiler"), header.at("seed"),
                  header.at("limits").get<std::vector<int>>()};
  study.shard = {json.at("shard").at("index"), json.at("shard").at("count")};
  if (study.shard.index >= study.shard.count) throw std::out_of_range("there is no such shard");
  json.at("processors").get_to(study.processors);
  for (const Json& each : json.at("families"))
    study.families.push_back({each.at("name"), each.at("what"), each.at("pairs"), each.at("slow_pairs")});
  for (const Json& each : json.at("rows")) study.rows.push_back(row_of(each));
  return study;
}

// -- Together ---------------------------------------------------------------------------------------------------------

bool is_same_setting(const Row& row, const Row& other) {
  return row.family == other.family && row.rules == other.rules && row.scalar == other.scalar &&
         row.zero_test == other.zero_test;
}

[[noreturn]] void refuse(const NamedStudy& one, const NamedStudy& other, const std::string& why) {
  throw StudyError(one.name + " and " + other.name + " do not go together: " + why);
}

void expect_same_study(const NamedStudy& one, const NamedStudy& other) {
  const Header &h = one.study.header, &g = other.study.header;
  if (h.seed != g.seed)
    refuse(one, other, "their seeds are " + std::to_string(h.seed) + " and " + std::to_string(g.seed));
  if (h.version != g.version) refuse(one, other, "they were made by versions " + h.version + " and " + g.version);
  if (h.compiler != g.compiler)
    refuse(one, other, "their programs were compiled by " + h.compiler + " and " + g.compiler);
  if (h.command != g.command) refuse(one, other, "they are shards of '" + h.command + "' and '" + g.command + "'");
  if (h != g || one.study.families != other.study.families ||
      !std::ranges::equal(one.study.rows, other.study.rows, is_same_setting))
    refuse(one, other, "their families or settings differ");
  if (one.study.shard.count != other.study.shard.count)
    refuse(one, other,
           "they are shards of " + std::to_string(one.study.shard.count) + " and of " +
               std::to_string(other.study.shard.count));
}

void expect_each_once(const std::vector<NamedStudy>& sorted) {
  const std::uint64_t count = sorted.front().study.shard.count;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].study.shard.index == sorted[i - 1].study.shard.index)
      refuse(sorted[i - 1], sorted[i], "both are shard " + std::to_string(sorted[i].study.shard.index));
  for (std::uint64_t index = 0; index < count; ++index)
    if (index >= sorted.size() || sorted[index].study.shard.index != index)
      throw StudyError("shard " + std::to_string(index) + " of " + std::to_string(count) +
                       " is missing; make it with: " + sorted.front().study.header.command + " --shard " +
                       std::to_string(index) + "/" + std::to_string(count));
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
  for (const Row& row : study.rows) rows += (rows.empty() ? "\n" : ",\n") + json_of(row).dump();
  std::string text = json.dump();
  text.pop_back();
  return text + ",\"rows\":[" + rows + "\n]}\n";  // one line for each, so that a reader and diff can find them
}

Study from_json(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw StudyError(name + " is not JSON, or is cut off");
  if (!json.is_object() || !json.contains("gjkstep_study")) throw StudyError(name + " is not a file of gjkstep-study");
  if (json["gjkstep_study"] != format)
    throw StudyError(name + " is of format " + json["gjkstep_study"].dump() + ", this program reads format " +
                     std::to_string(format));
  try {
    return study_of(json);
  } catch (const std::exception& error) {
    throw StudyError(name + " is damaged: " + error.what());
  }
}

Study merged(std::vector<NamedStudy> shards) {
  if (shards.empty()) throw StudyError("there is nothing to merge");
  for (const NamedStudy& each : shards) expect_same_study(shards.front(), each);
  std::ranges::stable_sort(shards, {}, [](const NamedStudy& each) { return each.study.shard.index; });
  expect_each_once(shards);
  Study sum = shards.front().study;
  for (std::size_t i = 1; i < shards.size(); ++i)
    for (std::size_t r = 0; r < sum.rows.size(); ++r) {
      sum.rows[r].tally += shards[i].study.rows[r].tally;
      for (const auto& [limit, timing] : shards[i].study.rows[r].timings) sum.rows[r].timings[limit] += timing;
    }
  for (const NamedStudy& each : shards)
    for (const std::string& processor : each.study.processors)
      if (std::ranges::find(sum.processors, processor) == sum.processors.end()) sum.processors.push_back(processor);
  sum.shard = {};
  return sum;
}

}  // namespace study

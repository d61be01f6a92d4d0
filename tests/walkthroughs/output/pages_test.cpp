// gjkstep render --page.

#include "walkthroughs/output/pages.hpp"

#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

std::string out_of(const Folder& folder) { return " --size 48x27 --out " + quoted(folder.path().string()); }

}  // namespace

TEST_CASE("gjkstep render --page writes a page beside the frames and one over all, and says last what to open") {
  const Folder folder;
  const Outcome outcome = run("render figure-1 regions/2-simplex-r3 --page" + out_of(folder));
  REQUIRE(outcome.exit_code == 0);
  CHECK(lines(outcome.out).back() == "open " + (folder.path() / "index.html").string());
  const std::string index = bytes_of(folder.path() / "index.html");
  CHECK(has(index, "href=\"figure-1/index.html\""));
  CHECK(has(index, "href=\"regions/2-simplex-r3/index.html\""));
  const std::string first = bytes_of(folder.path() / "figure-1/index.html");
  CHECK(has(first, "src=\"000.png\""));
  CHECK_FALSE(has(first, "gjkstep trace"));  // it has no search
  CHECK(has(first, "href=\"../index.html\""));
  CHECK(has(first, "href=\"../regions/2-simplex-r3/index.html\""));
  CHECK(has(first, "gjkstep render figure-1 --page --size 48x27<"));
  CHECK(has(bytes_of(folder.path() / "regions/2-simplex-r3/index.html"), "href=\"../../figure-1/index.html\""));
  CHECK(has(bytes_of(folder.path() / "regions/2-simplex-r3/index.html"), "gjkstep trace regions/2-simplex-r3<"));
  CHECK(bytes_of(folder.path() / "regions/2-simplex-r3/trace.jsonl") == run("trace regions/2-simplex-r3").out);
  CHECK_FALSE(fs::exists(folder.path() / "figure-1/trace.jsonl"));
}

TEST_CASE("The index is over all pages of the folder, those of earlier runs, too, in the order of the catalogue") {
  const Folder folder;
  const auto index = [&] { return bytes_of(folder.path() / "index.html"); };
  const fs::path scene = folder.path() / "mine.json";
  std::ofstream(scene) << R"({"dimension": 2, "a": {"points": [[0, 0]]}, "b": {"points": [[1, 1]]}})";
  for (const std::string& name : {quoted(scene.string()), std::string("figure-6"), std::string("regions/2-simplex-r3"),
                                  std::string("figure-4-right --theme dark"), std::string("figure-1 --page=single")})
    REQUIRE(run("render --page " + name + out_of(folder)).exit_code == 0);
  const auto place = [&](const std::string& name) { return index().find("href=\"" + name + "/index.html\""); };
  CHECK(place("figure-1") < place("figure-4-right"));
  CHECK(place("figure-4-right") < place("figure-6"));
  CHECK(place("figure-6") < place("regions/2-simplex-r3"));
  CHECK(place("regions/2-simplex-r3") < place("mine"));
  CHECK(place("mine") != std::string::npos);
  CHECK(has(index(), "5 shown"));
  CHECK(has(bytes_of(folder.path() / "compare.html"), "<option>"));

  REQUIRE(run("render --page figure-1" + out_of(folder)).exit_code == 0);
  const std::string whole = index();
  REQUIRE(run("render --page figure-1 figure-6 regions/2-simplex-r3" + out_of(folder)).exit_code == 0);
  CHECK(index() == whole);

  fs::rename(folder.path() / "figure-6", folder.path() / "elsewhere");     // a page that was moved,
  fs::remove_all(folder.path() / "regions");                               // removed,
  for (const auto& file : fs::directory_iterator(folder.path() / "mine"))  // or has lost its pictures
    if (file.path().extension() == ".png") fs::remove(file);
  fs::create_symlink("nowhere", folder.path() / "broken");
  fs::create_directories(folder.path() / "foreign");
  std::ofstream(folder.path() / "foreign/index.html") << "<!doctype html><title>of somebody else</title>";
  REQUIRE(run("render --page figure-1" + out_of(folder)).exit_code == 0);
  CHECK(has(index(), "2 shown"));
}

TEST_CASE("A page that others have written is not replaced by the index") {
  const Folder folder;
  std::ofstream(folder.path() / "index.html") << "<!doctype html><title>mine</title>";
  check_failure("render figure-1 --page" + out_of(folder), 2, {"index.html is not of gjkstep", "--out"});
  CHECK(bytes_of(folder.path() / "index.html") == "<!doctype html><title>mine</title>");
  CHECK_FALSE(fs::exists(folder.path() / "figure-1"));
  for (const char* file : {"compare.html", "figure-1/index.html"}) {
    const Folder other;
    fs::create_directories(other.path() / "figure-1");
    std::ofstream(other.path() / file) << "<!doctype html><title>mine</title>";
    check_failure("render figure-1 --page" + out_of(other), 2, {std::string(file) + " is not of gjkstep", "--out"});
    CHECK(bytes_of(other.path() / file) == "<!doctype html><title>mine</title>");
    CHECK_FALSE(fs::exists(other.path() / "index.html"));
  }
}

TEST_CASE("What to practise is linked where its page is there, of an earlier run, too") {
  const Folder folder;
  const auto steps = [&] { return bytes_of(folder.path() / "figure-4-left/questions.js"); };
  REQUIRE(run("render figure-4-left --page" + out_of(folder)).exit_code == 0);
  CHECK_FALSE(has(steps(), "../regions/2-simplex-r3/index.html"));
  REQUIRE(run("render regions/2-simplex-r3 --page" + out_of(folder)).exit_code == 0);
  REQUIRE(run("render figure-4-left --page" + out_of(folder)).exit_code == 0);
  CHECK(has(steps(), "../regions/2-simplex-r3/index.html"));
}

TEST_CASE("A page that holds all leaves nothing of an earlier one beside it") {
  const Folder folder;
  for (const char* kind : {"beside", "single"}) {
    REQUIRE(run("render figure-4-left --page=" + std::string(kind) + out_of(folder)).exit_code == 0);
    for (const char* file :
         {"page.css", "page.js", "steps.js", "events.js", "predict.js", "questions.js", "trace.jsonl"})
      CHECK(fs::exists(folder.path() / "figure-4-left" / file) == (kind == std::string("beside")));
  }
}

TEST_CASE("A trace that stands beside a page is drawn in its place, and stays as it is") {
  const Folder folder;
  REQUIRE(run("render figure-4-left --page" + out_of(folder)).exit_code == 0);
  const std::string trace = (folder.path() / "figure-4-left/trace.jsonl").string(), before = bytes_of(trace);
  REQUIRE(run("render --from-trace " + quoted(trace) + " --page" + out_of(folder)).exit_code == 0);
  CHECK(bytes_of(trace) == before);
  CHECK(has(bytes_of(folder.path() / "figure-4-left/index.html"), "href=\"trace.jsonl\""));
  REQUIRE(run("render --from-trace " + quoted(trace) + " --page=single" + out_of(folder)).exit_code == 0);
  CHECK(bytes_of(trace) == before);
}

TEST_CASE("A page has a copy of the scene or the trace that it was made of beside it, and none of another") {
  const Folder folder;
  const fs::path scene = folder.path() / "my scene.json", trace = folder.path() / "t.jsonl";
  const fs::path beside = folder.path() / "out/my-scene";
  const fs::path copy = beside / "my-scene.json", traced = beside / "trace.jsonl";
  std::ofstream(scene) << R"({"dimension": 2, "a": {"points": [[0, 0]]}, "b": {"points": [[1, 1]]}})";
  REQUIRE(run("trace " + quoted(scene.string()), "", {.out = trace.string(), .err = ""}).exit_code == 0);
  const std::string out = " --size 48x27 --out " + quoted((folder.path() / "out").string());
  REQUIRE(run("render " + quoted(scene.string()) + " --page" + out).exit_code == 0);
  CHECK(bytes_of(copy) == bytes_of(scene));
  REQUIRE(run("render " + quoted(copy.string()) + " --page" + out).exit_code == 0);  // stays as it is
  CHECK(bytes_of(copy) == bytes_of(scene));
  REQUIRE(run("render --from-trace " + quoted(trace.string()) + " --page" + out).exit_code == 0);
  CHECK_FALSE(fs::exists(copy));
  CHECK(bytes_of(traced) == bytes_of(trace));
  REQUIRE(run("render " + quoted(scene.string()) + " --page=single" + out).exit_code == 0);
  CHECK_FALSE(fs::exists(copy));
  CHECK_FALSE(fs::exists(traced));
}

TEST_CASE("Pages of --page=single hold their pictures and lead nowhere") {
  const Folder folder;
  std::ofstream(folder.path() / "compare.html") << "<meta name=\"generator\" content=\"gjkstep\">of an earlier run";
  REQUIRE(run("render figure-2 figure-1 --page=single" + out_of(folder)).exit_code == 0);
  const std::string page = bytes_of(folder.path() / "figure-2/index.html");
  CHECK(has(page, "src=\"data:image/png;base64,"));
  CHECK_FALSE(has(page, ".png\""));
  CHECK_FALSE(has(page, "href="));
  CHECK_FALSE(fs::exists(folder.path() / "compare.html"));  // neither shows a search
}

TEST_CASE("The same command writes the same pages") {
  const Folder one, other;
  for (const Folder* folder : {&one, &other})
    REQUIRE(run("render figure-1 figure-4-left --page" + out_of(*folder)).exit_code == 0);
  for (const char* page :
       {"index.html", "figure-1/index.html", "figure-4-left/index.html", "figure-4-left/events.js",
        "figure-4-left/page.js", "figure-4-left/questions.js", "figure-4-left/steps.js", "figure-4-left/page.css", "figure-4-left/trace.jsonl"})
    CHECK(bytes_of(one.path() / page) == bytes_of(other.path() / page));
}

TEST_CASE("The page of a trace is that of its walkthrough, but for what it was made from") {
  const Folder folder;
  const std::string trace = (folder.path() / "a trace.jsonl").string();
  REQUIRE(run("trace figure-4-left", "", {.out = trace, .err = ""}).exit_code == 0);
  REQUIRE(run("render --from-trace " + quoted(trace) + " --page" + out_of(folder)).exit_code == 0);
  const std::string from_trace = bytes_of(folder.path() / "figure-4-left/index.html");
  CHECK(has(from_trace, "href=\"trace.jsonl\">a trace.jsonl<"));
  CHECK(has(from_trace, "gjkstep render --from-trace '" + trace + "' --page --size 48x27<"));
  REQUIRE(run("render figure-4-left --page" + out_of(folder)).exit_code == 0);
  const std::string from_search = bytes_of(folder.path() / "figure-4-left/index.html");
  const auto steps = [](const std::string& page) { return page.substr(0, page.find("<footer>")); };
  CHECK(steps(from_trace) == steps(from_search));
}

TEST_CASE("A page of one's own scene links to the scene file, and a hostile title is text in it and in the index") {
  const Folder folder;
  const fs::path scene = folder.path() / "my scene.json";
  std::ofstream(scene) << R"({"dimension": 2, "title": "</script><img src=x onerror=alert(1)>",
    "a": {"name": "<b>", "points": [[0, 0], [2, 0], [2, 2]]}, "b": {"points": [[1, 1], [3, 1], [3, 3]]}})";
  REQUIRE(run("render " + quoted(scene.string()) + " --page" + out_of(folder)).exit_code == 0);
  const std::string page = bytes_of(folder.path() / "my-scene/index.html");
  CHECK(has(page, "href=\"my-scene.json\">my scene.json<"));
  for (const std::string& each : {page, bytes_of(folder.path() / "index.html")}) {
    CHECK(has(each, "&lt;img src=x onerror"));
    CHECK_FALSE(has(each, "<img src=x"));
  }
}

TEST_CASE(
    "Pages that would be written over something else, or that no folder takes, are refused before anything is drawn") {
  const Folder folder;
  fs::create_directories(folder.path() / "index.html");
  check_failure("render figure-1 --page" + out_of(folder), 5, {"index.html"});
  const Folder other;
  const fs::path scene = other.path() / "index.html.json";
  std::ofstream(scene) << R"({"dimension": 2, "a": {"points": [[0, 0]]}, "b": {"points": [[1, 1]]}})";
  check_failure("render " + quoted(scene.string()) + " --page" + out_of(other), 2, {"index.html"});
  CHECK_FALSE(fs::exists(other.path() / "index.html"));
  check_failure("render figure-1 --page=nonsense" + out_of(other), 2, {"--page", "single"});
}

TEST_CASE(
    "gjkstep render --frames draws a choice of frames, numbered anew, in every output, and refuses steps that are not "
    "there") {
  const Folder folder;
  const Outcome outcome = run("render figure-4-left --frames regions,end --page --strip --sheet" + out_of(folder));
  REQUIRE(outcome.exit_code == 0);
  const std::string page = bytes_of(folder.path() / "figure-4-left/index.html");
  CHECK(has(page, "Step 7 of 7"));
  CHECK(has(page, "--frames regions,end"));
  CHECK(fs::exists(folder.path() / "figure-4-left/006.png"));
  CHECK_FALSE(fs::exists(folder.path() / "figure-4-left/007.png"));
  const Untouched untouched;
  check_failure("render figure-4-left figure-1 --frames 1,2" + untouched.option, 2, {"figure-1", "no step 2"});
  check_failure("render figure-4-left --frames some" + untouched.option, 2, {"'some'", "regions"});
}

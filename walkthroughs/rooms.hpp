#pragma once

/// A namespace a room. Each sees the names of those above it in this list, and of none below: so two rooms may use one name for
/// different things, and a room cannot use what is built on it. tests/rooms_test.py holds includes to the same order.

// clang-format off
namespace walkthroughs::wrong_on_purpose {}
namespace walkthroughs::model     { using namespace wrong_on_purpose; }
namespace walkthroughs::text      { using namespace model; }
namespace walkthroughs::query     { using namespace text; }
namespace walkthroughs::story     { using namespace query; }
namespace walkthroughs::picture   { using namespace story; }
namespace walkthroughs::trace     { using namespace picture; }
namespace walkthroughs::catalogue { using namespace trace; }
namespace walkthroughs::page      { using namespace catalogue; }
namespace walkthroughs::live      { using namespace page; }
namespace walkthroughs::output    { using namespace live; }
namespace walkthroughs::pairs     { using namespace output; }
namespace walkthroughs::steps     { using namespace pairs; }
namespace walkthroughs::judge     { using namespace steps; }
namespace walkthroughs::program   { using namespace judge; }

/// Somebody else's program, asked through its standard streams, whatever it does.
///
/// No library: Boost.Process 1.74 has neither a time limit for a line nor a way to end what has left the process group.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace walkthroughs::judge {

/// The program is not there, or is none.
struct CannotStart : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class End {
  answered,  ///< as many lines as questions, or more that may be; how it ended then does not matter
  ended,     ///< by itself, too early
  late,      ///< was ended: no further line for too long
  flooding,  ///< was ended: more lines than may be
  long_line  ///< was ended: a line longer than 1 MB
};

struct RunOfProgram {
  std::vector<std::string>
      lines;                 ///< of its standard output that are kept, at most as many as may be; without line feeds
  std::size_t answers = 0;   ///< of these
  std::uint64_t others = 0;  ///< lines that do not count
  std::string first_other;   ///< of these
  End end = End::answered;
  std::string
      how;  ///< "signal 11 (Segmentation fault)", "exit code 1"; where it ended by itself, also after its last answer
  bool was_killed_by_signal = false;  ///< by itself, as when it crashes
  bool failed = false;                ///< the same, or it ended by itself with another exit code than 0
  bool closed_input = false;          ///< before it had read all, or when it was ended
  bool closed_output = false;         ///< and was still there
  bool outlives_its_input = false;    ///< has answered all, but was still there when it was ended
  std::string said;                   ///< the end of what it wrote to standard error
};

/// Lines that are kept beside answers, so many a question; more end the program, as answers do.
struct AlsoKept {
  std::function<bool(std::string_view)> counts = [](std::string_view) { return false; };
  std::size_t most = 0;
};

/// Starts the program, found as a shell finds it, writes the questions, one a line, closes its standard input, and reads until
/// it ends, or too long no further line comes. Then nothing that it has started is left, processes that left its group among
/// them; nor is it where this process is ended meanwhile. Where SIGKILL ends it, only what has left the group is left.
/// Children that this process had before are left alone.
///
/// `counts`: which lines are answers. `also`: lines that are kept in their places among these. Of others there may be a hundred a
/// question. None but answers lengthen the time limit.
///
/// Requires: no other thread of this process starts children meanwhile. Errors: CannotStart; std::system_error.
RunOfProgram run_program(const std::vector<std::string>& words, std::span<const std::string> questions,
                         std::chrono::milliseconds limit, const std::function<bool(std::string_view)>& counts,
                         const AlsoKept& also = {});

}  // namespace walkthroughs::judge

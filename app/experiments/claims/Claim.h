#pragma once

#include <string>
#include <utility>
#include <vector>

namespace haptiv {

/// What the runs say of a claim; `notRun`: runs that it needs were not asked for.
enum class Verdict { seen, notSeen, notRun };

/// A claim of the paper, or a figure that this program sets itself, judged by the runs.
struct Claim {
  std::string id;                                           ///< stable, such as circle-full-nonopt-singular
  std::string text;                                         ///< what is claimed
  std::string seenIf;                                       ///< what the verdict goes by
  std::string measured = {};                                ///< what came out, in words and numbers
  std::vector<std::pair<std::string, double>> values = {};  ///< the numbers alone, with SI units in the names
  Verdict verdict = Verdict::notRun;

  void judge(bool seen) { verdict = seen ? Verdict::seen : Verdict::notSeen; }
};

}  // namespace haptiv

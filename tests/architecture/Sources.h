#pragma once

#include <string>
#include <vector>

namespace haptiv::testing {

/// A line of a source.
struct Found {
  std::string file;  ///< from the project's root
  int line = 0;
  std::string text;  ///< what the pattern's brackets hold
};

/// Where the headers and sources below a folder have the pattern.
std::vector<Found> find(const std::string& folder, const std::string& pattern);

/// Their includes: `text` is what stands between the quotes or angle brackets.
std::vector<Found> includesBelow(const std::string& folder);

}  // namespace haptiv::testing

#pragma once

#include <string>
#include <vector>

#include "app/experiments/claims/Claim.h"

namespace haptiv {

/// The table of claims in Markdown: claim, measured, verdict, and what the verdict goes by.
std::string claimsToMarkdown(const std::vector<Claim>& claims);
/// {"claims": [{"id", "claim", "seen_if", "measured", "values": {...}, "verdict"}]}
std::string claimsToJson(const std::vector<Claim>& claims);
/// The claims that were judged, for a terminal, and how many were seen, not seen and not run.
std::string claimsToText(const std::vector<Claim>& claims);

}  // namespace haptiv

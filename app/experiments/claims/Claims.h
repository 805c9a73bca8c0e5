#pragma once

#include <string>
#include <vector>

#include "app/experiments/RunTable.h"
#include "app/experiments/claims/Claim.h"

namespace haptiv {

/// All claims, those of experiments that were not run included, each with a verdict by what was measured.
std::vector<Claim> judgeClaims(const RunTable& table);

/// Of the circles: singular poses, and which criteria keep clear of them.
std::vector<Claim> singularityClaims(const RunTable& table);
/// Of the circles: indices.
std::vector<Claim> circleClaims(const RunTable& table);
std::vector<Claim> heightClaims(const RunTable& table);
std::vector<Claim> velocityClaims(const RunTable& table);
/// Of all experiments: joint rates, tracking, self-motion.
std::vector<Claim> controlClaims(const RunTable& table);

/// "seen", "not seen" or "not run".
std::string nameOf(Verdict verdict);

}  // namespace haptiv

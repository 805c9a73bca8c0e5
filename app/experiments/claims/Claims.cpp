#include "app/experiments/claims/Claims.h"

namespace haptiv {

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::seen:
      return "seen";
    case Verdict::notSeen:
      return "not seen";
    case Verdict::notRun:
      break;
  }
  return "not run";
}

std::vector<Claim> judgeClaims(const RunTable& table) {
  std::vector<Claim> claims;
  for (const auto& judge : {singularityClaims, circleClaims, heightClaims, velocityClaims, controlClaims}) {
    for (Claim& claim : judge(table)) {
      if (claim.verdict == Verdict::notRun) claim = {claim.id, claim.text, claim.seenIf, "", {}, Verdict::notRun};
      claims.push_back(std::move(claim));
    }
  }
  return claims;
}

}  // namespace haptiv

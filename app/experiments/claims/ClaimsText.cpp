#include "app/experiments/claims/ClaimsText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/experiments/claims/Claims.h"

namespace haptiv {
namespace {

constexpr Verdict kVerdicts[] = {Verdict::seen, Verdict::notSeen, Verdict::notRun};

std::string countText(const std::vector<Claim>& claims) {
  std::string line;
  for (const Verdict verdict : kVerdicts) {
    const auto count = std::ranges::count(claims, verdict, &Claim::verdict);
    line += (line.empty() ? "" : ", ") + std::to_string(count) + " " + nameOf(verdict);
  }
  return line;
}

}  // namespace

std::string claimsToMarkdown(const std::vector<Claim>& claims) {
  std::string page = "# The paper's claims, as measured\n\n" + countText(claims) +
                     ".\n\n| claim | measured | verdict | seen if |\n|---|---|---|---|\n";
  for (const Claim& claim : claims) {
    page += "| " + claim.text + " | " + (claim.measured.empty() ? "-" : claim.measured) + " | **" +
            nameOf(claim.verdict) + "** | " + claim.seenIf + " |\n";
  }
  return page;
}

std::string claimsToJson(const std::vector<Claim>& claims) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Claim& claim : claims) {
    nlohmann::ordered_json values = nlohmann::ordered_json::object();
    for (const auto& [name, value] : claim.values) values[name] = value;
    list.push_back({{"id", claim.id},
                    {"claim", claim.text},
                    {"seen_if", claim.seenIf},
                    {"measured", claim.measured},
                    {"values", values},
                    {"verdict", nameOf(claim.verdict)}});
  }
  return nlohmann::ordered_json{{"claims", list}}.dump(2) + "\n";
}

std::string claimsToText(const std::vector<Claim>& claims) {
  std::string lines;
  for (const Claim& claim : claims) {
    if (claim.verdict == Verdict::notRun) continue;
    std::string verdict = nameOf(claim.verdict);
    verdict.resize(10, ' ');
    lines += "  " + verdict + claim.text + "\n            " + claim.measured + "\n";
  }
  return lines + "  " + countText(claims) + "\n";
}

}  // namespace haptiv

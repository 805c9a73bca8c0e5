#include "device/parsing/NestingGuard.h"

namespace haptiv {
namespace {

constexpr int kMostParts = 64;  // the format has three

}  // namespace

std::optional<unsigned> lineOfEndlessKey(std::string_view toml) {
  constexpr std::string_view kEndsKey = "=,[]{}\n";
  unsigned line = 1;
  int parts = 0;
  char last = 0;  // that is no blank
  for (const char c : toml) {
    if (c == ' ' || c == '\t') continue;
    if (kEndsKey.find(c) != std::string_view::npos) parts = 0;
    if (c == '.' && last != '.' && ++parts > kMostParts) return line;  // a row of dots is an ornament
    if (c == '\n') ++line;
    last = c;
  }
  return std::nullopt;
}

}  // namespace haptiv

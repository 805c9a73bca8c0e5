#include "device/parsing/KeyEdit.h"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "device/parsing/NestingGuard.h"

namespace haptiv {
namespace {

/// Byte at which a position of the parser's stands: it counts lines and code points from 1.
std::size_t byteAt(std::string_view text, const toml::source_position& where) {
  std::size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;  // a byte order mark is no code point to the parser
  for (toml::source_index line = 1; line < where.line; ++line) {
    at = text.find('\n', at);
    if (at == std::string_view::npos) return text.size();
    ++at;
  }
  const auto continues = [&](std::size_t byte) { return (static_cast<unsigned char>(text[byte]) & 0xc0) == 0x80; };
  for (toml::source_index column = 1; column < where.column && at < text.size(); ++column) {
    ++at;
    while (at < text.size() && continues(at)) ++at;
  }
  return at;
}

std::string_view lineEndOf(std::string_view text) {
  return text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
}

toml::table parsed(std::string_view text, const std::string& sourceName) {
  if (lineOfEndlessKey(text)) throw std::runtime_error(sourceName + ": a key of more than 64 parts; correct it");
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(sourceName + ":" + std::to_string(error.source().begin.line) + ": " +
                             std::string(error.description()) + "; correct the TOML there");
  }
}

std::string withKey(std::string text, const KeyValue& wanted, const std::string& sourceName) {
  const toml::table root = parsed(text, sourceName);
  const std::string end(lineEndOf(text)), entry = std::string(wanted.key) + " = " + wanted.value;
  if (const toml::node* node = root[wanted.section][wanted.key].node()) {
    const std::size_t begin = byteAt(text, node->source().begin), after = byteAt(text, node->source().end);
    return text.replace(begin, after - begin, wanted.value);
  }
  const toml::node* section = root.get(wanted.section);
  if (section == nullptr) {
    const std::string gap = text.empty() || text.ends_with('\n') ? end : end + end;
    return text + gap + "[" + std::string(wanted.section) + "]" + end + entry + end;
  }
  // Below the head: "[sensor]   # comment".
  const std::size_t head = byteAt(text, section->source().begin);
  const std::size_t line = text.find('\n', head);
  if (text[head] != '[') {
    throw std::runtime_error(sourceName + ":" + std::to_string(section->source().begin.line) + ": write [" +
                             std::string(wanted.section) + "] as a section of its own, so that " +
                             std::string(wanted.key) + " can be put there; or put it there by hand: " + entry);
  }
  if (line == std::string::npos) return text + end + entry + end;
  return text.insert(line + 1, entry + end);
}

}  // namespace

std::string withKeys(std::string_view toml, const std::vector<KeyValue>& values, const std::string& sourceName) {
  std::string text(toml);
  for (const KeyValue& value : values) {
    text = withKey(std::move(text), value, sourceName);
    const toml::table root = parsed(text, sourceName);
    if (root[value.section][value.key].node() == nullptr)
      throw std::runtime_error(sourceName + ": " + std::string(value.section) + "." + std::string(value.key) +
                               " cannot be put there; write it by hand: " + value.value);
  }
  return text;
}

}  // namespace haptiv

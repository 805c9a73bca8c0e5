#pragma once

#include <QColor>

namespace haptiv {

/// What the panel's bars are drawn in. Amber and red never stand alone: a word or a number says the same.
struct DexterityColours {
  static QColor track() { return {0xe4, 0xe7, 0xea}; }
  static QColor good() { return {0x4a, 0x74, 0x9e}; }
  static QColor near() { return {0xd9, 0x8a, 0x00}; }
  static QColor bad() { return {0xb0, 0x00, 0x20}; }
  static QColor mark() { return {0x22, 0x26, 0x2a}; }
  static QColor faint() { return {0x55, 0x5b, 0x61}; }
};

}  // namespace haptiv

#include "scenegraph/writing/GraphText.h"

#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoWriteAction.h>

#include <cstdlib>
#include <new>

namespace haptiv {

std::string graphText(SoNode* root, int digits, const char* header) {
  static constexpr std::size_t kFirst = 1 << 16;
  SoOutput output;
  void* first = std::malloc(kFirst);
  if (!first) throw std::bad_alloc();
  output.setBuffer(first, kFirst, &std::realloc);
  output.setHeaderString(header);
  output.setFloatPrecision(digits);
  SoWriteAction action(&output);
  action.apply(root);
  void* bytes = nullptr;
  std::size_t size = 0;
  output.getBuffer(bytes, size);
  std::string text(static_cast<const char*>(bytes), size);
  std::free(bytes);
  return text;
}

}  // namespace haptiv

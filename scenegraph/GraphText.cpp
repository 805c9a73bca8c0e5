#include "scenegraph/GraphText.h"

#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoWriteAction.h>
#include <Inventor/engines/SoEngine.h>
#include <Inventor/engines/SoEngineOutput.h>
#include <Inventor/nodes/SoBlinker.h>
#include <Inventor/nodes/SoPendulum.h>
#include <Inventor/nodes/SoShuttle.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <vector>

#include "scenegraph/GraphWalk.h"

namespace haptiv {
namespace {

/// Whether an engine gives the field its value that takes some of its own from the field's node.
bool comesBack(const SoField* field) {
  SoEngineOutput* output = nullptr;
  if (!field->getConnectedEngine(output) || !output->getContainer()) return false;
  return std::ranges::any_of(fieldsOf(output->getContainer()), [field](const SoField* input) {
    SoField* source = nullptr;
    return input->getConnectedField(source) && source->getContainer() == field->getContainer();
  });
}

/// Blinker, Pendulum and Shuttle are moved by engines of their own, which they have again when they are read. Coin
/// writes these too; what it has read of that it crashes on when it writes it again. Time stands still anyway.
void partFromOwnEngines(SoNode* root) {
  for (SoNode* node : writtenNodes(root)) {
    const bool hasEngines = node->isOfType(SoBlinker::getClassTypeId()) ||
                            node->isOfType(SoPendulum::getClassTypeId()) || node->isOfType(SoShuttle::getClassTypeId());
    if (!hasEngines) continue;
    for (SoField* field : fieldsOf(node)) {
      if (comesBack(field)) field->disconnect();
    }
  }
}

}  // namespace

std::string graphText(SoNode* root, int digits, const char* header) {
  partFromOwnEngines(root);
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

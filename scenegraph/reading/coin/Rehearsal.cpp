#include "scenegraph/reading/coin/Rehearsal.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "scenegraph/CoinMessages.h"
#include "scenegraph/GraphText.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/graph/GraphExpansion.h"
#include "scenegraph/reading/graph/NurbsRules.h"
#include "scenegraph/reading/graph/NurbsSwitch.h"
#include "scenegraph/reading/graph/ShapeIndices.h"

namespace haptiv {
namespace {

/// Tells each name that Coin reads, and its line.
class TellingInput final : public SoInput {
 public:
  explicit TellingInput(const std::string& bytes) : bytes_(bytes) { setBuffer(bytes.data(), bytes.size()); }

  using SoInput::read;
  SbBool read(SbName& name, SbBool isIdentifier) override {
    const SbBool isRead = SoInput::read(name, isIdentifier);
    for (const std::size_t to = std::min(getNumBytesRead(), bytes_.size()); at_ < to; ++at_) {
      if (bytes_[at_] == '\n') ++line_;
    }
    if (name.getLength() > 0) last_ = std::string(name.getString(), std::min(name.getLength(), 100));
    tellProgress("reads on after the word \"" + last_ + "\"", line_);
    return isRead;
  }

 private:
  const std::string& bytes_;
  std::string last_;
  std::size_t at_ = 0;
  int line_ = 1;
};

NodeRef<SoSeparator> read(const std::string& bytes) {
  TellingInput input(bytes);
  return NodeRef<SoSeparator>(SoDB::readAll(&input));
}

SoCallbackAction::Response tellShape(void*, SoCallbackAction* action, const SoNode* node) {
  tellProgress("goes through " + describe(node));
  if (isNurbs(node)) SoComplexityElement::set(action->getState(), 1);  // as they are felt
  return SoCallbackAction::CONTINUE;
}

void ignoreTriangle(void*, SoCallbackAction*, const SoPrimitiveVertex*, const SoPrimitiveVertex*,
                    const SoPrimitiveVertex*) {}

/// For turning a binary scene into text: several times what Coin needs for a good one. For a count of values that is
/// wrong, it makes room for them in a time that grows with its square.
std::chrono::seconds timeFor(const std::string& bytes) {
  return std::min(std::chrono::seconds(5 + 5 * (bytes.size() >> 20)), std::chrono::seconds(30));
}

/// All that the program will have Coin do, but for drawing.
void goThrough(SoNode* root) {
  SoCallbackAction triangles;
  triangles.addPreCallback(SoShape::getClassTypeId(), &tellShape, nullptr);
  triangles.addTriangleCallback(SoShape::getClassTypeId(), &ignoreTriangle, nullptr);
  triangles.apply(root);
  tellProgress("measures the scene");
  SoGetBoundingBoxAction box{SbViewportRegion(640, 480)};
  box.apply(root);
  SoGetPrimitiveCountAction count;
  count.apply(root);
  tellProgress("writes the scene");
  graphText(root);
}

}  // namespace

Isolated rehearse(const std::string& text) {
  return runIsolated([&] {
    tellProgress("reads the scene");
    const CoinMessages silence{std::string()};
    const auto root = read(text);
    if (!root) return std::string();
    switchOffEmptyNurbs(root.get());
    if (expansionFault(root.get()).why.empty() && !hasErrors(shapeIndexFaults(root.get()))) goThrough(root.get());
    return std::string();
  });
}

Isolated convertBinary(const std::string& bytes) {
  const auto convert = [&] {
    tellProgress("reads the scene, which is binary");
    const CoinMessages messages{std::string()};
    const auto root = read(bytes);
    if (!root) {
      const Diagnostics& said = messages.diagnostics();
      throw std::runtime_error(said.empty() ? "Coin cannot read it: is it cut off?" : said.front().message);
    }
    if (root->getNumChildren() == 0) throw std::runtime_error("it holds no node that can be read: is it cut off?");
    const std::string fault = expansionFault(root.get()).why;
    if (!fault.empty()) throw std::runtime_error(fault);
    tellProgress("turns the scene, which is binary, into text");
    static constexpr int kDigits = 9;  // every float comes back as it was
    return graphText(root.get(), kDigits);
  };
  Isolated converted = runIsolated(convert, timeFor(bytes));
  converted.line = 0;  // there are none
  return converted;
}

}  // namespace haptiv

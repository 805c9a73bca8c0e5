#include "scenegraph/writing/LastingText.h"

#include <Inventor/nodes/SoSeparator.h>

#include <functional>
#include <stdexcept>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/isolation/Isolated.h"
#include "scenegraph/reading/SceneFile.h"
#include "scenegraph/writing/SceneWriter.h"
#include "scenegraph/writing/WriteOutIncluded.h"
#include "scenegraph/writing/WriteOutPrototypes.h"

namespace haptiv {
namespace {

/// The text of the graph after a change, which is made in a process of its own, where Coin may crash on what a stranger
/// wrote, and compared with what it was.
std::string textAfter(const std::function<void()>& change, SoSeparator* root, const std::string& name,
                      const std::string& what) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(name + ": cannot be saved: " + what + " cannot be written out: " + why +
                             "; the file is as it was");
  };
  Isolated made = runIsolated([&] {
    change();
    return writeSceneText(root);
  });
  if (!made.fault.empty()) refuse(made.fault);
  const SceneFile again = readSceneText(made.result, name);
  if (!again.root || drawnTriangles(again.root.get()) != drawnTriangles(root)) refuse("the scene would be another one");
  return std::move(made.result);
}

}  // namespace

std::string lastingText(SoSeparator* root, const std::string& name) {
  if (!findPrototype(root)) return writeSceneText(root);
  return textAfter([root] { writeOutPrototypes(root); }, root, name, "its prototypes (PROTO)");
}

std::string wholeText(SoSeparator* root, const std::string& name) {
  if (!includesFiles(root)) return lastingText(root, name);
  const auto change = [root] {
    writeOutIncluded(root);
    writeOutPrototypes(root);
  };
  return textAfter(change, root, name, "what it includes");
}

}  // namespace haptiv

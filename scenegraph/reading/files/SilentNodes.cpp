#include "scenegraph/reading/files/SilentNodes.h"

#include <Inventor/VRMLnodes/SoVRMLAudioClip.h>
#include <Inventor/VRMLnodes/SoVRMLImageTexture.h>
#include <Inventor/VRMLnodes/SoVRMLInline.h>
#include <Inventor/nodes/SoBumpMap.h>
#include <Inventor/nodes/SoFile.h>
#include <Inventor/nodes/SoImage.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTexture3.h>
#include <Inventor/nodes/SoTextureCubeMap.h>
#include <stdlib.h>

#include "scenegraph/ReplaceNode.h"
#include "scenegraph/reading/files/NamedFields.h"

namespace haptiv {
namespace {

/// Reads its fields and nothing else. Coin's sensors, which load a file as soon as its name changes, learn of no
/// change.
template <typename Node>
class Silent : public Node {
 public:
  Silent() {
    for (SoField* field : namedFields(this).fields) field->enableNotify(FALSE);
  }

 protected:
  SbBool readInstance(SoInput* in, unsigned short flags) override { return SoNode::readInstance(in, flags); }
};

/// A picture on the screen, not in the scene. Coin makes triangles of it by a call of GLU's that needs a display, and
/// crashes where there is none.
class SilentImage final : public Silent<SoImage> {
 protected:
  void generatePrimitives(SoAction*) override {}
};

class SilentFile final : public SoFile {
 protected:
  SbBool readNamedFile(SoInput*) override { return TRUE; }
};

template <typename Node>
void silence() {
  replaceNode<Node, Silent<Node>>();
}

}  // namespace

void forbidNodeLibraries() {
  ::setenv("COIN_NO_SOTYPE_DYNLOAD", "1", 1);
}

void silenceFileNodes() {
  replaceNode<SoFile, SilentFile>();
  silence<SoTexture2>();
  silence<SoTexture3>();
  silence<SoTextureCubeMap>();
  silence<SoBumpMap>();
  replaceNode<SoImage, SilentImage>();
  silence<SoVRMLImageTexture>();
  silence<SoVRMLAudioClip>();
  SoVRMLInline::setReadAsSoFile(FALSE);  // WWWInline opens nothing without a callback
}

}  // namespace haptiv

#pragma once

#include <filesystem>
#include <functional>

#include "scenegraph/Diagnostic.h"
#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/files/PictureLoader.h"

class SoSeparator;

namespace haptiv {

/// Where names lead from, and what is said about them.
struct NamingFile {
  std::filesystem::path folder;  ///< of the file that names others
  std::filesystem::path home;    ///< of the scene that the user named: nothing outside is opened
};

/// Reads another scene; null where it cannot be had, which it has said then.
using ReadScene = std::function<NodeRef<SoSeparator>(const std::filesystem::path&, const SoNode* namedBy)>;

/// Opens what the nodes of a graph name, as far as it lies in the scene's folder: scenes are put where File, Inline and
/// WWWInline stand, and textures are loaded. A file that is not there is a warning, since Coin shows the scene without
/// it; one that may not be opened is a warning for a texture and an error for a scene. The diagnostics have a source,
/// and neither file nor line.
Diagnostics loadNamedFiles(SoNode* root, const NamingFile& from, const ReadScene& readScene, PictureLoader& pictures);

}  // namespace haptiv

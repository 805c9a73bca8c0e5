#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenegraph/reading/SceneFile.h"
#include "scenegraph/reading/files/PictureLoader.h"

namespace haptiv {

/// Reads one scene and all that it includes. Each file goes through the same steps: unpack, turn binary into text, scan
/// the text, rehearse in a process of its own what is not everyday, read, open what it names. Then the whole graph is
/// judged. Thread: GUI.
class SceneReader {
 public:
  /// @param home  the folder of the scene that the user named: nothing outside of it is opened
  SceneReader(std::filesystem::path home, DecodePicture decode)
      : home_(std::move(home)), pictures_(std::move(decode)) {}

  /// @param name  of the file, for diagnostics; names in it are relative to its folder
  SceneFile read(std::string bytes, const std::string& name);

  /// For EXTERNPROTO: its file's contents as scanned text; empty where it may not be read, which is said.
  std::string prototypeText(const std::string& url);

  /// What a whole graph is refused for, or warned of.
  static void judge(SceneFile& scene);

 private:
  void readGraph(SceneFile& scene);
  void parse(SceneFile& scene);
  NodeRef<SoSeparator> include(SceneFile& scene, const std::filesystem::path& path, const SoNode* namedBy);
  void open(SceneFile& scene);

  std::filesystem::path home_;
  PictureLoader pictures_;
  std::vector<SceneFile*> reading_;  ///< the innermost last
  std::vector<std::filesystem::path> paths_;
  std::map<std::filesystem::path, NodeRef<SoSeparator>> included_;
  std::uintmax_t bytes_ = 0;  ///< of all files
};

}  // namespace haptiv

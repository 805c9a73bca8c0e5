#pragma once

namespace haptiv {

class SceneReader;

/// While it lives, EXTERNPROTO takes its files from a reader, which opens only what the scene may have opened.
class ExternalPrototypes {
 public:
  explicit ExternalPrototypes(SceneReader& reader);
  ~ExternalPrototypes();
  ExternalPrototypes(const ExternalPrototypes&) = delete;
  ExternalPrototypes& operator=(const ExternalPrototypes&) = delete;

 private:
  SceneReader* before_;
};

}  // namespace haptiv

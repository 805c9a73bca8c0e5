#pragma once

#include <string>

class SoSeparator;

namespace haptiv {

/// The graph as text that can be read and written any number of times: what prototypes make is written out. Throws
/// std::runtime_error where that cannot be done, and as writeSceneText does. @param name  stands for the path
std::string lastingText(SoSeparator* root, const std::string& name);

/// The same for a log, which is read where the scene's folder is not: what it includes is written out too. Textures
/// stay names.
std::string wholeText(SoSeparator* root, const std::string& name);

}  // namespace haptiv

#pragma once

namespace haptiv {

/// From here on Coin's nodes open no file by themselves, neither while they are read nor when a field of theirs is set,
/// connected or copied; and no unknown node is looked for among the system's shared libraries, which would run code
/// that a scene names. What a scene may open is opened by loadNamedFiles. Call once, after SoDB::init.
void silenceFileNodes();

/// To be called before SoDB::init, which reads it once.
void forbidNodeLibraries();

}  // namespace haptiv

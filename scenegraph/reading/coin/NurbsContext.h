#pragma once

namespace haptiv {

/// Lets Coin make triangles of NURBS where there is no display. It asks for an off-screen context of OpenGL first, and
/// crashes where it gets none; but GLU, which makes the triangles, only computes, and needs none.
/// GLU is loaded at once, for the processes in which scenes are tried open no file, not even a library.
/// From now on, Coin takes it that it has one. Nothing in the program has Coin draw off-screen.
void cutNurbsWithoutDisplay();

}  // namespace haptiv

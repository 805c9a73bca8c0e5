#include "app/commands/WindowCommand.h"

#include <QString>

#include "app/commands/Display.h"
#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/window/Application.h"

namespace haptiv {
namespace {

std::string whatToDoInstead(const std::string& sceneOrLog) {
  const std::string noDisplay = "there is no display for the window (is DISPLAY set?); without one, ";
  if (sceneOrLog.ends_with(".h5"))
    return noDisplay + "try\n  haptiv info " + sceneOrLog + "\n  haptiv replay " + sceneOrLog +
           " --verify\n  haptiv replay " + sceneOrLog + " --export ticks.csv";
  const std::string scene = sceneOrLog.empty() ? "SCENE.iv" : sceneOrLog;
  return noDisplay + "try\n  haptiv run " + scene + " --fast --picture out.png\n  haptiv check " + scene;
}

}  // namespace

int openWindow(int argc, char** argv, const std::string& sceneOrLog) {
  if (!sceneOrLog.empty()) requireReadable(sceneOrLog);
  if (!hasDisplay()) throw CommandFailure(kCouldNot, whatToDoInstead(sceneOrLog));
  return runApplication(argc, argv, QString::fromStdString(sceneOrLog));
}

}  // namespace haptiv

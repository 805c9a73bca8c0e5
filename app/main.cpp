#include "app/CommandLine.h"

int main(int argc, char** argv) {
  return haptiv::runCommandLine(argc, argv);
}

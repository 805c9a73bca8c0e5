#include "app/commands/CommandLine.h"

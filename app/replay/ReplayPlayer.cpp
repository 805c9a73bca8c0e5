#include "app/replay/ReplayPlayer.h"

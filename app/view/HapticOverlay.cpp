#include "app/view/HapticOverlay.h"

#include "app/session/HandFile.h"

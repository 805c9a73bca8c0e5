#include "app/plots/SignalPlot.h"

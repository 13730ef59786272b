/* How many bodies are computed side by side. */
#ifndef LANES
#define LANES 16
#endif

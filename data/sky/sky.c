/* The files of this folder. */
#include "../embed.h"

EMBED(blackhole_stars, "data/sky/stars.bin");
EMBED(blackhole_milky_way, "data/sky/milkyway.bin");

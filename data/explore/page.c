/* The page of blackhole explore. */
#include "../embed.h"

EMBED(blackhole_page_html, "data/explore/page.html");
EMBED(blackhole_page_css, "data/explore/page.css");
EMBED(blackhole_page_js, "data/explore/page.js");

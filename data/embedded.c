/* Files that the assembler makes constants of the program, each between a symbol and the
   symbol with _end: an installed program is one file. Cabal, cabal and Stack run the
   assembler in the package's root folder. */
#ifdef __APPLE__
#define SECTION ".const_data"
#define NAME(symbol) "_" #symbol
#else
#define SECTION ".section .rodata"
#define NAME(symbol) #symbol
#endif

#define EMBED(symbol, file)                                                    \
  __asm__(SECTION "\n.globl " NAME(symbol) "\n.globl " NAME(symbol##_end)      \
          "\n.balign 16\n" NAME(symbol) ":\n.incbin \"" file "\"\n"            \
          NAME(symbol##_end) ":\n.byte 0\n.text\n")

EMBED(blackhole_stars, "data/sky/stars.bin");
EMBED(blackhole_milky_way, "data/sky/milkyway.bin");
EMBED(blackhole_page_html, "data/explore/page.html");
EMBED(blackhole_page_css, "data/explore/page.css");
EMBED(blackhole_page_js, "data/explore/page.js");

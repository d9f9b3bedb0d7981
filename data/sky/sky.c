/* The files of this folder as constants of the program, so that an installed
   program is one file. The assembler reads them; Cabal, cabal and Stack run it in
   the package's root folder. */
#ifdef __APPLE__
#define SECTION ".const_data"
#define NAME(symbol) "_" #symbol
#else
#define SECTION ".section .rodata"
#define NAME(symbol) #symbol
#endif

#define EMBED(symbol, file)                                                    \
  __asm__(SECTION "\n.globl " NAME(symbol) "\n.balign 16\n" NAME(symbol)       \
          ":\n.incbin \"" file "\"\n.text\n")

EMBED(blackhole_stars, "data/sky/stars.bin");
EMBED(blackhole_milky_way, "data/sky/milkyway.bin");

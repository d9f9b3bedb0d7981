/* EMBED(symbol, "file") makes a file a constant of the program between the symbols
   symbol and symbol_end, so that an installed program is one file. The assembler reads
   the file; Cabal, cabal and Stack run it in the package's root folder. */
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

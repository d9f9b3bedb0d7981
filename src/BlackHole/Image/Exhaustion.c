/* What the program does when its memory runs out: see Exhaustion.hs.

   GHC's run-time system says so through the hooks of rts/Messages.h, and would then end
   the process with exit code 251 or abort(), before any Haskell code could run. */
#include <pthread.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "Rts.h"

/* More than the number of files that the program writes at any one time. */
#define FILES 1024
static char *files[FILES];
static pthread_mutex_t files_mutex = PTHREAD_MUTEX_INITIALIZER;

/* A file is left behind if there is no room for a copy of its name. */
void blackhole_remove_if_exhausted(const char *path) {
  char *copy = strdup(path);
  pthread_mutex_lock(&files_mutex);
  for (int i = 0; copy && i < FILES; i++)
    if (!files[i]) {
      files[i] = copy;
      copy = NULL;
    }
  pthread_mutex_unlock(&files_mutex);
  free(copy);
}

void blackhole_keep_if_exhausted(const char *path) {
  pthread_mutex_lock(&files_mutex);
  for (int i = 0; i < FILES; i++)
    if (files[i] && strcmp(files[i], path) == 0) {
      free(files[i]);
      files[i] = NULL;
      break;
    }
  pthread_mutex_unlock(&files_mutex);
}

static void remove_files(void) {
  pthread_mutex_lock(&files_mutex);
  for (int i = 0; i < FILES; i++)
    if (files[i])
      unlink(files[i]);
  pthread_mutex_unlock(&files_mutex);
}

static int exhausted_code;

/* Allocates nothing. The limit -M of the run-time system says "Heap exhausted". */
static void end_if_exhausted(const char *format) {
  static const char line[] = "blackhole: out of memory: make the picture smaller, or render it in tiles (--tile I/N)\n";
  if (!strstr(format, "out of memory") && !strstr(format, "eap exhausted") && !strstr(format, "bytes of memory"))
    return;
  remove_files();
  ssize_t written = write(2, line, sizeof line - 1);
  (void)written;
  _exit(exhausted_code);
}

static void on_error(const char *format, va_list arguments) {
  end_if_exhausted(format);
  rtsErrorMsgFn(format, arguments);
}

static void on_fatal_error(const char *format, va_list arguments) {
  end_if_exhausted(format);
  remove_files();
  rtsFatalInternalErrorFn(format, arguments);
}

void blackhole_handle_exhaustion(int code) {
  exhausted_code = code;
  errorMsgFn = on_error;
  fatalInternalErrorFn = on_fatal_error;
}

// SPDX-License-Identifier: Apache-2.0
// A library for LD_PRELOAD that lets one call of a program fail, or kills the program there (tests/soak/injections.py).
//   INJECT   "WHAT MODE N FILE"
//     WHAT   calls: the calls below that open, read, write, flush, name or remove files; memory: allocations
//     MODE   once: the N-th fails; on: so do all later ones of its kind; kill: the process is killed there, and where the
//            call writes, half of the bytes are written before
//     FILE   of at least sizeof(struct seen) bytes, for what was seen
// Files that the C library opens for itself are not counted, and neither is what is written to standard error.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

struct seen {
  unsigned calls, allocations, failed;  // `failed`: how many of them this library let fail
  char kinds[16384];                    // the kind of each call, in order
};

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t),
    *__libc_memalign(size_t, size_t);

static struct seen nowhere, *seen = &nowhere;
static enum { none, calls, memory } what;
static enum { once, on, kill_there } mode;
static unsigned at;
static char kind_at;
static long (*system_call)(long, ...);

__attribute__((constructor(101))) static void begin(void) {
  *(void **)&system_call = dlsym(RTLD_NEXT, "syscall");
  const char *order = getenv("INJECT");
  char what_word[16], mode_word[16], path[512];
  if (!order || sscanf(order, "%15s %15s %u %511s", what_word, mode_word, &at, path) != 4) return;
  const int file = (int)system_call(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC, 0);
  void *mapped = mmap(NULL, sizeof *seen, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  system_call(SYS_close, file);
  if (mapped == MAP_FAILED) _exit(99);
  seen = mapped;
  mode = mode_word[0] == 'k' ? kill_there : mode_word[1] == 'n' && !mode_word[2] ? on : once;
  what = what_word[0] == 'm' ? memory : calls;
}

static void die(void) {
  system_call(SYS_kill, getpid(), SIGKILL);
}

static int memory_fails(void) {
  const unsigned n = __atomic_add_fetch(&seen->allocations, 1, __ATOMIC_RELAXED);
  if (what != memory || n < at || (n > at && mode != on)) return 0;
  if (mode == kill_there) die();
  __atomic_add_fetch(&seen->failed, 1, __ATOMIC_RELAXED);
  errno = ENOMEM;
  return 1;
}

// Whether a call of this kind is the one; errno then says why it fails.
static int is_hit(char kind) {
  const unsigned n = __atomic_add_fetch(&seen->calls, 1, __ATOMIC_RELAXED);
  if (n <= sizeof seen->kinds) seen->kinds[n - 1] = kind;
  if (what != calls) return 0;
  if (n == at) kind_at = kind;
  if (n != at && (mode != on || kind != kind_at)) return 0;
  __atomic_add_fetch(&seen->failed, 1, __ATOMIC_RELAXED);
  errno = kind == 'w' || kind == 'm' || kind == 't' ? ENOSPC : kind == 'o' ? EMFILE : EIO;
  return 1;
}

static int fails(char kind) {
  if (!is_hit(kind)) return 0;
  if (mode == kill_there) die();
  return 1;
}

void *malloc(size_t size) { return memory_fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return memory_fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return memory_fails() ? NULL : __libc_realloc(old, size); }
void *memalign(size_t unit, size_t size) { return memory_fails() ? NULL : __libc_memalign(unit, size); }
void *aligned_alloc(size_t unit, size_t size) { return memalign(unit, size); }
int posix_memalign(void **to, size_t unit, size_t size) {
  void *const got = memalign(unit, size);
  if (got) *to = got;
  return got ? 0 : ENOMEM;
}
void *mmap(void *to, size_t size, int protect, int flags, int file, off_t from) {
  if ((flags & MAP_ANONYMOUS) != 0 && memory_fails()) return MAP_FAILED;
  return (void *)system_call(SYS_mmap, to, size, protect, flags, file, from);
}

ssize_t write(int file, const void *from, size_t size) {
  if (file == STDERR_FILENO || !is_hit('w')) return system_call(SYS_write, file, from, size);
  if (mode != kill_there) return -1;
  system_call(SYS_write, file, from, size / 2);
  die();
  return -1;
}
ssize_t pwrite(int file, const void *from, size_t size, off_t to) {
  if (!is_hit('w')) return system_call(SYS_pwrite64, file, from, size, to);
  if (mode != kill_there) return -1;
  system_call(SYS_pwrite64, file, from, size / 2, to);
  die();
  return -1;
}
ssize_t writev(int file, const struct iovec *parts, int count) {
  return file != STDERR_FILENO && fails('w') ? -1 : system_call(SYS_writev, file, parts, count);
}
ssize_t read(int file, void *to, size_t size) { return fails('i') ? -1 : system_call(SYS_read, file, to, size); }
ssize_t pread(int file, void *to, size_t size, off_t from) {
  return fails('i') ? -1 : system_call(SYS_pread64, file, to, size, from);
}
int fsync(int file) { return fails('s') ? -1 : (int)system_call(SYS_fsync, file); }
int fdatasync(int file) { return fails('s') ? -1 : (int)system_call(SYS_fdatasync, file); }
int ftruncate(int file, off_t size) { return fails('t') ? -1 : (int)system_call(SYS_ftruncate, file, size); }
int fchmod(int file, mode_t to) { return fails('c') ? -1 : (int)system_call(SYS_fchmod, file, to); }
// What a close that fails had to close is closed, as Linux has it.
int close(int file) {
  const long flags = system_call(SYS_fcntl, file, F_GETFL);
  const int written = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY, failed = written && fails('e');
  const int done = (int)system_call(SYS_close, file);
  if (failed) errno = EIO;
  return failed ? -1 : done;
}

static int open_at(int folder, const char *path, int flags, va_list more) {
  const unsigned made = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(more, unsigned) : 0;
  return fails('o') ? -1 : (int)system_call(SYS_openat, folder, path, flags, made);
}
#define OPEN(name)                              \
  int name(const char *path, int flags, ...) {  \
    va_list more;                               \
    va_start(more, flags);                      \
    const int file = open_at(AT_FDCWD, path, flags, more); \
    va_end(more);                               \
    return file;                                \
  }
#define OPENAT(name)                                       \
  int name(int folder, const char *path, int flags, ...) { \
    va_list more;                                          \
    va_start(more, flags);                                 \
    const int file = open_at(folder, path, flags, more);   \
    va_end(more);                                          \
    return file;                                           \
  }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

int mkdirat(int folder, const char *name, mode_t made) {
  return fails('m') ? -1 : (int)system_call(SYS_mkdirat, folder, name, made);
}
int mkdir(const char *path, mode_t made) { return mkdirat(AT_FDCWD, path, made); }
int linkat(int from, const char *name, int to, const char *other, int flags) {
  return fails('l') ? -1 : (int)system_call(SYS_linkat, from, name, to, other, flags);
}
int unlinkat(int folder, const char *name, int flags) {
  return fails('u') ? -1 : (int)system_call(SYS_unlinkat, folder, name, flags);
}
int unlink(const char *path) { return unlinkat(AT_FDCWD, path, 0); }
int rmdir(const char *path) { return unlinkat(AT_FDCWD, path, AT_REMOVEDIR); }
int renameat(int from, const char *name, int to, const char *other) {
  return fails('r') ? -1 : (int)system_call(SYS_renameat2, from, name, to, other, 0);
}
int rename(const char *name, const char *other) { return renameat(AT_FDCWD, name, AT_FDCWD, other); }
long syscall(long number, ...) {
  va_list more;
  va_start(more, number);
  long given[6];
  for (int i = 0; i < 6; ++i) given[i] = va_arg(more, long);
  va_end(more);
  if (number == SYS_renameat2 && fails('r')) return -1;
  return system_call(number, given[0], given[1], given[2], given[3], given[4], given[5]);
}

#include "tests/realtime/HiddenCalls.h"

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

#include <cerrno>

// The program's own definitions come before the C library's: every call goes through these doors. A sanitizer has doors
// of its own, so this is not for its builds.
namespace {

thread_local haptiv::testing::HiddenCalls calls;

/// Counts a lock and hands it on to the C library. Name: the function's own.
template <typename... Arguments>
int lockedBy(const char* name, void*& next, Arguments... arguments) {
  ++calls.locks;
  if (next == nullptr) next = dlsym(RTLD_NEXT, name);
  return reinterpret_cast<int (*)(Arguments...)>(next)(arguments...);
}

}  // namespace

haptiv::testing::HiddenCalls haptiv::testing::hiddenCalls() noexcept {
  return calls;
}

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
  ++calls.heap;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++calls.heap;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  ++calls.heap;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++calls.heap;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  ++calls.heap;
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
void free(void* block) {
  ++calls.heap;
  __libc_free(block);
}

#define HAPTIV_COUNTED_LOCK(name, parameters, ...) \
  int name parameters {                            \
    static void* next = nullptr;                   \
    return lockedBy(#name, next, __VA_ARGS__);     \
  }
HAPTIV_COUNTED_LOCK(pthread_mutex_lock, (pthread_mutex_t * mutex) noexcept, mutex)
HAPTIV_COUNTED_LOCK(pthread_mutex_trylock, (pthread_mutex_t * mutex) noexcept, mutex)
HAPTIV_COUNTED_LOCK(pthread_rwlock_rdlock, (pthread_rwlock_t * lock) noexcept, lock)
HAPTIV_COUNTED_LOCK(pthread_rwlock_wrlock, (pthread_rwlock_t * lock) noexcept, lock)
HAPTIV_COUNTED_LOCK(pthread_spin_lock, (pthread_spinlock_t * lock) noexcept, lock)
HAPTIV_COUNTED_LOCK(pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t* mutex), condition, mutex)
HAPTIV_COUNTED_LOCK(pthread_cond_signal, (pthread_cond_t * condition) noexcept, condition)
HAPTIV_COUNTED_LOCK(pthread_cond_broadcast, (pthread_cond_t * condition) noexcept, condition)
HAPTIV_COUNTED_LOCK(sem_wait, (sem_t * semaphore), semaphore)
HAPTIV_COUNTED_LOCK(sem_post, (sem_t * semaphore) noexcept, semaphore)
#undef HAPTIV_COUNTED_LOCK
}

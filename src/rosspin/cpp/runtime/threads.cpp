// Threads, as the C++ library knows them: pthreads that take turns. One runs when the one before it waits; of those that
// could, the one whose time was first, and of these the one that has waited longest.
#include "rosspin/host.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <pthread.h>
#include <sched.h>
#include <string>
#include <utility>
#include <vector>

#define FROM_HOST(name) __attribute__((import_module("rosspin"), import_name(name))) extern

namespace
{
constexpr std::size_t stack_size = 1 << 20;
constexpr int most_keys = 32;
constexpr std::int64_t second = 1'000'000'000;

struct Thread
{
  char* stack_end = nullptr;  // at its beginning: see rosspin_body
  char* locals = nullptr;  // its variables that are `thread_local`
  char* stack = nullptr;
  Thread* next = nullptr;  // of all
  const void* what = nullptr;  // it waits for
  const rosspin::Due* due = nullptr;  // what knows when its time is; a change of stacks costs more than to ask it
  const pthread_mutex_t* asked = nullptr;  // which it waits for
  int number = 0;
  std::int64_t until = 0;  // when its time is, in the run's
  std::uint64_t place = 0;  // in the order in which they began to wait
  bool notified = false, ended = false, detached = false;
  void* (*start)(void*) = nullptr;
  void* value = nullptr;  // what it begins with, and then, what it ends with
  void* kept[most_keys] = {};
  struct Local* gone = nullptr;  // what is destroyed at its end
  ~Thread()
  {
    std::free(stack);
    std::free(locals);
  }
};

// What pthread_exit throws.
struct Exit
{
  void* value;
};

// A variable that is `thread_local`, and the one that was made before it.
struct Local
{
  void (*destroy)(void*);
  void* value;
  Local* before;
};

Thread first;
Thread* all = &first;
Thread* running = &first;
Thread* gone = nullptr;  // its stack is not left yet
std::uint64_t places = 0;
int keys = 0, made_threads = 0;
void (*destroys[most_keys])(void*);

// The next one to run: time may have to pass first.
Thread* next_thread()
{
  for (;;)
  {
    Thread* found = all;
    for (Thread* each = all; each; each = each->next)
      if (each->until < found->until || (each->until == found->until && each->place < found->place))
        found = each;
    if (found->until > rosspin::detail::time())
      rosspin::detail::go_on(found->until);
    else if (!found->due || (found->until = (*found->due)()) <= rosspin::detail::time())
      return found;
  }
}

// When it is so late (ns) by the system's clock, or so much later than `since`.
std::int64_t after(const timespec* time, std::int64_t since)
{
  std::int64_t most = (rosspin::never - since) / second - 1;
  return time->tv_sec > most ? rosspin::never : since + time->tv_sec * second + time->tv_nsec;
}
}  // namespace

extern "C"
{
FROM_HOST("thread") bool rosspin_thread(void (*body)(Thread*), Thread* thread);
FROM_HOST("turn") void rosspin_turn(Thread* from, Thread* to);
FROM_HOST("leave") void rosspin_leave(Thread* to);

extern char __global_base;  // where the first values of variables lie that are `thread_local`

extern struct
{
  void* caught;
  unsigned uncaught;
} rosspin_handling;

void rosspin_body(Thread* thread);
}

// What is `thread_local` lies at a place from where this says. This file is linked at the end, and so is its own there.
thread_local char end_of_locals = 0;

// How a thread begins: on the stack that is its own, with variables of its own.
__asm__(R"(
  .globl __tls_base
  .globaltype __tls_base, i32
__tls_base:
  .functype rosspin_run (i32) -> ()
  .globaltype __stack_pointer, i32
  .section .text.rosspin_body,"",@
  .type rosspin_body,@function
rosspin_body:
  .functype rosspin_body (i32) -> ()
  local.get 0
  i32.load 0
  global.set __stack_pointer
  local.get 0
  i32.load 4
  global.set __tls_base
  local.get 0
  call rosspin_run
  end_function
)");

namespace
{
void use(char* locals) { __asm__ volatile("local.get %0\n\tglobal.set __tls_base" : : "r"(locals)); }

// Return variables as they are at first.
char* new_locals()
{
  std::uintptr_t base;
  __asm__ volatile("global.get __tls_base\n\tlocal.set %0" : "=r"(base));
  std::size_t size = reinterpret_cast<std::uintptr_t>(&end_of_locals) - base;
  auto locals = static_cast<char*>(std::aligned_alloc(16, (size + 16) & -16));
  return locals ? static_cast<char*>(std::memcpy(locals, &__global_base, size)) : nullptr;
}

// Before anything else.
__attribute__((constructor(0))) void begin() { use(first.locals = new_locals()); }

void destroy_locals(void*)
{
  while (Local* last = running->gone)
  {
    running->gone = last->before;
    last->destroy(last->value);
    delete last;
  }
}
}  // namespace

namespace rosspin
{
namespace detail
{
void (*begin_thread)(void* (*)(void*), void*) = nullptr;
void (*look_for_ring)() = nullptr;  // null until a thread was made; known elsewhere, or it would be part of each program
bool is_alone() { return !all->next; }
}  // namespace detail

bool wait_for(const void* what, std::int64_t until, const Due* due)
{
  running->what = what;
  running->due = due;
  running->until = until;
  running->place = ++places;
  running->notified = false;
  if (Thread* to = next_thread(); to != running)
  {
    Thread* from = std::exchange(running, to);
    auto handling = std::exchange(rosspin_handling, {});
    std::uintptr_t stack;
    __asm__ volatile("global.get __stack_pointer\n\tlocal.set %0" : "=r"(stack));
    rosspin_turn(from, to);
    __asm__ volatile("local.get %0\n\tglobal.set __stack_pointer" : : "r"(stack));
    use(from->locals);
    rosspin_handling = handling;
  }
  running->what = nullptr;
  running->due = nullptr;
  return running->notified;
}

void notify(const void* what, bool every)
{
  for (const std::uint64_t last = places;;)
  {
    Thread* found = nullptr;
    for (Thread* each = all; each; each = each->next)
      if (each->what == what && each->place <= last && (!found || each->place < found->place))
        found = each;
    if (!found)
      return;
    if (!found->due)  // otherwise it may have to wait on
      found->what = nullptr;
    found->until = detail::time();
    found->place = ++places;
    found->notified = true;
    if (!every)
      return;
  }
}
}  // namespace rosspin

namespace
{
std::string name_of(const Thread* thread) { return thread == &first ? "main" : "thread " + std::to_string(thread->number); }

// Who holds the lock that a thread waits for; null if no thread that is still there.
const Thread* holder_of(const Thread* thread)
{
  const Thread* found = all;
  while (found && (!thread->asked || found != thread->asked->__u.__p[1]))
    found = found->next;
  return found;
}

// Say who waits for whom, if this thread waits for a lock whose holder waits, in the end, for this thread.
void tell_ring()
{
  std::vector<rosspin::Value> links;
  std::string said = "rosspin: deadlock. This can never continue:\n";
  const Thread* each = running;
  do
  {
    const Thread* holder = holder_of(each);
    if (!holder || links.size() == 100)  // a page draws no more
      return;
    std::string waits = "waits for a lock that " + (holder == each ? "it" : name_of(holder)) + " holds";
    said += "rosspin:   " + name_of(each) + " " + waits + "\n";
    links.push_back(std::vector<rosspin::Value>{name_of(each), waits});
    each = holder;
  } while (each != running);
  said += links.size() == 1
    ? "rosspin: A std::mutex cannot be locked twice by one thread: unlock it first, or use a std::recursive_mutex.\n"
    : "rosspin: Lock them in the same order everywhere.\n";
  std::fputs(said.c_str(), stderr);
  rosspin::tell("ring", {links});
}
}  // namespace

extern "C"
{
// What leaves a thread's function ends the program.
void rosspin_run(Thread* thread)
{
  try
  {
    thread->value = thread->start(thread->value);
  }
  catch (const Exit& exit)
  {
    thread->value = exit.value;
  }
  catch (...)
  {
    std::terminate();
  }
  destroy_locals(nullptr);
  for (int key = 0; key < keys; key++)
    if (void* kept = std::exchange(thread->kept[key], nullptr); kept && destroys[key])
      destroys[key](kept);
  Thread** at = &all;
  while (*at != thread)
    at = &(*at)->next;
  *at = thread->next;
  thread->ended = true;
  rosspin::notify(thread, true);
  rosspin::notify(&all, true);
  delete std::exchange(gone, thread->detached ? thread : nullptr);
  running = next_thread();
  rosspin_handling = {};
  rosspin_leave(running);
}

int pthread_create(pthread_t* made, const pthread_attr_t* attributes, void* (*start)(void*), void* value)
{
  rosspin::detail::begin_thread = [](void* (*start)(void*), void* value)
  {
    pthread_t made;
    if (pthread_create(&made, nullptr, start, value) == 0)
      pthread_detach(made);
  };
  rosspin::detail::look_for_ring = tell_ring;
  auto thread = new Thread;
  thread->stack = static_cast<char*>(std::malloc(stack_size));
  thread->locals = new_locals();
  if (!thread->stack || !thread->locals)
  {
    delete thread;
    return EAGAIN;
  }
  thread->stack_end = thread->stack + stack_size;
  thread->start = start;
  thread->value = value;
  thread->number = ++made_threads;
  thread->until = rosspin::detail::time();
  thread->place = ++places;
  int state = PTHREAD_CREATE_JOINABLE;
  if (attributes)
    pthread_attr_getdetachstate(attributes, &state);
  thread->detached = state == PTHREAD_CREATE_DETACHED;
  thread->next = std::exchange(all, thread);
  if (!rosspin_thread(rosspin_body, thread))
    rosspin::not_simulated("a thread where WebAssembly has no JSPI (as before Chrome 137, Firefox 153 and Safari 27)");
  *made = reinterpret_cast<pthread_t>(thread);
  return 0;
}

int pthread_join(pthread_t joined, void** value)
{
  auto thread = reinterpret_cast<Thread*>(joined);
  while (!thread->ended)
    rosspin::wait_for(thread, rosspin::never);
  if (value)
    *value = thread->value;
  delete thread;
  return 0;
}

int pthread_detach(pthread_t detached)
{
  auto thread = reinterpret_cast<Thread*>(detached);
  thread->detached = true;
  if (thread->ended)
    delete thread;
  return 0;
}

void pthread_exit(void* value) { throw Exit{value}; }

// An exception has left main. If that should have left nothing but its thread, wait for the other threads.
void rosspin_left_main()
{
  try
  {
    throw;
  }
  catch (const Exit&)
  {
    first.gone = nullptr;
    while (all->next)
      rosspin::wait_for(&all, rosspin::never);
    std::exit(0);
  }
  catch (...)
  {
  }
}

int __cxa_atexit(void (*)(void*), void*, void*);

int __cxa_thread_atexit(void (*destroy)(void*), void* value, void*)
{
  if (static bool known = false; running == &first && !std::exchange(known, true))
    __cxa_atexit(destroy_locals, nullptr, nullptr);
  running->gone = new Local{destroy, value, running->gone};
  return 0;
}

pthread_t pthread_self() { return reinterpret_cast<pthread_t>(running); }

int pthread_key_create(pthread_key_t* key, void (*destroy)(void*))
{
  if (keys == most_keys)
    return EAGAIN;
  destroys[keys] = destroy;
  *key = keys++;
  return 0;
}

void* pthread_getspecific(pthread_key_t key) { return running->kept[key]; }

int pthread_setspecific(pthread_key_t key, const void* value)
{
  running->kept[key] = const_cast<void*>(value);
  return 0;
}

// The library puts a mutex's type first in it; its owner and how often that has locked it come next. A mutex that is
// unlocked goes to whoever asks first, which may be the thread that has unlocked it.
int pthread_mutex_trylock(pthread_mutex_t* mutex)
{
  auto& owner = mutex->__u.__p[1];
  if (owner && !(owner == running && (mutex->__u.__i[0] & 3) == PTHREAD_MUTEX_RECURSIVE))
    return EBUSY;
  owner = running;
  mutex->__u.__i[2]++;
  return 0;
}

int pthread_mutex_lock(pthread_mutex_t* mutex)
{
  if (pthread_mutex_trylock(mutex) == 0)
    return 0;
  running->asked = mutex;
  if (rosspin::detail::look_for_ring)
    rosspin::detail::look_for_ring();
  do
    rosspin::wait_for(mutex, rosspin::never);
  while (pthread_mutex_trylock(mutex));
  running->asked = nullptr;
  return 0;
}

int pthread_mutex_unlock(pthread_mutex_t* mutex)
{
  if (--mutex->__u.__i[2] > 0)
    return 0;
  mutex->__u.__i[2] = 0;
  mutex->__u.__p[1] = nullptr;
  rosspin::notify(mutex, false);
  return 0;
}

// Of the words of a lock the first is how many read; -1: one writes.
int pthread_rwlock_init(pthread_rwlock_t* lock, const pthread_rwlockattr_t*)
{
  *lock = {};
  return 0;
}

int pthread_rwlock_destroy(pthread_rwlock_t*) { return 0; }

int pthread_rwlock_tryrdlock(pthread_rwlock_t* lock) { return lock->__u.__i[0] < 0 ? EBUSY : (lock->__u.__i[0]++, 0); }

int pthread_rwlock_trywrlock(pthread_rwlock_t* lock) { return lock->__u.__i[0] ? EBUSY : (lock->__u.__i[0] = -1, 0); }

int pthread_rwlock_rdlock(pthread_rwlock_t* lock)
{
  while (pthread_rwlock_tryrdlock(lock))
    rosspin::wait_for(lock, rosspin::never);
  return 0;
}

int pthread_rwlock_wrlock(pthread_rwlock_t* lock)
{
  while (pthread_rwlock_trywrlock(lock))
    rosspin::wait_for(lock, rosspin::never);
  return 0;
}

int pthread_rwlock_unlock(pthread_rwlock_t* lock)
{
  int& readers = lock->__u.__i[0];
  readers = readers < 0 ? 0 : readers - 1;
  rosspin::notify(lock, true);
  return 0;
}

int pthread_cond_init(pthread_cond_t* condition, const pthread_condattr_t*)
{
  *condition = {};
  return 0;
}

int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* time)
{
  std::int64_t until = time ? after(time, -rosspin::detail::ahead()) : rosspin::never;
  pthread_mutex_unlock(mutex);
  bool notified = rosspin::wait_for(condition, until);
  pthread_mutex_lock(mutex);
  return notified ? 0 : ETIMEDOUT;
}

int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex)
{
  return pthread_cond_timedwait(condition, mutex, nullptr);
}

int pthread_cond_signal(pthread_cond_t* condition)
{
  rosspin::notify(condition, false);
  return 0;
}

int pthread_cond_broadcast(pthread_cond_t* condition)
{
  rosspin::notify(condition, true);
  return 0;
}

// --- how time passes for whoever asks the system ---

int __clock_gettime(clockid_t clock, timespec* time)
{
  if (clock != CLOCK_REALTIME && clock != CLOCK_MONOTONIC)
  {
    errno = EINVAL;
    return -1;
  }
  std::int64_t ns = clock == CLOCK_REALTIME ? rosspin::system_now() : rosspin::now();
  *time = {ns / second, static_cast<long>(ns % second)};
  return 0;
}

int clock_gettime(clockid_t clock, timespec* time) { return __clock_gettime(clock, time); }

int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec*)
{
  if (time->tv_sec < 0 || time->tv_nsec < 0 || time->tv_nsec >= second)
    return EINVAL;
  std::int64_t since = !(flags & TIMER_ABSTIME) ? rosspin::now() : clock == CLOCK_REALTIME ? -rosspin::detail::ahead() : 0;
  rosspin::sleep_until(after(time, since));
  return 0;
}

int sched_yield()
{
  rosspin::look();
  rosspin::wait_for(nullptr, rosspin::detail::time());
  return 0;
}
}

// What a node's program and the host that runs it know of each other.
#ifndef ROSSPIN_HOST_H
#define ROSSPIN_HOST_H

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

// What the host reads and writes here, in this order (see js/shared.mjs): the time, what the system's clock is ahead of
// it, until when the program is alone; whether it has told something, so that the host has to be asked; how often it has
// looked; the ticks, as many as were not told yet; how many callbacks wait for someone to spin, -1 if someone has; the
// number of the first of those ticks; and whether the time is real, which passes by itself.
struct RosspinTick
{
  std::int32_t source, number;
  std::int64_t expected, real, duration;  // -1 while it lasts
};

// The C library is compiled without threads, so it has one errno for all.
extern "C" int rosspin_errno __asm__("errno");
#undef errno
#define errno rosspin_errno

extern "C"
{
// Of a text that the node was compiled from, as clang's checks write it down.
struct RosspinPlace
{
  const char* file;
  std::uint32_t line, column;
};
extern struct RosspinShared
{
  std::int64_t now, ahead, horizon;
  std::int32_t urgent, looks, ticks, waiting;
  std::int64_t first;
  std::int64_t real;
  const RosspinPlace* fault;
  std::int32_t divides;
  RosspinTick tick[4096];
} rosspin_shared;
}

namespace rosspin
{
constexpr std::int64_t never = INT64_MAX;

// The run's time (ns), which never jumps, and what its system's clock tells.
std::int64_t now();
std::int64_t system_now();

// Let time pass up to `until` (ns), or until something comes for the program before that.
void wait(std::int64_t until);
// Let it pass until something is due. What says when (ns) is asked again as things come, and in any thread.
using Due = std::function<std::int64_t()>;
void wait(const Due& due);
// Let it pass up to `until`, whatever comes.
void sleep_until(std::int64_t until);
// Let this thread wait until a time (ns), or until someone notifies of `what`; return whether that was.
bool wait_for(const void* what, std::int64_t until, const Due* due = nullptr);
// Wake a thread that waits for it, the one that has waited longest, or `all` of them.
void notify(const void* what, bool all);
// Something has changed: whoever waits for what comes looks again.
void stir();
// Whoever asks the same again and again, without waiting, waits by asking.
void look();

// What threads are made of (see runtime/threads.cpp).
namespace detail
{
inline std::int64_t time() { return rosspin_shared.now; }
inline std::int64_t ahead() { return rosspin_shared.ahead; }
void go_on(std::int64_t until);
bool is_alone();
extern void (*begin_thread)(void* (*start)(void*), void* value);  // null until a thread was made
}  // namespace detail

// Something that ticks. The host records its ticks, and at the end of the run, what would have come next. Times are in ns.
class Ticking
{
public:
  Ticking();
  Ticking(const Ticking& other);
  Ticking& operator=(const Ticking& other);
  virtual ~Ticking();

  // List when its next ticks would be due, and come, had nothing more delayed them, up to one that is on time.
  virtual std::vector<std::pair<std::int64_t, std::int64_t>> coming() const = 0;
  // Whoever spins until the end has left all loops.
  static void leave_loops();

protected:
  void tick_as(const std::string& name, std::int64_t period);
  // Beginning a tick gives what ends it.
  std::int64_t begin_tick(std::int64_t expected, std::int64_t real);
  static void end_tick(std::int64_t tick, std::int64_t duration);
  // It will never tick.
  void lose() const;
  int source_ = -1, count_ = 0;
  bool left_ = false;

private:
  friend void tell_coming();
  Ticking* next_;
};

// What each Rate has: the passes of its loop should begin at regular times.
class Loop : public Ticking
{
public:
  std::vector<std::pair<std::int64_t, std::int64_t>> coming() const override;

protected:
  Loop();
  // A pass ends `now`: give when the next one begins. Both are times of the Rate's clock.
  std::int64_t end_pass(const char* name, std::int64_t now);
  void begin_pass();

  virtual std::int64_t time() const = 0;
  // When a sleep ends that begins at `now`: it moves the mark, which is where this pass should have begun.
  virtual std::int64_t wake(std::int64_t& mark, std::int64_t now) const = 0;
  std::int64_t period_ = 0, mark_ = 0;

private:
  std::int64_t grid_, begun_;  // in the run's time
  std::int64_t wakes_ = never;  // while it sleeps
};

// A value as the host and the program exchange it: of parameters, for example.
struct Value
{
  enum Kind { nothing, boolean, integer, real, text, list, table, bytes } kind = nothing;
  bool flag = false;
  std::int64_t whole = 0;
  double number = 0;
  std::string string;
  std::vector<Value> items;
  std::map<std::string, Value> fields;

  Value() = default;
  Value(bool value) : kind(boolean), flag(value) {}
  Value(int value) : kind(integer), whole(value) {}
  Value(std::int64_t value) : kind(integer), whole(value) {}
  Value(double value) : kind(real), number(value) {}
  Value(const char* value) : kind(text), string(value) {}
  Value(const std::string& value) : kind(text), string(value) {}
  Value(std::vector<Value> value) : kind(list), items(std::move(value)) {}
  Value(std::map<std::string, Value> value) : kind(table), fields(std::move(value)) {}
  bool operator==(const Value& other) const;
};

// Ask the host for something that only it knows; it answers before time moves.
Value ask(const std::string& what, std::vector<Value> values = {});
// Tell it something that needs no answer.
void tell(const std::string& what, std::vector<Value> values = {});

// Callbacks are called once someone spins: so many more wait for that.
void await_spin(int more = 1);
// Someone does.
void spins();
// Before that something was destroyed, so that it will never call back: a timer, by its source, a subscription, by its
// topic, or the "node" as a whole.
void lose(const std::string& what);
// It was made again.
void regain(const std::string& what);

// End the run: what the node asks for is not simulated.
[[noreturn]] void not_simulated(const std::string& what);

// Called with what comes for the program while it waits: `what`, and when it came (ns).
extern std::function<void(const std::string& what, std::int64_t when, const Value& values)> on_event;

// Write to standard output (1) or standard error (2), as a whole.
void write(int stream, const std::string& text);

// The name that a function has in the source, by its address.
std::string function_name(std::uintptr_t address);

template<class Function>
std::string name_of(const Function& function);

namespace detail
{
template<class Function>
struct Name
{
  static std::string of(const Function&) { return "lambda"; }
};

template<class Result, class... Parameters>
struct Name<Result (*)(Parameters...)>
{
  static std::string of(Result (*function)(Parameters...))
  {
    return function_name(reinterpret_cast<std::uintptr_t>(function));
  }
};

template<class Result, class... Parameters>
struct Name<Result(Parameters...)>
{
  static std::string of(Result (*function)(Parameters...))
  {
    return function_name(reinterpret_cast<std::uintptr_t>(function));
  }
};

// A pointer to a member function begins with its address, unless it is virtual.
template<class Member, class Class>
struct Name<Member Class::*>
{
  static std::string of(Member Class::* member)
  {
    std::uintptr_t words[2];
    static_assert(sizeof member == sizeof words);
    std::memcpy(words, &member, sizeof words);
    return words[1] & 1 ? "virtual" : function_name(words[0]);
  }
};

// What std::bind has made begins with the function.
template<class Function, class... Bound>
struct Name<std::__bind<Function, Bound...>>
{
  static std::string of(const std::__bind<Function, Bound...>& bound)
  {
    return name_of(*reinterpret_cast<const std::decay_t<Function>*>(&bound));
  }
};

template<class Result, class... Parameters>
struct Name<std::function<Result(Parameters...)>>
{
  static std::string of(const std::function<Result(Parameters...)>& function)
  {
    if (auto target = function.template target<Result (*)(Parameters...)>())
      return name_of(*target);
    return "function";
  }
};
}  // namespace detail

template<class Function>
std::string name_of(const Function& function)
{
  return detail::Name<Function>::of(function);
}
}  // namespace rosspin

#endif

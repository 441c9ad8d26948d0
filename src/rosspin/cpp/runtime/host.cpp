// The program's side of rosspin/host.h: what it imports from the host, and what the host calls.
#include "rosspin/host.h"
#include "rosspin/format.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#define FROM_HOST(name) __attribute__((import_module("rosspin"), import_name(name))) extern

extern "C"
{
FROM_HOST("wait") void rosspin_wait(std::int64_t until);
FROM_HOST("touch") void rosspin_touch();
FROM_HOST("source") int rosspin_source(const char* name, std::size_t length, std::int64_t period);
FROM_HOST("flush") void rosspin_flush();
FROM_HOST("end") void rosspin_end(std::int64_t tick, std::int64_t duration);
FROM_HOST("tell") void rosspin_tell(const char* text, std::size_t length);
FROM_HOST("ask") const char* rosspin_ask(const char* text, std::size_t length, std::size_t* answered);
FROM_HOST("name") const char* rosspin_name(std::uintptr_t address, std::size_t* length);
}

namespace
{
constexpr int most_ticks = sizeof rosspin_shared.tick / sizeof *rosspin_shared.tick;

// A program that looks at the clock so often without waiting waits by looking: from then on each look takes 1 µs, and
// ten times as long each time that it has looked so often again, up to 1 ms (see js/wasi.mjs).
constexpr std::int32_t most_looks = 10'000;
constexpr std::int64_t one_look[] = {0, 1'000, 10'000, 100'000, 1'000'000};
}  // namespace

__attribute__((used)) RosspinShared rosspin_shared;

// What clang's checks call before a null pointer is used, or before a division by zero (compiler-rt's ubsan_handlers.h).
extern "C" [[noreturn]] void __ubsan_handle_type_mismatch_v1_abort(const RosspinPlace* place, std::uintptr_t)
{
  rosspin_shared.fault = place;
  __builtin_trap();
}

extern "C" [[noreturn]] void __ubsan_handle_divrem_overflow_abort(const RosspinPlace* place, std::uintptr_t, std::uintptr_t)
{
  rosspin_shared.fault = place;
  rosspin_shared.divides = 1;
  __builtin_trap();
}

namespace rosspin
{
namespace
{
auto& shared = rosspin_shared;

// --- values as text: a letter for the kind, then the value ---

void put(std::string& out, const Value& value);

void put_text(std::string& out, const std::string& text)
{
  out += std::to_string(text.size()) + ":" + text;
}

void put(std::string& out, const Value& value)
{
  char buffer[40];
  switch (value.kind)
  {
  case Value::nothing:
    out += 'n';
    break;
  case Value::boolean:
    out += value.flag ? 't' : 'f';
    break;
  case Value::integer:
    out += 'i' + std::to_string(value.whole) + ';';
    break;
  case Value::real:
    std::snprintf(buffer, sizeof buffer, "d%.17g;", value.number);
    out += buffer;
    break;
  case Value::text:
    out += 's';
    put_text(out, value.string);
    break;
  case Value::bytes:
    out += 'b';
    put_text(out, value.string);
    break;
  case Value::list:
    out += 'l';
    for (const Value& item : value.items)
      put(out, item);
    out += 'e';
    break;
  case Value::table:
    out += 'm';
    for (const auto& [name, field] : value.fields)
    {
      put(out, name);
      put(out, field);
    }
    out += 'e';
  }
}

std::string get_until(const char*& at, char end)
{
  const char* begin = at;
  while (*at != end)
    at++;
  return std::string(begin, at++);
}

Value get(const char*& at)
{
  Value value;
  switch (*at++)
  {
  case 't':
    return true;
  case 'f':
    return false;
  case 'i':
    return std::int64_t(std::strtoll(get_until(at, ';').c_str(), nullptr, 10));
  case 'd':
    return std::strtod(get_until(at, ';').c_str(), nullptr);
  case 's':
  case 'b':
  {
    value.kind = at[-1] == 's' ? Value::text : Value::bytes;
    std::size_t length = std::strtoul(get_until(at, ':').c_str(), nullptr, 10);
    value.string.assign(at, length);
    at += length;
    break;
  }
  case 'l':
    for (value.kind = Value::list; *at != 'e';)
      value.items.push_back(get(at));
    at++;
    break;
  case 'm':
    for (value.kind = Value::table; *at != 'e';)
    {
      std::string name = get(at).string;
      value.fields[name] = get(at);
    }
    at++;
    break;
  default:
    break;
  }
  return value;
}

std::string request(const std::string& what, std::vector<Value> values)
{
  std::string text;
  put(text, what);
  put(text, Value(std::move(values)));
  return text;
}
}  // namespace

std::function<void(const std::string&, std::int64_t, const Value&)> on_event;

bool Value::operator==(const Value& other) const
{
  return kind == other.kind && flag == other.flag && whole == other.whole && number == other.number &&
         string == other.string && items == other.items && fields == other.fields;
}

std::int64_t now()
{
  look();
  return shared.now;
}

std::int64_t system_now() { return now() + shared.ahead; }

namespace detail
{
// Nothing else has anything to do before the horizon, so the time moves to it without the host.
void go_on(std::int64_t until)
{
  if (until > shared.now)
    shared.looks = 0;
  else
    look();
  if (until >= shared.horizon || shared.urgent)
    rosspin_wait(until);
  else if (until > shared.now)
    shared.now = until;
}
}  // namespace detail

void wait(std::int64_t until)
{
  if (until <= shared.now || detail::is_alone())
    detail::go_on(until);
  if (!detail::is_alone())
    wait_for(&on_event, until);
}

void wait(const Due& due)
{
  for (std::int64_t until; (until = due()) > shared.now;)
    if (detail::is_alone())
      detail::go_on(until);
    else
      wait_for(&on_event, until, &due);
}

void stir() { notify(&on_event, true); }

void sleep_until(std::int64_t until)
{
  while (shared.now < until)
    wait_for(nullptr, until);
}

void look()
{
  if (shared.real)
    rosspin_touch();
  if (int times = shared.looks++ / most_looks)
  {
    std::int64_t until = shared.now + one_look[std::min(times, 4)];
    std::int32_t looks = shared.looks;
    if (detail::is_alone())
      rosspin_wait(until);
    else
      wait_for(nullptr, until);
    shared.looks = looks;
  }
}

namespace
{
// What was lost, each between spaces. Never destroyed, as timers may be global.
std::string& lost()
{
  static auto* all = new std::string(" ");
  return *all;
}

Ticking* first = nullptr;  // of all of them
}  // namespace

void await_spin(int more)
{
  if (shared.waiting >= 0)
    shared.waiting = std::max(0, shared.waiting + more);
}

void spins()
{
  if (std::exchange(shared.waiting, -1) >= 0 && lost().size() > 1)
    tell("lost", {lost()});
}

void lose(const std::string& what)
{
  if (shared.waiting >= 0)
    lost() += what + ' ';
}

void regain(const std::string& what)
{
  if (std::size_t at = lost().find(' ' + what + ' '); at != std::string::npos)
    lost().erase(at, what.size() + 1);
}

void Ticking::lose() const
{
  if (source_ >= 0 && !count_)
    rosspin::lose(std::to_string(source_));
}

Ticking::Ticking() : next_(std::exchange(first, this)) {}
Ticking::Ticking(const Ticking& other) : Ticking() { *this = other; }

Ticking& Ticking::operator=(const Ticking& other)
{
  source_ = other.source_;
  count_ = other.count_;
  return *this;
}

Ticking::~Ticking()
{
  Ticking** at = &first;
  while (*at != this)
    at = &(*at)->next_;
  *at = next_;
}

void Ticking::tick_as(const std::string& name, std::int64_t period)
{
  if (source_ < 0)
    source_ = rosspin_source(name.data(), name.size(), period);
}

std::int64_t Ticking::begin_tick(std::int64_t expected, std::int64_t real)
{
  if (shared.ticks == most_ticks)
    rosspin_flush();
  shared.tick[shared.ticks] = {source_, ++count_, expected, real, -1};
  return shared.first + shared.ticks++;
}

void Ticking::end_tick(std::int64_t tick, std::int64_t duration)
{
  if (tick >= shared.first)
    shared.tick[tick - shared.first].duration = duration;
  else
    rosspin_end(tick, duration);
}

Loop::Loop() : grid_(now()), begun_(grid_) {}

std::int64_t Loop::end_pass(const char* name, std::int64_t now)
{
  left_ = false;
  tick_as(name, period_);
  end_tick(begin_tick(grid_, begun_), rosspin::now() - begun_);
  grid_ += period_;
  return wakes_ = wake(mark_, now);
}

void Loop::begin_pass()
{
  wakes_ = never;
  begun_ = now();
}

void Ticking::leave_loops()
{
  for (Ticking* each = first; each; each = each->next_)
    each->left_ = true;
}

std::vector<std::pair<std::int64_t, std::int64_t>> Loop::coming() const
{
  std::vector<std::pair<std::int64_t, std::int64_t>> found;
  if (!count_ || left_ || period_ <= 0)
    return found;
  std::int64_t ends = time(), ahead = ends - shared.now, mark = mark_, grid = grid_, begins = wakes_;
  if (begins == never)
  {
    found.emplace_back(grid, begun_);
    grid += period_;
    begins = wake(mark, ends);
  }
  for (;; begins = wake(mark, ends), grid += period_)
  {
    found.emplace_back(grid, begins - ahead);
    if (begins > ends)
      return found;
  }
}

void tell_coming()
{
  std::vector<Value> values;
  for (Ticking* each = first; each; each = each->next_)
    if (std::int64_t number = each->count_; each->source_ >= 0)
      for (auto [due, real] : each->coming())
        for (std::int64_t value : {std::int64_t(each->source_), ++number, due, real})
          values.emplace_back(value);
  tell("coming", std::move(values));
}

Value ask(const std::string& what, std::vector<Value> values)
{
  std::string text = request(what, std::move(values));
  std::size_t length;
  const char* answer = rosspin_ask(text.data(), text.size(), &length);
  const char* at = answer;
  Value value = get(at);
  std::free(const_cast<char*>(answer));
  return value;
}

void tell(const std::string& what, std::vector<Value> values)
{
  std::string text = request(what, std::move(values));
  rosspin_tell(text.data(), text.size());
}

std::string formatted(const char* format, std::initializer_list<Argument> arguments)
{
  std::string out;
  auto next = arguments.begin();
  auto take = [&] { return next == arguments.end() ? Argument(0) : *next++; };
  for (const char* at = format; *at; at++)
  {
    if (*at != '%' || *++at == '%')
    {
      out += *at;
      continue;
    }
    std::string form = "%";
    for (; *at && std::strchr("-+ #0.123456789*", *at); at++)
      form += *at == '*' ? std::to_string(take().integer) : std::string(1, *at);
    bool wide = false;
    for (; *at && std::strchr("hljztLq", *at); at++)
      wide = wide || *at != 'h';
    if (!*at)
      break;
    char buffer[400];
    Argument argument = take();
    if (std::strchr("eEfFgGaA", *at))
    {
      double number = argument.kind == Argument::whole ? static_cast<double>(argument.integer) : argument.number;
      std::snprintf(buffer, sizeof buffer, (form + *at).c_str(), number);
    }
    else if (*at == 's')
    {
      auto text = static_cast<const char*>(argument.address);
      std::string whole(std::snprintf(nullptr, 0, (form + "s").c_str(), text ? text : "(null)"), '\0');
      std::snprintf(whole.data(), whole.size() + 1, (form + "s").c_str(), text ? text : "(null)");
      out += whole;
      continue;
    }
    else if (*at == 'p')
    {
      if (argument.address)
        std::snprintf(buffer, sizeof buffer, (form + "p").c_str(), argument.address);
      else
        std::snprintf(buffer, sizeof buffer, (form + "s").c_str(), "(nil)");
    }
    else if (*at == 'c')
    {
      std::snprintf(buffer, sizeof buffer, (form + "c").c_str(), static_cast<int>(argument.integer));
    }
    else
    {
      std::int64_t integer = argument.kind == Argument::real ? static_cast<std::int64_t>(argument.number)
                                                             : argument.integer;
      if (!wide)
        integer = *at == 'd' || *at == 'i' ? static_cast<std::int64_t>(static_cast<std::int32_t>(integer))
                                           : static_cast<std::int64_t>(static_cast<std::uint32_t>(integer));
      std::snprintf(buffer, sizeof buffer, (form + "ll" + *at).c_str(), static_cast<long long>(integer));
    }
    out += buffer;
  }
  return out;
}

void write(int stream, const std::string& text)
{
  std::fflush(stream == 1 ? stdout : stderr);  // what the node has printed comes first
  ::write(stream, text.data(), text.size());
}

namespace
{
// The numbers of glibc's rand(), from its seed (source: stdlib/random_r.c, TYPE_3).
struct Random
{
  std::uint32_t state[31];
  int front, rear;
  explicit Random(std::uint32_t seed) : front(3), rear(0)
  {
    constexpr std::int64_t prime = 2147483647;
    auto word = static_cast<std::int32_t>(seed ? seed : 1);
    for (std::uint32_t& each : state)
    {
      each = static_cast<std::uint32_t>(word);
      word = static_cast<std::int32_t>((16807 * static_cast<std::int64_t>(word) % prime + prime) % prime);
    }
    for (int each = 0; each < 310; each++)
      next();
  }
  int next()
  {
    std::uint32_t sum = state[front] += state[rear];
    front = (front + 1) % 31;
    rear = (rear + 1) % 31;
    return static_cast<int>(sum >> 1);
  }
};

Random& random_numbers()
{
  static Random one(1);
  return one;
}
}  // namespace

void not_simulated(const std::string& what)
{
  ask("not_simulated", {what});
  std::_Exit(1);
}

std::string function_name(std::uintptr_t address)
{
  std::size_t length;
  const char* name = rosspin_name(address, &length);
  std::string text(name, length);
  std::free(const_cast<char*>(name));
  // Without its parameters and the class or namespace that it is in.
  text = text.substr(0, text.find('('));
  if (std::size_t at = text.rfind("::"); at != std::string::npos)
    text = text.substr(at + 2);
  return text;
}
}  // namespace rosspin

// --- signals ---

namespace
{
using Handler = void (*)(int);
Handler handlers[65];  // null: the signal's default

void* handle(void* value)
{
  int number = reinterpret_cast<int>(value);
  if (Handler handler = handlers[number]; handler == SIG_IGN)
    return nullptr;
  else if (handler)
    handler(number);
  else if (number != SIGCHLD && number != SIGCONT && number != SIGURG && number != SIGWINCH)
  {
    std::fflush(nullptr);
    std::_Exit(128 + number);
  }
  return nullptr;
}
}  // namespace

extern "C"
{
// Known by their addresses only.
void __SIG_IGN(int) {}
void __SIG_DFL(int) {}
void __SIG_ERR(int) {}

Handler signal(int number, Handler handler)
{
  if (number < 1 || number > 64)
  {
    errno = EINVAL;
    return SIG_ERR;
  }
  Handler before = handlers[number] ? handlers[number] : SIG_DFL;
  handlers[number] = handler == SIG_DFL ? nullptr : handler;
  return before;
}

int raise(int number)
{
  if (number < 1 || number > 64)
  {
    errno = EINVAL;
    return -1;
  }
  handle(reinterpret_cast<void*>(number));
  return 0;
}

// A call of abort says nothing; the status is a signal's.
void abort()
{
  std::fflush(nullptr);
  raise(SIGABRT);
  std::_Exit(128 + SIGABRT);
}

int getpid() { return 1; }

__attribute__((export_name("rosspin_signal"))) void rosspin_signal(int number)
{
  rosspin_shared.looks = 0;  // to look does not wait here
  if (static bool told = false; !std::exchange(told, true))
    rosspin::tell_coming();
  // Whoever waits now cannot wait for anything else meanwhile.
  if (rosspin::detail::begin_thread)
    rosspin::detail::begin_thread(handle, reinterpret_cast<void*>(number));
  else
    handle(reinterpret_cast<void*>(number));
}

// Something has come, as text that the program frees.
__attribute__((export_name("rosspin_event"))) void rosspin_event(char* text, std::int64_t when)
{
  const char* at = text;
  std::string what = rosspin::get(at).string;
  rosspin::Value values = rosspin::get(at);
  std::free(text);
  if (rosspin::on_event)
    rosspin::on_event(what, when, values);
  rosspin::stir();
}

int rand() { return rosspin::random_numbers().next(); }

void srand(unsigned seed) { rosspin::random_numbers() = rosspin::Random(seed); }

long random() { return rand(); }

void srandom(unsigned seed) { srand(seed); }

std::FILE* fopen(const char* name, const char*)
{
  if (static bool told = false; !std::exchange(told, true))
    rosspin::write(2, std::string("rosspin: files are not simulated, so this one was not opened: ") + name + "\n");
  errno = ENOENT;
  return nullptr;
}
}

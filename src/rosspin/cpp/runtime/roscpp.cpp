// What is no template of the stand-in for roscpp.
#include "ros/ros.h"

#include <csignal>
#include <optional>
#include <thread>

namespace ros
{
namespace
{
struct Node
{
  bool initialized = false, started = false, ok = false, shutting_down = false, logs = true, has_rosout = true,
       handles_interrupt = true;
  std::string name, space;
  M_string remappings;
  int handles = 0;
  console::Level level = console::levels::Info;
  CallbackQueue queue;
  std::map<std::int64_t, detail::PublicationImpl*> publications;
  std::vector<detail::SubscriptionImpl*> subscriptions;
  std::map<std::string, detail::ServiceImpl*> services;
  std::int64_t calls = 0;
  std::map<std::int64_t, rosspin::Value> responses;  // to calls that wait
  bool time = false;
  std::optional<std::int64_t> told;  // ROS time as set by /clock, if the node follows it
  // The queues that are spun: by how many spinners, and in which thread, if that is the only one.
  std::map<CallbackQueue*, std::pair<int, std::thread::id>> spun;
};

Node& node()
{
  // Never destroyed: what lives as long as the program may need it.
  static Node* one = nullptr;
  return *(one ? one : one = new Node);
}

constexpr std::int64_t second = 1'000'000'000;

rosspin::Value data_of(const std::string& bytes)
{
  rosspin::Value data;
  data.kind = rosspin::Value::bytes;
  data.string = bytes;
  return data;
}

std::int64_t later(std::int64_t time, std::int64_t by)
{
  return by > rosspin::never - time ? rosspin::never : time + by;
}
}  // namespace

// --- time (sources: rostime/impl/time.h, impl/duration.h, rate.cpp, time.cpp) ---

namespace detail
{
std::int64_t from_seconds(double seconds, const char* what, std::int64_t least, std::int64_t most)
{
  if (!(seconds >= static_cast<double>(least) && seconds < static_cast<double>(most) + 1))
    throw std::runtime_error(std::string(what) + " is out of dual 32-bit range");
  double whole = std::floor(seconds);
  std::int64_t rest = static_cast<std::int64_t>(std::floor((seconds - whole) * 1e9 + 0.5));
  return static_cast<std::int64_t>(whole) * second + rest;
}

std::int64_t checked_duration(std::int64_t ns)
{
  std::int64_t whole = ns / second - (ns % second < 0);
  if (whole < INT32_MIN || whole > INT32_MAX)
    throw std::runtime_error("Duration is out of dual 32-bit range");
  return ns;
}

std::int64_t checked_time(std::int64_t ns)
{
  if (ns < 0 || ns / second > UINT32_MAX)
    throw std::runtime_error("Time is out of dual 32-bit range");
  return ns;
}

std::ostream& print(std::ostream& stream, std::int64_t ns)
{
  char text[40];
  std::uint64_t size = ns < 0 ? -static_cast<std::uint64_t>(ns) : ns;
  std::snprintf(text, sizeof text, "%s%llu.%09llu", ns < 0 ? "-" : "",
      static_cast<unsigned long long>(size / second), static_cast<unsigned long long>(size % second));
  return stream << text;
}

std::int64_t now(Time*)
{
  if (!node().time)
    throw TimeNotInitializedException();
  rosspin::look();
  return node().told ? *node().told : rosspin::system_now();
}
std::int64_t now(WallTime*) { return rosspin::system_now(); }
std::int64_t now(SteadyTime*) { return rosspin::now(); }

namespace
{
// Sleep on the time that /clock tells: not at all if it goes back.
bool sleep_as_told(std::int64_t end)
{
  for (std::int64_t start = *node().told; !node().shutting_down && *node().told < end;)
  {
    rosspin::wait(rosspin::never);
    if (*node().told < start)
      return false;
  }
  return true;
}
}  // namespace

bool sleep_for(const Duration*, std::int64_t ns)
{
  Node& self = node();
  if (!self.told)
    return sleep_for(static_cast<const WallDuration*>(nullptr), ns);
  sleep_as_told(1);  // no time has been told yet
  std::int64_t end = checked_time(*self.told + ns);
  return *self.told < end && sleep_as_told(end) && !self.shutting_down;
}

bool sleep_for(const WallDuration*, std::int64_t ns)
{
  // Of a length below 0 the real one asks the system again and again, which refuses.
  rosspin::sleep_until(ns < 0 ? rosspin::never : later(rosspin::now(), ns));
  return !node().shutting_down;
}

bool sleep_until(Time*, std::int64_t ns)
{
  return node().told ? sleep_as_told(ns) : sleep_until(static_cast<WallTime*>(nullptr), ns);
}
bool sleep_until(WallTime*, std::int64_t ns)
{
  std::int64_t left = ns - rosspin::system_now();
  return left <= 0 || sleep_for(static_cast<const WallDuration*>(nullptr), left);
}
bool sleep_until(SteadyTime*, std::int64_t ns)
{
  if (ns > rosspin::now())
    rosspin::sleep_until(ns);
  return true;
}

Passes::Passes(std::int64_t period, bool wall) : wall_(wall)
{
  period_ = period;
  reset();
}

std::int64_t Passes::time() const { return wall_ ? rosspin::system_now() : detail::now(static_cast<Time*>(nullptr)); }

bool Passes::sleep()
{
  std::int64_t ends = time();
  cycle = ends - mark_;
  std::int64_t length = end_pass(wall_ ? "WallRate" : "Rate", ends) - ends;
  bool slept = false;
  if (length <= 0)
    rosspin::look();
  else if (wall_)
    slept = sleep_for(static_cast<const WallDuration*>(nullptr), length);
  else
    slept = sleep_for(static_cast<const Duration*>(nullptr), length);
  begin_pass();
  return slept;
}

// A pass that ends later than it should lets the next one begin at once. Two periods late or more, the grid is given up
// for one that begins now (source: rostime/rate.cpp, Rate::sleep).
std::int64_t Passes::wake(std::int64_t& mark, std::int64_t now) const
{
  std::int64_t expected = (now < mark ? now : mark) + period_;  // where the clock has gone back
  mark = now > expected + period_ ? now : expected;
  return std::max(now, expected);
}
}  // namespace detail

void Time::init() { node().time = true; }
void Time::shutdown() {}
bool Time::isSimTime() { return node().told.has_value(); }
bool Time::isValid() { return node().time && node().told != 0; }

bool Time::waitForValid(const WallDuration& timeout)
{
  std::int64_t most = timeout.isZero() ? rosspin::never : later(rosspin::now(), timeout.toNSec());
  while (!isValid() && !node().shutting_down && rosspin::now() < most)
    rosspin::wait(most);
  return isValid() && !node().shutting_down;
}

#define ROSSPIN_DURATIONS(D)                                                                                           \
  const D D::MAX(INT32_MAX, 999999999), D::MIN(INT32_MIN, 0), D::ZERO, D::DAY(86400, 0), D::HOUR(3600, 0),             \
      D::MINUTE(60, 0), D::SECOND(1, 0), D::MILLISECOND(0, 1000000), D::MICROSECOND(0, 1000), D::NANOSECOND(0, 1)
ROSSPIN_DURATIONS(Duration);
ROSSPIN_DURATIONS(WallDuration);
const Duration DURATION_MAX(INT32_MAX, 999999999), DURATION_MIN(INT32_MIN, 0);
const Time Time::MIN(0, 1), Time::MAX(UINT32_MAX, 999999999), Time::ZERO, Time::UNINITIALIZED;
const WallTime WallTime::MIN(0, 1), WallTime::MAX(UINT32_MAX, 999999999), WallTime::ZERO;
const SteadyTime SteadyTime::MIN(0, 1), SteadyTime::MAX(UINT32_MAX, 999999999), SteadyTime::ZERO;
const Time TIME_MAX(UINT32_MAX, 999999999), TIME_MIN(0, 1);

// --- logging (source: rosconsole.cpp, Formatter and print) ---

namespace console
{
bool enabled(Level level) { return level >= node().level; }

bool set_logger_level(const std::string&, Level level)
{
  node().level = level;
  return true;
}

void print(Level level, const std::string& text)
{
  if (!node().logs)  // roscpp's shutdown ends the console, too
    return;
  static const char* const names[] = {"DEBUG", " INFO", " WARN", "ERROR", "FATAL"};
  static const char* const colours[] = {"\033[32m", "\033[0m", "\033[33m", "\033[31m", "\033[31m"};
  std::stringstream stamp;
  stamp << WallTime::now();
  if (Time::isSimTime() && Time::isValid())
    stamp << ", " << Time::now();
  rosspin::write(level < levels::Warn ? 1 : 2,
      std::string(colours[level]) + "[" + names[level] + "] [" + stamp.str() + "]: " + text + "\033[0m\n");
}

bool throttled(double period, double& last, bool delayed)
{
  double now = Time::now().toSec();
  if (std::isnan(last))
  {
    last = now;
    return !delayed;
  }
  if (now >= last && last + period > now)
    return false;
  last = now;
  return true;
}
}  // namespace console

// --- names (sources: names.cpp, this_node.cpp) ---

namespace names
{
std::string clean(const std::string& name)
{
  std::string cleaned;
  for (char each : name)
    if (!(each == '/' && !cleaned.empty() && cleaned.back() == '/'))
      cleaned += each;
  if (cleaned.size() > 1 && cleaned.back() == '/')
    cleaned.pop_back();
  return cleaned;
}

std::string append(const std::string& left, const std::string& right) { return clean(left + "/" + right); }

bool validate(const std::string& name, std::string& error)
{
  if (name.empty())
    return true;
  std::stringstream said;
  char first = name[0];
  if (!(std::isalpha(static_cast<unsigned char>(first)) || first == '/' || first == '~'))
  {
    said << "Character [" << first << "] is not valid as the first character in Graph Resource Name [" << name
         << "].  Valid characters are a-z, A-Z, / and in some cases ~.";
    error = said.str();
    return false;
  }
  for (std::size_t at = 1; at < name.size(); at++)
  {
    char each = name[at];
    if (!(std::isalnum(static_cast<unsigned char>(each)) || each == '/' || each == '_'))
    {
      said << "Character [" << each << "] at element [" << at << "] is not valid in Graph Resource Name [" << name
           << "].  Valid characters are a-z, A-Z, 0-9, / and _.";
      error = said.str();
      return false;
    }
  }
  return true;
}

const M_string& getRemappings() { return node().remappings; }

std::string remap(const std::string& name)
{
  std::string resolved = resolve(name, false);
  for (const auto& [from, to] : node().remappings)
    if (resolve(from, false) == resolved)
      return resolve(to, false);
  return name;
}

std::string resolve(const std::string& name, bool to_remap) { return resolve(node().space, name, to_remap); }

std::string resolve(const std::string& ns, const std::string& name, bool to_remap)
{
  std::string error;
  if (!validate(name, error))
    throw InvalidNameException(error);
  if (name.empty())
    return ns.empty() ? "/" : ns[0] == '/' ? ns : append("/", ns);
  std::string copy = name[0] == '~' ? append(node().name, name.substr(1)) : name;
  if (copy[0] != '/')
    copy = append("/", append(ns, copy));
  copy = clean(copy);
  if (to_remap)
    copy = remap(copy);
  return copy[0] == '/' ? copy : resolve("/", copy, false);
}

std::string parentNamespace(const std::string& name)
{
  std::string cleaned = clean(name);
  if (cleaned.empty() || cleaned == "/")
    return cleaned;
  std::size_t at = cleaned.rfind('/');
  return at == std::string::npos ? "" : at == 0 ? "/" : cleaned.substr(0, at);
}
}  // namespace names

namespace this_node
{
const std::string& getName() { return node().name; }
const std::string& getNamespace() { return node().space; }
void getAdvertisedTopics(V_string& topics)
{
  topics.assign(node().has_rosout, "/rosout");
  for (const auto& [id, each] : node().publications)
    if (std::find(topics.begin(), topics.end(), each->topic) == topics.end())
      topics.push_back(each->topic);
}
void getSubscribedTopics(V_string& topics)
{
  for (auto each : node().subscriptions)  // which are added, as by the real one
    topics.push_back(each->topic);
}
}  // namespace this_node

// --- the node (source: init.cpp) ---

namespace
{
// A subscriber, of which node (its own if that is empty) and to which topic, has another type and md5sum than a publisher
// (sources: publication.cpp, topic_manager.cpp).
void refused(const std::vector<rosspin::Value>& values)
{
  const char* text[6];
  for (int each = 0; each < 6; each++)
    text[each] = values[each].string.c_str();
  const auto [client, topic, wanted, wanted_sum, type, sum] = text;
  if (*client)
  {
    ROS_ERROR("Client [%s] wants topic %s to have datatype/md5sum [%s/%s], but our version has [%s/%s]. Dropping "
              "connection.",
        client, topic, wanted, wanted_sum, type, sum);
    return;
  }
  ROS_ERROR("md5sum mismatch making local subscription to topic %s.", topic);
  ROS_ERROR("Subscriber expects type %s, md5sum %s", wanted, wanted_sum);
  ROS_ERROR("Publisher provides type %s, md5sum %s", type, sum);
  ROS_WARN("couldn't register subscriber on topic [%s]", topic);
}

void received(const std::string& what, std::int64_t when, const rosspin::Value& values)
{
  if (what == "shutdown")
    requestShutdown();
  if (what == "request")
    if (auto found = node().services.find(values.items[0].string); found != node().services.end())
      found->second->receive({values.items[1].whole, values.items[2].string, values.items[3].string});
  if (what == "connect")
    if (auto found = node().publications.find(values.items[0].whole); found != node().publications.end())
      found->second->receive(values.items[1].flag, values.items[2].string, values.items[3].whole);
  if (what == "refused")
    refused(values.items);
  if (what == "response")
    node().responses[values.items[0].whole] = values;
  if (what != "message")
    return;
  auto message = boost::make_shared<detail::Received>();
  message->bytes = values.items[1].string;
  message->publisher = values.items[2].string;
  message->when = node().told.value_or(when);
  for (auto each : std::vector<detail::SubscriptionImpl*>(node().subscriptions))
    if (each->id() == values.items[0].whole)
      each->receive(message);
}

void at_interrupt(int) { requestShutdown(); }

void initialize(M_string remappings, const std::string& name, std::uint32_t options)
{
  Node& self = node();
  self.ok = true;
  if (self.initialized)
    return;
  self.initialized = true;
  auto take = [&](const char* key, const std::string& otherwise)
  {
    auto found = remappings.find(key);
    return found == remappings.end() ? otherwise : found->second;
  };
  const char* from_environment = std::getenv("ROS_NAMESPACE");
  self.space = take("__ns", from_environment ? from_environment : "");
  self.space = self.space.empty() ? "/" : names::clean(self.space[0] == '/' ? self.space : "/" + self.space);
  std::string own = take("__name", name), error;
  if (own.find('/') != std::string::npos)
    throw InvalidNodeNameException("[" + own + "] is invalid: node names cannot contain /");
  if (own.find('~') != std::string::npos)
    throw InvalidNodeNameException("[" + own + "] is invalid: node names cannot contain ~");
  if (options & init_options::AnonymousName && !remappings.count("__name"))
    own += "_" + std::to_string(rosspin::system_now());
  if (!names::validate(own, error))
    throw InvalidNameException(error);
  self.name = names::resolve(self.space, own, false);
  std::map<std::string, rosspin::Value> parameters;
  for (const auto& [from, to] : remappings)
  {
    if (from.rfind("__", 0) == 0)
      continue;
    if (from[0] == '_')
      parameters[names::resolve("~" + from.substr(1), false)] = to;
    else
      self.remappings[names::resolve(from, false)] = names::resolve(to, false);
  }
  self.has_rosout = !(options & init_options::NoRosout);
  rosspin::ask("init", {self.name, parameters, self.has_rosout});
  rosspin::on_event = received;
  self.handles_interrupt = !(options & init_options::NoSigintHandler);
}
}  // namespace

void init(int& argc, char** argv, const std::string& name, std::uint32_t options)
{
  M_string remappings;
  int kept = 0;
  for (int each = 0; each < argc; each++)
  {
    std::string word = argv[each];
    if (std::size_t at = word.find(":="); at != std::string::npos)
      remappings[word.substr(0, at)] = word.substr(at + 2);
    else
      argv[kept++] = argv[each];
  }
  argc = kept;
  initialize(remappings, name, options);
}

void init(const M_string& remappings, const std::string& name, std::uint32_t options)
{
  initialize(remappings, name, options);
}

void init(const VP_string& remappings, const std::string& name, std::uint32_t options)
{
  initialize(M_string(remappings.begin(), remappings.end()), name, options);
}

bool isInitialized() { return node().initialized; }

void removeROSArgs(int argc, const char* const* argv, V_string& out)
{
  for (int each = 0; each < argc; each++)
    if (std::string(argv[each]).find(":=") == std::string::npos)
      out.push_back(argv[each]);
}

namespace
{
// Each message on /clock is taken as soon as it comes, not by whoever spins (source: init.cpp, start).
struct AtOnce : CallbackQueueInterface
{
  void addCallback(const CallbackInterfacePtr& callback, std::uint64_t) override { callback->call(); }
  void removeByID(std::uint64_t) override {}
};

void follow_clock()
{
  rosspin::Value asked;
  if (!param::get("/use_sim_time", asked) || !asked.flag)
    return;
  Time::setNow(Time());
  static AtOnce at_once;
  auto take = [](detail::Received& received)
  {
    std::uint32_t stamp[2];  // what a rosgraph_msgs/Clock is, as bytes
    std::memcpy(stamp, received.bytes.data(), sizeof stamp);
    Time::setNow(Time(stamp[0], stamp[1]));
  };
  new detail::SubscriptionImpl(names::resolve("/clock"), "rosgraph_msgs/Clock", 1, take, {}, &at_once, true);
}
}  // namespace

void start()
{
  Node& self = node();
  if (self.started)
    return;
  self.started = self.ok = self.time = true;
  self.shutting_down = false;
  if (self.handles_interrupt)
    std::signal(SIGINT, at_interrupt);
  follow_clock();
}

bool isStarted() { return node().started; }

bool ok()
{
  rosspin::look();
  return node().ok;
}

bool isShuttingDown() { return node().shutting_down; }

void shutdown()
{
  Node& self = node();
  if (self.shutting_down)
    return;
  self.shutting_down = true;
  self.queue.disable();
  self.queue.clear();
  if (self.started)
  {
    for (auto each : std::vector<detail::SubscriptionImpl*>(self.subscriptions))
      each->end(false);
    rosspin::tell("shutdown");
  }
  self.logs = self.started = self.ok = false;
  rosspin::stir();
}

void requestShutdown() { shutdown(); }

void waitForShutdown()
{
  rosspin::wait([] { return node().ok ? rosspin::never : rosspin::detail::time(); });
}

// --- callbacks (source: callback_queue.cpp) ---

namespace
{
std::int64_t call_due_timers();
}  // namespace

void CallbackQueue::addCallback(const CallbackInterfacePtr& callback, std::uint64_t owner)
{
  if (enabled_)
    waiting_.push_back({callback, owner});
  rosspin::stir();
}

void CallbackQueue::removeByID(std::uint64_t owner)
{
  auto is_its = [=](const Entry& entry) { return entry.owner == owner; };
  waiting_.remove_if(is_its);
  for (auto* each : calling_)
    each->remove_if(is_its);
}

bool CallbackQueue::empty()
{
  rosspin::look();
  call_due_timers();
  return waiting_.empty();
}

std::list<CallbackQueue::Entry>::iterator CallbackQueue::first()
{
  return std::find_if(waiting_.begin(), waiting_.end(), [](const Entry& entry) { return entry.callback->ready(); });
}

bool CallbackQueue::await(const rosspin::Due& until)
{
  rosspin::look();
  bool found = false;
  rosspin::wait([&]
  {
    std::int64_t next = call_due_timers();
    found = first() != waiting_.end();
    if (found || !enabled_ || (this == &node().queue && !node().ok))
      return rosspin::detail::time();
    return std::min(until(), next);
  });
  return found;
}

CallbackQueue::CallOneResult CallbackQueue::callOne(WallDuration timeout)
{
  return callOne([until = later(rosspin::detail::time(), timeout.toNSec())] { return until; });
}

CallbackQueue::CallOneResult CallbackQueue::callOne(const rosspin::Due& until)
{
  rosspin::spins();
  if (!enabled_)
    return Disabled;
  if (!await(until))
    return Empty;
  auto found = first();
  Entry entry = *found;
  waiting_.erase(found);
  entry.callback->call();
  return Called;
}

void CallbackQueue::callAvailable(WallDuration timeout)
{
  callAvailable([until = later(rosspin::detail::time(), timeout.toNSec())] { return until; });
}

void CallbackQueue::callAvailable(const rosspin::Due& until)
{
  rosspin::spins();
  if (!enabled_)
    return;
  await(until);
  std::list<Entry> taken;
  taken.swap(waiting_);
  calling_.push_back(&taken);
  struct Leave
  {
    std::vector<std::list<Entry>*>& calling;
    std::list<Entry>* taken;
    ~Leave() { calling.erase(std::find(calling.begin(), calling.end(), taken)); }
  } leave{calling_, &taken};
  while (!taken.empty())  // even if one of them has shut the node down
  {
    Entry entry = taken.front();
    taken.pop_front();
    if (entry.callback->ready())
      entry.callback->call();
    else
      addCallback(entry.callback, entry.owner);
  }
}

CallbackQueue* getGlobalCallbackQueue() { return &node().queue; }

// --- spinners (source: spinner.cpp) ---

namespace
{
// Whoever spins a queue: several threads, or the one that makes this.
class Spun
{
public:
  Spun(CallbackQueue* queue, bool is_single, const std::string& who) : queue_(queue)
  {
    std::thread::id thread = is_single ? std::this_thread::get_id() : std::thread::id();
    auto& [count, other] = node().spun.try_emplace(queue, 0, thread).first->second;
    if (other != thread)
    {
      std::string said = who + "Attempt to spin a callback queue from two spinners, one of them being single-threaded.";
      if (is_single)
        said += " You might want to use a MultiThreadedSpinner instead.";
      ROS_FATAL_STREAM(said);
      throw std::runtime_error(said);
    }
    count++;
  }
  ~Spun()
  {
    if (auto found = node().spun.find(queue_); --found->second.first == 0)
      node().spun.erase(found);
  }

private:
  CallbackQueue* queue_;
};

// Until when whoever spins waits, from now. It looks up every 0.1 s, which shows only in how long it takes to end.
rosspin::Due until_look(const std::optional<Spun>& spun)
{
  return [&spun, begun = rosspin::detail::time()]
  {
    constexpr std::int64_t period = 100'000'000;
    if (spun && node().ok)
      return rosspin::never;
    std::int64_t periods = (rosspin::detail::time() - begun + period - 1) / period;
    return begun + std::max<std::int64_t>(periods, 1) * period;
  };
}
}  // namespace

namespace detail
{
struct Spinning
{
  std::size_t count;
  CallbackQueue* queue;
  NodeHandle handle;
  std::optional<Spun> spun;
  std::vector<std::thread> threads;
  ~Spinning() { stop(); }

  void start()
  {
    if (spun)
      return;
    spun.emplace(queue, false, "AsyncSpinnerImpl: ");
    auto call = [this]
    {
      while (spun && handle.ok())
        if (count == 1)
          queue->callAvailable(until_look(spun));
        else
          queue->callOne(until_look(spun));
    };
    while (threads.size() < count)
      threads.emplace_back(call);
  }

  void stop()
  {
    spun.reset();
    rosspin::stir();
    for (std::thread& each : threads)
      each.join();
    threads.clear();
  }
};
}  // namespace detail

// Without a number of threads there are 4, not as many as there are processors.
AsyncSpinner::AsyncSpinner(std::uint32_t threads, CallbackQueue* queue)
  : spinning_(new detail::Spinning{threads ? threads : 4, queue ? queue : getGlobalCallbackQueue()})
{
}

bool AsyncSpinner::canStart() { return true; }

void AsyncSpinner::start() { spinning_->start(); }

void AsyncSpinner::stop() { spinning_->stop(); }

void MultiThreadedSpinner::spin(CallbackQueue* queue)
{
  AsyncSpinner spinner(threads_, queue);
  spinner.start();
  rosspin::Ticking::leave_loops();
  waitForShutdown();
}

void SingleThreadedSpinner::spin(CallbackQueue* queue)
{
  if (!queue)
    queue = getGlobalCallbackQueue();
  std::optional<Spun> spun(std::in_place, queue, true, "SingleThreadedSpinner: ");
  rosspin::spins();
  rosspin::Ticking::leave_loops();
  while (ok())
    queue->callAvailable(until_look(spun));
}

void spin()
{
  SingleThreadedSpinner spinner;
  spinner.spin();
}

void spin(Spinner& spinner) { spinner.spin(); }

void spinOnce() { node().queue.callAvailable(); }

// --- timers (source: timer_manager.h) ---

namespace detail
{
struct TimerImpl::Run : CallbackInterface
{
  TimerImpl* timer;  // null once it was stopped
  std::int64_t last_expected = 0, last_real = 0, last_expired = 0, next = 0, expired = 0, duration = 0;
  bool waits = true;  // for its time; otherwise in the queue, or being called
  bool is_called = false;
  std::uint64_t order;
  CallResult call() override;
  // How far its clock is ahead of the run's time, unless it is what /clock tells, so that its future is unknown.
  std::int64_t ahead() const { return timer->clock_ == time_of<SteadyTime> ? 0 : rosspin::detail::ahead(); }
  bool is_told() const { return timer->clock_ == time_of<Time> && node().told; }
  std::int64_t time() const { return is_told() ? *node().told : rosspin::detail::time() + ahead(); }
  // When it is due, in the run's time, which is `now`; never while it does not wait.
  std::int64_t due(std::int64_t now) const
  {
    if (!waits)
      return rosspin::never;
    if (is_told())
      return *node().told >= next ? now - (*node().told - next) : rosspin::never;
    return next - ahead();
  }
  void fire(const CallbackInterfacePtr& self)
  {
    waits = false;
    expired = time();
    timer->queue_->addCallback(self, order);
  }
  void go_back()
  {
    if (std::int64_t now = time(); now < last_expected)
    {
      last_expected = now;
      next = now + timer->period;
    }
  }
  // When the call is due after one that was due at `due` and has returned now.
  std::int64_t after(std::int64_t due, std::int64_t now) const
  {
    std::int64_t next = due <= now ? due + timer->period : due;
    return next + timer->period < now ? now : next;
  }
};
}  // namespace detail

namespace
{
struct Timers
{
  std::vector<boost::shared_ptr<detail::TimerImpl::Run>> runs;
  std::uint64_t count = 0;
  bool gone = false;
};

Timers& timers()
{
  static Timers* all = nullptr;
  return *(all ? all : all = new Timers);
}

// As roscpp's timer manager, it is made with the first timer, so it is gone before a global timer ends.
struct Manager
{
  ~Manager() { timers().gone = true; }
};

// Call those that are due, and return when the next one is.
std::int64_t call_due_timers()
{
  std::int64_t now = rosspin::detail::time();
  for (;;)
  {
    const boost::shared_ptr<detail::TimerImpl::Run>* first = nullptr;
    std::int64_t when = rosspin::never;
    for (const auto& run : timers().runs)
      if (std::int64_t due = run->due(now); due < when)
      {
        when = due;
        first = &run;
      }
    if (when > now)
      return when;
    boost::shared_ptr<detail::TimerImpl::Run> run = *first;
    run->fire(run);
  }
}
}  // namespace

void Time::setNow(const Time& now)
{
  auto& told = node().told;
  auto before = std::exchange(told, now.toNSec());
  if (before > told)
    for (const auto& run : timers().runs)
      run->go_back();
  rosspin::stir();
}

namespace detail
{
TimerImpl::TimerImpl(std::int64_t period, std::function<void(const Called&)> callback, const std::string& name,
    Tracked tracked, CallbackQueueInterface* queue, bool oneshot, std::int64_t (*clock)())
  : period(period), callback_(std::make_shared<const std::function<void(const Called&)>>(std::move(callback))),
    name_(name), tracked_(std::move(tracked)), queue_(queue), oneshot_(oneshot), clock_(clock)
{
}

void TimerImpl::start()
{
  if (started)
    return;
  started = true;
  rosspin::await_spin();
  static Manager manager;
  tick_as(name_, period);
  run_ = boost::make_shared<Run>();
  run_->timer = this;
  run_->order = ++timers().count;
  run_->last_expected = run_->time();
  run_->next = run_->last_expected + period;
  timers().runs.push_back(run_);
  rosspin::stir();
}

TimerImpl::~TimerImpl()
{
  if (started)
    lose();
  end();
}

void TimerImpl::stop()
{
  rosspin::await_spin(-started);
  end();
}

void TimerImpl::end()
{
  if (!started)
    return;
  if (timers().gone)
  {
    rosspin::write(2, "terminate called after throwing an instance of 'boost::wrapexcept<boost::lock_error>'\n"
                      "  what():  boost: mutex lock failed in pthread_mutex_lock: Invalid argument\n");
    std::abort();
  }
  started = false;
  run_->timer = nullptr;
  queue_->removeByID(run_->order);
  auto& runs = timers().runs;
  runs.erase(std::find(runs.begin(), runs.end(), run_));
  run_.reset();
}

bool TimerImpl::pending() const
{
  // A one-shot timer has nothing to come once it has called.
  return started && !(oneshot_ && run_->next == rosspin::never);
}

void TimerImpl::set_period(std::int64_t new_period, bool reset)
{
  if (started)
  {
    std::int64_t now = run_->time(), elapsed = now - run_->last_real;
    if (reset)
      run_->next = now + new_period;
    else if (elapsed < period)
      run_->next = elapsed > new_period ? now : run_->last_real + new_period;
  }
  period = new_period;
  rosspin::stir();
}

std::vector<std::pair<std::int64_t, std::int64_t>> TimerImpl::coming() const
{
  std::vector<std::pair<std::int64_t, std::int64_t>> found;
  if (!started || !pending() || period <= 0 || (oneshot_ && run_->is_called) || run_->is_told())
    return found;
  std::int64_t now = run_->time(), ahead = now - rosspin::now(), next = run_->next;
  if (run_->is_called)
    next = run_->after(next, now);
  for (;; next = run_->after(next, now))
  {
    found.emplace_back(next - ahead, std::max(next, now) - ahead);
    if (next > now)
      return found;
  }
}

// A timer waits again only after its callback has returned. Its next call is due one period after the last one was; if
// even the one after that would have been due already, it is due now.
CallbackInterface::CallResult TimerImpl::Run::call()
{
  auto self = timer;
  VoidConstPtr held;
  if (!self || !self->tracked_.lives(held))
    return Invalid;
  Called called;
  called.last_expected = last_expected;
  called.last_real = last_real;
  called.last_expired = last_expired;
  called.expected = next;
  called.real = time();
  called.expired = expired;
  called.duration = duration;
  std::int64_t begun = rosspin::detail::time();
  std::int64_t ahead = called.real - begun;
  std::int64_t tick = self->begin_tick(called.expected - ahead, begun);
  auto callback = self->callback_;  // the timer may be destroyed meanwhile
  is_called = true;
  (*callback)(called);
  is_called = false;
  call_due_timers();  // others that became due meanwhile come first
  duration = rosspin::detail::time() - begun;
  TimerImpl::end_tick(tick, duration);
  if (!timer)
    return Success;
  last_real = called.real;
  last_expired = called.expired;
  std::int64_t now = time();
  if (timer->oneshot_)
  {
    next = rosspin::never;
  }
  else
  {
    if (next <= now)
      last_expected = next;
    next = after(next, now);
  }
  waits = next != rosspin::never;
  return Success;
}

// --- topics (sources: publication.cpp, subscription_queue.cpp) ---

PublicationImpl::PublicationImpl(
    const std::string& topic, const AdvertiseOptions& options, CallbackQueueInterface* queue)
  : topic(topic), type(options.datatype), latch(options.latch), connect_(options.connect_cb),
    disconnect_(options.disconnect_cb), tracked_(options.tracked_object), queue_(queue)
{
  id_ = rosspin::ask("advertise", {topic, type, std::int64_t(options.queue_size), latch, connect_ || disconnect_}).whole;
  node().publications[id_] = this;
}

void PublicationImpl::end()
{
  if (ended)
    return;
  ended = true;
  node().publications.erase(id_);
  if (!node().ok)
    return;
  queue_->removeByID(reinterpret_cast<std::uintptr_t>(this));
  rosspin::tell("unadvertise", {id_});
}

struct PublicationImpl::StatusCall : CallbackInterface
{
  SubscriberStatusCallback callback;
  Tracked tracked;
  SingleSubscriberPublisher to;
  StatusCall(const SubscriberStatusCallback& callback, const Tracked& tracked, const SingleSubscriberPublisher& to)
    : callback(callback), tracked(tracked), to(to)
  {
  }
  CallResult call() override
  {
    VoidConstPtr held;
    if (tracked.lives(held))
      callback(to);
    return Success;
  }
};

void PublicationImpl::receive(bool connects, const std::string& name, std::int64_t link)
{
  const SubscriberStatusCallback& callback = connects ? connect_ : disconnect_;
  if (!callback)
    return;
  call_due_timers();
  SingleSubscriberPublisher to(topic, name, id_, link);
  queue_->addCallback(
      boost::make_shared<StatusCall>(callback, tracked_, to), reinterpret_cast<std::uintptr_t>(this));
}

void PublicationImpl::publish(const char* of, const std::string& bytes)
{
  if (ended || !node().ok)
    return;
  if (type != of)
  {
    ROS_FATAL("ASSERTION FAILED: Trying to publish message of type [%s] on a publisher with type [%s]", of,
        type.c_str());
    std::abort();
  }
  rosspin::tell("publish", {id_, data_of(bytes)});
}

std::uint32_t PublicationImpl::connections() const
{
  rosspin::look();
  return ended || !node().ok ? 0 : rosspin::ask("subscribers", {id_}).whole;
}

struct SubscriptionImpl::Queue : CallbackInterface
{
  std::list<boost::shared_ptr<Received>> messages;
  std::uint32_t size;
  std::function<void(Received&)> callback;
  Tracked tracked;
  bool ended = false, concurrent = false;
  int calls = 0;  // that still run
  std::thread::id caller;
  bool ready() override { return concurrent || !calls || caller == std::this_thread::get_id(); }
  CallResult call() override
  {
    VoidConstPtr held;
    if (messages.empty() || ended || !tracked.lives(held))
      return Invalid;
    auto message = messages.front();
    messages.pop_front();
    struct Calling
    {
      Queue& queue;
      explicit Calling(Queue& queue) : queue(queue)
      {
        queue.calls++;
        queue.caller = std::this_thread::get_id();
      }
      ~Calling()
      {
        queue.calls--;
        rosspin::stir();
      }
    } calling(*this);
    callback(*message);
    return Success;
  }
};

SubscriptionImpl::SubscriptionImpl(const std::string& topic, const char* type, std::uint32_t queue_size,
    std::function<void(Received&)> callback, Tracked tracked, CallbackQueueInterface* queue, bool concurrent)
  : topic(topic), waiting_(boost::make_shared<Queue>()), queue_(queue)
{
  waiting_->size = queue_size;
  waiting_->callback = std::move(callback);
  waiting_->tracked = std::move(tracked);
  waiting_->concurrent = concurrent;
  node().subscriptions.push_back(this);
  id_ = rosspin::ask("subscribe", {topic, type}).whole;
}

SubscriptionImpl::~SubscriptionImpl()
{
  if (!ended)
    rosspin::lose(topic);
  end();
  for (const auto* other : node().subscriptions)
    rosspin::regain(other->topic);
}

void SubscriptionImpl::end(bool waits)
{
  if (ended)
    return;
  ended = waiting_->ended = true;
  auto& all = node().subscriptions;
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
  if (node().ok)
    rosspin::tell("unsubscribe", {id_});
  auto waiting = waiting_;
  while (waits && !waiting->ready())  // another thread is still calling back
    rosspin::wait(rosspin::never);
}

std::uint32_t SubscriptionImpl::connections() const
{
  rosspin::look();
  return ended || !node().ok ? 0 : rosspin::ask("publishers", {id_}).whole;
}

// The oldest message makes room for the newest; the next one takes its place in the queue of callbacks.
void SubscriptionImpl::receive(const boost::shared_ptr<Received>& message)
{
  call_due_timers();
  if (waiting_->size && waiting_->messages.size() >= waiting_->size)
  {
    waiting_->messages.pop_front();
    waiting_->messages.push_back(message);
    return;
  }
  waiting_->messages.push_back(message);
  queue_->addCallback(waiting_, reinterpret_cast<std::uintptr_t>(this));
}

// --- services (sources: service_publication.cpp, service_client.cpp, service_server_link.cpp, service.cpp) ---

namespace
{
constexpr std::int64_t find_service = 3'000'000;  // how long it takes, as for rospy's stand-in
}  // namespace

struct ServiceImpl::Call : CallbackInterface
{
  Asked asked;
  boost::shared_ptr<Answer> answer;
  Tracked tracked;
  CallResult call() override
  {
    VoidConstPtr held;
    std::string response;
    bool ok = false;
    if (*answer && tracked.lives(held))
      try
      {
        ok = (*answer)(asked, response);
        if (!ok)
          response.clear();
      }
      catch (const std::exception& error)
      {
        response = error.what();
        ROS_ERROR("Exception thrown while processing service call: %s", error.what());
      }
    rosspin::tell("respond", {asked.number, ok, data_of(response)});
    return Success;
  }
};

ServiceImpl::ServiceImpl(const std::string& name, const char* request_type, Answer answer, Tracked tracked,
    CallbackQueueInterface* queue)
  : name(name), answer_(boost::make_shared<Answer>(std::move(answer))), tracked_(std::move(tracked)), queue_(queue)
{
  rosspin::ask("advertise_service", {name, request_type});
  node().services[name] = this;
}

void ServiceImpl::end()
{
  if (ended)
    return;
  ended = true;
  *answer_ = nullptr;
  node().services.erase(name);
  if (node().ok)
    rosspin::tell("unadvertise_service", {name});
}

void ServiceImpl::receive(const Asked& request)
{
  call_due_timers();
  auto call = boost::make_shared<Call>();
  call->asked = request;
  call->answer = answer_;
  call->tracked = tracked_;
  queue_->addCallback(call, reinterpret_cast<std::uintptr_t>(this));
}

ClientImpl::ClientImpl(const std::string& name, bool persistent) : name(name), persistent(persistent)
{
  static std::int64_t count = 0;
  id_ = count++;
}

bool ClientImpl::call(const char* request_type, const std::string& request, std::string& response)
{
  Node& self = node();
  if (ended || !self.ok)
    return false;
  if (!connected || !persistent)
    rosspin::sleep_until(rosspin::now() + find_service);
  std::int64_t number = self.calls++;
  rosspin::tell("call", {number, id_, persistent, name, request_type, data_of(request)});
  while (self.ok && !self.responses.count(number))
    rosspin::wait(rosspin::never);
  auto found = self.responses.find(number);
  if (found == self.responses.end())
    return false;
  rosspin::Value values = found->second;
  self.responses.erase(found);
  connected = values.items[1].flag;
  bool ok = values.items[2].flag;
  response = values.items[3].string;
  if (!ok && !response.empty())
    ROS_ERROR("Service call failed: service [%s] responded with an error: %s", name.c_str(), response.c_str());
  return ok;
}

// --- parameters ---

bool read(const rosspin::Value& value, std::string& out)
{
  if (value.kind != rosspin::Value::text)
    return false;
  out = value.string;
  return true;
}

bool read(const rosspin::Value& value, double& out)
{
  if (value.kind == rosspin::Value::integer)
    out = static_cast<double>(value.whole);
  else if (value.kind == rosspin::Value::real)
    out = value.number;
  else
    return false;
  return true;
}

bool read(const rosspin::Value& value, float& out)
{
  double wide;
  if (!read(value, wide))
    return false;
  out = static_cast<float>(wide);
  return true;
}

bool read(const rosspin::Value& value, int& out)
{
  if (value.kind == rosspin::Value::integer)
    out = static_cast<int>(value.whole);
  else if (value.kind == rosspin::Value::real)
    out = static_cast<int>(std::fmod(value.number, 1.0) < 0.5 ? std::floor(value.number) : std::ceil(value.number));
  else
    return false;
  return true;
}

bool read(const rosspin::Value& value, bool& out)
{
  if (value.kind != rosspin::Value::boolean)
    return false;
  out = value.flag;
  return true;
}
}  // namespace detail

namespace param
{
bool get(const std::string& name, rosspin::Value& value)
{
  rosspin::look();
  value = rosspin::ask("get_param", {names::resolve(name)});
  return value.kind != rosspin::Value::nothing;
}

void set_value(const std::string& name, const rosspin::Value& value)
{
  rosspin::ask("set_param", {names::resolve(name), value});
}

bool has(const std::string& name)
{
  rosspin::look();
  return rosspin::ask("has_param", {names::resolve(name)}).flag;
}

bool del(const std::string& name) { return rosspin::ask("delete_param", {names::resolve(name)}).flag; }

bool search(const std::string& ns, const std::string& name, std::string& found)
{
  return detail::read(rosspin::ask("search_param", {ns, name}), found);
}

bool search(const std::string& name, std::string& found) { return search(this_node::getName(), name, found); }

bool getParamNames(V_string& names) { return detail::read(rosspin::ask("param_names"), names); }
}  // namespace param

// --- node handles (source: node_handle.cpp) ---

NodeHandle::NodeHandle(const std::string& ns, const M_string& remappings) : remappings_(remappings)
{
  std::string whole = !ns.empty() && ns[0] == '~' ? names::resolve(ns) : ns;
  unresolved_ = whole;
  construct(whole);
}

NodeHandle::NodeHandle(const NodeHandle& other)
  : unresolved_(other.unresolved_), remappings_(other.remappings_), queue_(other.queue_)
{
  construct(other.namespace_);
  unresolved_ = other.unresolved_;
}

NodeHandle::NodeHandle(const NodeHandle& parent, const std::string& ns, const M_string& remappings)
  : remappings_(remappings), queue_(parent.queue_)
{
  unresolved_ = ns;
  construct(parent.resolveName(ns));
}

NodeHandle& NodeHandle::operator=(const NodeHandle& other)
{
  namespace_ = other.namespace_;
  unresolved_ = other.unresolved_;
  remappings_ = other.remappings_;
  queue_ = other.queue_;
  return *this;
}

void NodeHandle::construct(const std::string& ns)
{
  if (!isInitialized())
  {
    ROS_FATAL("You must call ros::init() before creating the first NodeHandle");
    std::abort();
  }
  namespace_ = names::resolve(ns, true);
  if (node().handles++ == 0)
  {
    rosspin::regain("node");
    start();
  }
}

// The last handle to go shuts the node down.
NodeHandle::~NodeHandle()
{
  if (--node().handles == 0)
  {
    rosspin::lose("node");
    ros::shutdown();
  }
}

std::string NodeHandle::resolveName(const std::string& name, bool remap) const
{
  std::string error;
  if (!names::validate(name, error))
    throw InvalidNameException(error);
  if (name.empty())
    return namespace_;
  if (name[0] == '~')
    throw InvalidNameException("Using ~ names with NodeHandle methods is not allowed.  If you want to use private names "
                               "with the NodeHandle interface, construct a NodeHandle using a private name as its "
                               "namespace.  e.g. ros::NodeHandle nh(\"~\");  nh.getParam(\"my_private_name\"); (name = [" +
                               name + "])");
  std::string whole = name[0] == '/' ? names::clean(name) : names::append(namespace_, name);
  return remap ? names::resolve(whole, true) : names::resolve(whole, false);
}

void NodeHandle::shutdown()
{
  for (const auto& each : kept_)
    if (auto one = each.lock())
      one->end();
  ok_ = false;
}

void NodeHandle::keep(const boost::shared_ptr<detail::Kept>& one)
{
  kept_.erase(std::remove_if(kept_.begin(), kept_.end(), [](const auto& each) { return each.expired(); }), kept_.end());
  kept_.push_back(one);
}

Publisher NodeHandle::advertise(AdvertiseOptions& options)
{
  options.topic = resolveName(options.topic);
  auto impl = boost::make_shared<detail::PublicationImpl>(
      options.topic, options, options.callback_queue ? options.callback_queue : getCallbackQueue());
  keep(impl);
  return Publisher(impl);
}

Subscriber NodeHandle::subscribed(const std::string& topic, const char* type, std::uint32_t queue_size,
    std::function<void(detail::Received&)> receive, const VoidConstPtr& tracked, CallbackQueueInterface* queue,
    bool concurrent)
{
  auto impl = boost::make_shared<detail::SubscriptionImpl>(resolveName(topic), type, queue_size, std::move(receive),
      detail::Tracked(tracked), queue ? queue : getCallbackQueue(), concurrent);
  keep(impl);
  rosspin::await_spin();
  rosspin::regain(impl->topic);
  return Subscriber(impl);
}

ServiceServer NodeHandle::advertiseService(AdvertiseServiceOptions& options)
{
  std::string name = resolveName(options.service);
  if (node().services.count(name))
  {
    ROS_ERROR("Tried to advertise a service that is already advertised in this node [%s]", name.c_str());
    return ServiceServer();
  }
  auto impl = boost::make_shared<detail::ServiceImpl>(name, options.datatype, options.answer,
      detail::Tracked(options.tracked_object), options.callback_queue ? options.callback_queue : getCallbackQueue());
  keep(impl);
  rosspin::await_spin();
  return ServiceServer(impl);
}

ServiceClient NodeHandle::client(const std::string& name, bool persistent)
{
  auto impl = boost::make_shared<detail::ClientImpl>(resolveName(name), persistent);
  keep(impl);
  return ServiceClient(impl);
}

bool ServiceClient::exists() { return impl_ && service::exists(impl_->name, false); }

bool ServiceClient::waitForExistence(Duration timeout) { return impl_ && service::waitForService(impl_->name, timeout); }

namespace service
{
bool exists(const std::string& name, bool print_failure_reason)
{
  std::string whole = names::resolve(name);
  rosspin::look();
  bool found = node().ok && rosspin::ask("service_exists", {whole}).flag;
  if (!found && print_failure_reason)
    ROS_INFO("waitForService: Service [%s] has not been advertised, waiting...", whole.c_str());
  return found;
}

bool waitForService(const std::string& name, Duration timeout)
{
  bool printed = false, found = false;
  Time begun = Time::now();
  while (ok() && !(found = exists(name, !printed)))
  {
    printed = true;
    if (timeout >= Duration(0) && Time::now() - begun >= timeout)
      return false;
    Duration(0.02).sleep();
  }
  if (printed && ok())
    ROS_INFO("waitForService: Service [%s] is now available.", names::resolve(name).c_str());
  return found;
}
}  // namespace service

namespace master
{
bool getTopics(V_TopicInfo& topics)
{
  rosspin::look();
  topics.clear();
  for (const rosspin::Value& each : rosspin::ask("topics").items)
    topics.push_back({each.items[0].string, each.items[1].string});
  return true;
}

bool getNodes(V_string& nodes)
{
  rosspin::look();
  nodes.clear();
  return detail::read(rosspin::ask("nodes"), nodes);
}
}  // namespace master

void SingleSubscriberPublisher::send(const std::string& bytes) const
{
  if (node().ok)
    rosspin::tell("publish_to", {publication_, link_, data_of(bytes)});
}

void Publisher::send(const char* type, const std::string& bytes) const
{
  if (!impl_ || impl_->ended)
  {
    ROS_FATAL("ASSERTION FAILED\n\tCall to publish() on an invalid Publisher");
    std::abort();
  }
  impl_->publish(type, bytes);
}
}  // namespace ros

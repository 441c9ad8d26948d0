// message_filters of both ROSes (sources: message_filters/*.h of each). Each ROS says what its times and subscriptions are.
#ifndef ROSSPIN_FILTERS_HPP
#define ROSSPIN_FILTERS_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#if __has_include("ros/ros.h")
#include "ros/filters.h"
#else
#include "rclcpp/filters.hpp"
#endif

namespace message_filters
{
class Connection
{
public:
  Connection() = default;
  explicit Connection(std::function<void()> disconnect) : disconnect_(std::move(disconnect)) {}
  void disconnect()
  {
    if (auto function = std::exchange(disconnect_, nullptr))
      function();
  }

private:
  std::function<void()> disconnect_;
};

namespace detail
{
template<class M>
using ConstPtr = std::shared_ptr<M const>;

// What a callback's parameter P is given of a message.
template<class P, class M>
std::decay_t<P> passed(const Event<M>& event)
{
  typedef std::decay_t<P> T;
  if constexpr (std::is_same_v<T, std::shared_ptr<M>>)
    return std::make_shared<M>(*event.getConstMessage());
  else if constexpr (std::is_same_v<T, ConstPtr<M>>)
    return event.getConstMessage();
  else if constexpr (std::is_constructible_v<T, const Event<M>&>)
    return T(event);
  else
    return *event.getConstMessage();
}

// Functions that are called with messages, one of each of the types.
template<class... M>
class Calls
{
public:
  typedef std::function<void(const Event<M>&...)> Call;

  template<class C>
  Connection add(C callback)
  {
    auto all = all_;
    auto at = all->insert(all->end(), of(std::move(callback)));
    return Connection([all, at] { all->erase(at); });
  }
  template<class C, class T>
  Connection add(C member, T* object)
  {
    return add(bound(member, object));
  }
  void call(const Event<M>&... events) const
  {
    for (const Call& each : std::list<Call>(*all_))
      each(events...);
  }

private:
  template<class R, class... P>
  static Call of(R (*callback)(P...))
  {
    return of(std::function<void(P...)>(callback));
  }
  template<class... P>
  static Call of(std::function<void(P...)> callback)
  {
    return [callback](const Event<M>&... events) { callback(passed<P, M>(events)...); };
  }
  template<class C>
  static Call of(C callback)
  {
    return [callback](const Event<M>&... events) mutable
    {
      if constexpr (std::is_invocable_v<C&, const ConstPtr<M>&...>)
        callback(events.getConstMessage()...);
      else
        callback(events...);
    };
  }
  template<class R, class C, class T, class... P>
  static std::function<void(P...)> bound(R (C::*member)(P...), T* object)
  {
    return [=](P... messages) { (object->*member)(messages...); };
  }
  template<class R, class C, class T, class... P>
  static std::function<void(P...)> bound(R (C::*member)(P...) const, T* object)
  {
    return [=](P... messages) { (object->*member)(messages...); };
  }
  std::shared_ptr<std::list<Call>> all_ = std::make_shared<std::list<Call>>();
};

struct Stamped
{
  std::int64_t stamp = 0;  // ns
  std::shared_ptr<void const> event;
};
typedef std::function<void(const std::vector<Stamped>&)> Use;

struct ByStamp
{
  template<class M>
  static std::int64_t stamp_of(const M& message)
  {
    return ns(detail::stamp_of(message));
  }
};

// Messages with the same stamp belong together.
class Exact : public ByStamp
{
public:
  Exact(std::size_t count, std::size_t size) : count_(count), size_(size) {}
  void add(std::size_t number, const Stamped& one, const Use& pass, const Use& drop)
  {
    auto& found = waiting_.try_emplace(one.stamp, count_).first->second;
    found[number] = one;
    if (std::all_of(found.begin(), found.end(), [](const Stamped& each) { return each.event != nullptr; }))
    {
      pass(found);
      waiting_.erase(one.stamp);
      while (!waiting_.empty() && waiting_.begin()->first <= one.stamp)
        drop_first(drop);
    }
    while (size_ && waiting_.size() > size_)
      drop_first(drop);
  }

private:
  void drop_first(const Use& drop)
  {
    drop(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
  }
  std::size_t count_, size_;
  std::map<std::int64_t, std::vector<Stamped>> waiting_;
};

// Messages belong together whose stamps are as near to each other as they can be. A set is searched for around the latest
// of the first messages, the pivot, and is passed on once nothing that may still come could be better.
class Approximate : public ByStamp
{
public:
  Approximate(std::size_t count, std::size_t size) : topics_(count), size_(size) {}
  void add(std::size_t number, const Stamped& one, const Use& pass, const Use&)
  {
    Topic& topic = topics_[number];
    topic.waiting.push_back(one);
    if (topic.waiting.size() == 1)
      search(pass);
    else
      check(number);
    if (topic.waiting.size() + topic.past.size() <= size_)
      return;
    for (Topic& each : topics_)
      each.recover(each.past.size());
    topic.waiting.pop_front();
    topic.has_dropped = true;
    if (pivot_ < 0)
      return;
    pivot_ = -1;
    search(pass);
  }
  double penalty = 0.1;
  std::int64_t most = INT64_MAX;
  void set_bound(std::size_t number, std::int64_t bound) { topics_[number].bound = bound; }
  void set_bound(std::int64_t bound)
  {
    for (Topic& each : topics_)
      each.bound = bound;
  }

private:
  struct Topic
  {
    std::deque<Stamped> waiting;
    std::vector<Stamped> past;  // looked at for the present pivot
    std::int64_t bound = 0;  // the least time from one message to the next
    bool has_dropped = false, has_warned = false;
    void move_on()
    {
      past.push_back(waiting.front());
      waiting.pop_front();
    }
    void recover(std::size_t count)
    {
      for (; count > 0; count--)
      {
        waiting.push_front(past.back());
        past.pop_back();
      }
    }
  };

  bool is_complete() const
  {
    return std::none_of(topics_.begin(), topics_.end(), [](const Topic& each) { return each.waiting.empty(); });
  }

  // When the next message of a topic is, or could be.
  std::int64_t next(const Topic& topic) const
  {
    if (!topic.waiting.empty())
      return topic.waiting.front().stamp;
    return std::max(topic.past.back().stamp + topic.bound, pivot_time_);
  }

  // Find the topics whose next messages are the first and the last; of those at the same time the first, and the last.
  void find_ends(std::size_t& first, std::size_t& last) const
  {
    first = last = 0;
    for (std::size_t each = 1; each < topics_.size(); each++)
    {
      if (next(topics_[each]) < next(topics_[first]))
        first = each;
      if (next(topics_[each]) >= next(topics_[last]))
        last = each;
    }
  }

  // Whether a set that ends at a time is no better than the candidate, if it begins so much later.
  bool is_no_better(std::int64_t end, std::int64_t later) const
  {
    return std::floor(static_cast<double>(end - candidate_end_) * (1 + penalty) + 0.5) >= static_cast<double>(later);
  }

  void check(std::size_t number)
  {
    Topic& topic = topics_[number];
    std::int64_t gap = topic.waiting.back().stamp - topic.waiting[topic.waiting.size() - 2].stamp;
    if (gap >= 0 && gap >= topic.bound)
      return;
    if (!std::exchange(topic.has_warned, true))
      warn(static_cast<int>(number), gap, topic.bound);
  }

  void take(std::int64_t start, std::int64_t end)
  {
    candidate_.clear();
    for (Topic& each : topics_)
    {
      candidate_.push_back(each.waiting.front());
      each.past.clear();
    }
    candidate_start_ = start;
    candidate_end_ = end;
  }

  void pass_on(const Use& pass)
  {
    pass(candidate_);
    pivot_ = -1;
    for (Topic& each : topics_)
    {
      each.recover(each.past.size());
      each.waiting.pop_front();
    }
  }

  void search(const Use& pass)
  {
    while (is_complete())
    {
      std::size_t first, last;
      find_ends(first, last);
      std::int64_t start = next(topics_[first]), end = next(topics_[last]);
      for (std::size_t each = 0; each < topics_.size(); each++)
        if (each != last)
          topics_[each].has_dropped = false;
      if (pivot_ < 0)
      {
        if (end - start > most || topics_[last].has_dropped)
        {
          topics_[first].waiting.pop_front();
          continue;
        }
        take(start, end);
        pivot_ = static_cast<int>(last);
        pivot_time_ = end;
      }
      else if (!is_no_better(end, start - candidate_start_))
      {
        take(start, end);
      }
      topics_[first].move_on();
      if (static_cast<int>(first) == pivot_ || is_no_better(end, pivot_time_ - candidate_start_))
        pass_on(pass);
      else if (!is_complete())
        look_ahead(pass);
    }
  }

  // Pass the candidate on if the messages that lack cannot make a better one, however early they come.
  void look_ahead(const Use& pass)
  {
    std::vector<std::size_t> moved(topics_.size());
    for (;;)
    {
      std::size_t first, last;
      find_ends(first, last);
      std::int64_t start = next(topics_[first]), end = next(topics_[last]);
      if (is_no_better(end, pivot_time_ - candidate_start_))
        return pass_on(pass);
      if (!is_no_better(end, start - candidate_start_))
        break;
      topics_[first].move_on();
      moved[first]++;
    }
    for (std::size_t each = 0; each < topics_.size(); each++)
      topics_[each].recover(moved[each]);
  }

  std::vector<Topic> topics_;
  std::size_t size_;
  std::vector<Stamped> candidate_;
  std::int64_t candidate_start_ = 0, candidate_end_ = 0, pivot_time_ = 0;
  int pivot_ = -1;  // a topic, while there is a candidate
};

// What policies have in common: the messages, of which some belong together, and who is told of these.
template<class Matcher, class... M>
class Policy
{
public:
  typedef std::tuple<M...> Messages;
  typedef std::tuple<Event<M>...> Events;

  explicit Policy(std::uint32_t queue_size) : matcher_(sizeof...(M), queue_size) {}

  template<int number>
  void add(const std::tuple_element_t<number, Events>& event)
  {
    std::lock_guard<std::mutex> lock(*mutex_);
    Stamped one{matcher_.stamp_of(*event.getConstMessage()),
        std::make_shared<std::tuple_element_t<number, Events>>(event)};
    auto indices = std::index_sequence_for<M...>();
    matcher_.add(number, one, [&](const std::vector<Stamped>& found) { call(passes_, found, indices); },
        [&](const std::vector<Stamped>& found) { call(drops_, found, indices); });
  }

protected:
  Matcher matcher_;
  Calls<M...> passes_, drops_;

private:
  template<std::size_t... number>
  static void call(const Calls<M...>& calls, const std::vector<Stamped>& found, std::index_sequence<number...>)
  {
    static const std::tuple<Event<M>...> none;
    calls.call((found[number].event ? *static_cast<const Event<M>*>(found[number].event.get())
                                    : std::get<number>(none))...);
  }
  std::shared_ptr<std::mutex> mutex_ = std::make_shared<std::mutex>();
};
}  // namespace detail

template<class M>
class SimpleFilter
{
public:
  typedef detail::ConstPtr<M> MConstPtr;
  typedef detail::Event<M> EventType;
  typedef std::function<void(const MConstPtr&)> Callback;
  typedef std::function<void(const EventType&)> EventCallback;

  SimpleFilter() = default;
  SimpleFilter(const SimpleFilter&) = delete;
  SimpleFilter& operator=(const SimpleFilter&) = delete;
  template<class C>
  Connection registerCallback(const C& callback)
  {
    return calls_.add(std::decay_t<C>(callback));
  }
  template<class C, class T>
  Connection registerCallback(C callback, T* object)
  {
    return calls_.add(callback, object);
  }
  void setName(const std::string& name) { name_ = name; }
  const std::string& getName() { return name_; }

protected:
  void signalMessage(const MConstPtr& message) { calls_.call(EventType(message)); }
  void signalMessage(const EventType& event) { calls_.call(event); }

private:
  detail::Calls<M> calls_;
  std::string name_;
};

// Passes on what it is given.
template<class M>
class PassThrough : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;
  PassThrough() = default;
  template<class F>
  explicit PassThrough(F& filter)
  {
    connectInput(filter);
  }
  ~PassThrough() { input_.disconnect(); }
  template<class F>
  void connectInput(F& filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback(
        typename SimpleFilter<M>::EventCallback([this](const EventType& event) { add(event); }));
  }
  void add(const MConstPtr& message) { add(EventType(message)); }
  void add(const EventType& event) { this->signalMessage(event); }

private:
  Connection input_;
};

// Passes on what it is given, and keeps the last messages, sorted by their stamps.
template<class M>
class Cache : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;
  typedef detail::Time Time;

  explicit Cache(unsigned size = 1) { setCacheSize(size); }
  template<class F>
  explicit Cache(F& filter, unsigned size = 1) : Cache(size)
  {
    connectInput(filter);
  }
  ~Cache() { input_.disconnect(); }
  template<class F>
  void connectInput(F& filter)
  {
    input_ = filter.registerCallback(
        typename SimpleFilter<M>::EventCallback([this](const EventType& event) { add(event); }));
  }
  void setCacheSize(unsigned size)
  {
    if (size)
      size_ = size;
  }
  void add(const MConstPtr& message) { add(EventType(message)); }
  void add(const EventType& event)
  {
    while (kept_.size() >= size_)
      kept_.pop_front();
    auto at = kept_.end();
    for (Time stamp = stamp_of(event.getConstMessage()); at != kept_.begin() && stamp_of(*std::prev(at)) > stamp;)
      at--;
    kept_.insert(at, event.getConstMessage());
    this->signalMessage(event);
  }
  std::vector<MConstPtr> getInterval(const Time& start, const Time& end) const
  {
    std::vector<MConstPtr> found;
    for (const MConstPtr& each : kept_)
      if (stamp_of(each) >= start && stamp_of(each) <= end)
        found.push_back(each);
    return found;
  }
  std::vector<MConstPtr> getSurroundingInterval(const Time& start, const Time& end) const
  {
    if (kept_.empty())
      return {};
    std::size_t first = kept_.size() - 1;
    while (first > 0 && stamp_of(kept_[first]) > start)
      first--;
    std::size_t last = first;
    while (last < kept_.size() - 1 && stamp_of(kept_[last]) < end)
      last++;
    return {kept_.begin() + first, kept_.begin() + last + 1};
  }
  MConstPtr getElemBeforeTime(const Time& time) const
  {
    MConstPtr found;
    for (auto each = kept_.begin(); each != kept_.end() && stamp_of(*each) < time; each++)
      found = *each;
    return found;
  }
  MConstPtr getElemAfterTime(const Time& time) const
  {
    MConstPtr found;
    for (auto each = kept_.rbegin(); each != kept_.rend() && stamp_of(*each) > time; each++)
      found = *each;
    return found;
  }
  Time getLatestTime() const { return kept_.empty() ? Time() : stamp_of(kept_.back()); }
  Time getOldestTime() const { return kept_.empty() ? Time() : stamp_of(kept_.front()); }

private:
  static Time stamp_of(const MConstPtr& message) { return detail::stamp_of(*message); }
  std::deque<MConstPtr> kept_;
  std::size_t size_ = 1;
  Connection input_;
};

// Passes messages on in the order of their stamps, once they are older than `delay`: it looks each `period`. One that is
// older than what was passed on is dropped.
template<class M>
class TimeSequencer : public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;

  template<class... Node>
  TimeSequencer(detail::Duration delay, detail::Duration period, std::uint32_t size, const Node&... node)
    : delay_(delay), size_(size), timer_(detail::every(period, [this] { update(); }, node...))
  {
  }
  template<class F, class... Node>
  TimeSequencer(F& filter, detail::Duration delay, detail::Duration period, std::uint32_t size, const Node&... node)
    : TimeSequencer(delay, period, size, node...)
  {
    connectInput(filter);
  }
  ~TimeSequencer()
  {
    detail::stop(timer_);
    input_.disconnect();
  }
  template<class F>
  void connectInput(F& filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback(
        typename SimpleFilter<M>::EventCallback([this](const EventType& event) { add(event); }));
  }
  void add(const MConstPtr& message) { add(EventType(message)); }
  void add(const EventType& event)
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (stamp_of(event) < last_)
      return;
    kept_.insert(event);
    if (size_ && kept_.size() > size_)
      kept_.erase(*kept_.begin());  // and all with its stamp
  }

private:
  static detail::Time stamp_of(const EventType& event) { return detail::stamp_of(*event.getConstMessage()); }
  struct Before
  {
    bool operator()(const EventType& one, const EventType& other) const { return stamp_of(one) < stamp_of(other); }
  };
  void update()
  {
    std::vector<EventType> old;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      while (!kept_.empty() && stamp_of(*kept_.begin()) + delay_ <= detail::now())
      {
        old.push_back(*kept_.begin());
        last_ = stamp_of(old.back());
        kept_.erase(kept_.begin());
      }
    }
    for (const EventType& event : old)
      this->signalMessage(event);
  }
  detail::Duration delay_;
  std::uint32_t size_;
  detail::Time last_;
  std::multiset<EventType, Before> kept_;
  std::mutex mutex_;
  detail::Timer timer_;
  Connection input_;
};

class ChainBase
{
public:
  virtual ~ChainBase() = default;
  template<class F>
  std::shared_ptr<F> getFilter(std::size_t index) const
  {
    return std::static_pointer_cast<F>(getFilterForIndex(index));
  }

protected:
  virtual std::shared_ptr<void> getFilterForIndex(std::size_t index) const = 0;
};
typedef std::shared_ptr<ChainBase> ChainBasePtr;

// Filters of which each is given what the one before it passes on.
template<class M>
class Chain : public ChainBase, public SimpleFilter<M>
{
public:
  using typename SimpleFilter<M>::MConstPtr;
  using typename SimpleFilter<M>::EventType;
  Chain() = default;
  template<class F>
  explicit Chain(F& filter)
  {
    connectInput(filter);
  }
  ~Chain() override { input_.disconnect(); }
  template<class F>
  std::size_t addFilter(F* filter)
  {
    return addFilter(std::shared_ptr<F>(filter, [](F*) {}));
  }
  template<class F>
  std::size_t addFilter(const std::shared_ptr<F>& filter)
  {
    auto passes = std::make_shared<PassThrough<M>>(*filter);
    last_.disconnect();
    last_ = passes->registerCallback(Call([this](const EventType& event) { this->signalMessage(event); }));
    if (!links_.empty())
      filter->connectInput(*links_.back().passes);
    links_.push_back({[filter](const EventType& event) { filter->add(event); }, filter, passes});
    return links_.size() - 1;
  }
  template<class F>
  void connectInput(F& filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback(Call([this](const EventType& event) { add(event); }));
  }
  void add(const MConstPtr& message) { add(EventType(message)); }
  void add(const EventType& event)
  {
    if (!links_.empty())
      links_[0].add(event);
  }

private:
  typedef typename SimpleFilter<M>::EventCallback Call;
  struct Link
  {
    Call add;
    std::shared_ptr<void> filter;
    std::shared_ptr<PassThrough<M>> passes;
  };
  std::shared_ptr<void> getFilterForIndex(std::size_t index) const override
  {
    return index < links_.size() ? links_[index].filter : nullptr;
  }
  std::vector<Link> links_;
  Connection input_, last_;
};

// Messages of subscriptions: what its ROS makes of a filter.
template<class M, class... Node>
class Subscriber : public detail::Subscribing<M, SimpleFilter<M>, Node...>
{
public:
  using detail::Subscribing<M, SimpleFilter<M>, Node...>::Subscribing;
};

namespace sync_policies
{
template<class... M>
class ExactTime : public detail::Policy<detail::Exact, M...>
{
public:
  using detail::Policy<detail::Exact, M...>::Policy;
  template<class C>
  Connection registerDropCallback(const C& callback)
  {
    return this->drops_.add(std::decay_t<C>(callback));
  }
  template<class C, class T>
  Connection registerDropCallback(C callback, T* object)
  {
    return this->drops_.add(callback, object);
  }
};

template<class... M>
class ApproximateTime : public detail::Policy<detail::Approximate, M...>
{
public:
  using detail::Policy<detail::Approximate, M...>::Policy;
  void setAgePenalty(double penalty) { this->matcher_.penalty = penalty; }
  void setMaxIntervalDuration(detail::Duration most) { this->matcher_.most = detail::ns(most); }
  void setInterMessageLowerBound(int number, detail::Duration bound)
  {
    this->matcher_.set_bound(static_cast<std::size_t>(number), detail::ns(bound));
  }
  void setInterMessageLowerBound(detail::Duration bound) { this->matcher_.set_bound(detail::ns(bound)); }
};
}  // namespace sync_policies

template<class P>
class Synchronizer : public P
{
public:
  typedef P Policy;
  using P::add;

  Synchronizer(const P& policy) : P(policy) {}
  template<class F0, class F1, class... F>
  Synchronizer(const P& policy, F0& first, F1& second, F&... more) : P(policy)
  {
    connectInput(first, second, more...);
  }
  Synchronizer(const Synchronizer&) = delete;
  Synchronizer& operator=(const Synchronizer&) = delete;
  ~Synchronizer() { disconnect(); }

  template<class... F>
  void connectInput(F&... filters)
  {
    disconnect();
    connect(std::index_sequence_for<F...>(), filters...);
  }
  template<class C>
  Connection registerCallback(const C& callback)
  {
    return this->passes_.add(std::decay_t<C>(callback));
  }
  template<class C, class T>
  Connection registerCallback(C callback, T* object)
  {
    return this->passes_.add(callback, object);
  }
  template<int number>
  void add(const detail::ConstPtr<std::tuple_element_t<number, typename P::Messages>>& message)
  {
    P::template add<number>(std::tuple_element_t<number, typename P::Events>(message));
  }
  P* getPolicy() { return this; }
  void setName(const std::string& name) { name_ = name; }
  const std::string& getName() { return name_; }

private:
  template<std::size_t... number, class... F>
  void connect(std::index_sequence<number...>, F&... filters)
  {
    inputs_ = {filters.registerCallback(std::function<void(const std::tuple_element_t<number, typename P::Events>&)>(
        [this](const std::tuple_element_t<number, typename P::Events>& event) { P::template add<number>(event); }))...};
  }
  void disconnect()
  {
    for (Connection& each : inputs_)
      each.disconnect();
    inputs_.clear();
  }
  std::vector<Connection> inputs_;
  std::string name_;
};

// Its arguments are the filters, if any, and the size of its queue.
template<class... M>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<M...>>
{
public:
  typedef sync_policies::ExactTime<M...> Policy;
  explicit TimeSynchronizer(std::uint32_t queue_size) : Synchronizer<Policy>(Policy(queue_size)) {}
  template<class F, class... More>
  TimeSynchronizer(F& filter, More&&... more)
    : TimeSynchronizer(static_cast<std::uint32_t>(std::get<sizeof...(More) - 1>(std::tie(more...))))
  {
    connect(std::tie(filter, more...), std::index_sequence_for<M...>());
  }
#define ROSSPIN_ADD(number)                                                                                            \
  template<class Message>                                                                                              \
  void add##number(const Message& message)                                                                             \
  {                                                                                                                    \
    this->template add<number>(message);                                                                               \
  }
  ROSSPIN_ADD(0)
  ROSSPIN_ADD(1)
  ROSSPIN_ADD(2)
  ROSSPIN_ADD(3)
#undef ROSSPIN_ADD

private:
  template<class All, std::size_t... number>
  void connect(All all, std::index_sequence<number...>)
  {
    this->connectInput(std::get<number>(all)...);
  }
};
}  // namespace message_filters

#endif

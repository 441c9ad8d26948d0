// Boost's threads and locks are the standard library's.
#ifndef ROSSPIN_BOOST_THREAD_HPP
#define ROSSPIN_BOOST_THREAD_HPP

#include <chrono>
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <thread>

namespace boost
{
namespace detail
{
template<class M>
class Mutex : public M
{
public:
  typedef std::unique_lock<Mutex> scoped_lock;
};
}  // namespace detail
typedef detail::Mutex<std::mutex> mutex;
typedef detail::Mutex<std::timed_mutex> timed_mutex;
typedef detail::Mutex<std::recursive_mutex> recursive_mutex;

using std::lock_guard;
using std::shared_lock;
using std::shared_mutex;
using std::unique_lock;

class condition_variable : public std::condition_variable_any
{
public:
  template<class Lock, class Duration>
  bool timed_wait(Lock& lock, const Duration& duration)
  {
    return wait_for(lock, duration) == std::cv_status::no_timeout;
  }
  template<class Lock, class Duration, class Predicate>
  bool timed_wait(Lock& lock, const Duration& duration, Predicate predicate)
  {
    return wait_for(lock, duration, predicate);
  }
};
typedef condition_variable condition_variable_any;

// One that is not joined continues alone when this is destroyed.
class thread : public std::thread
{
public:
  using std::thread::thread;
  thread(thread&&) = default;
  thread& operator=(thread&& other)
  {
    end();
    std::thread::operator=(std::move(other));
    return *this;
  }
  ~thread() { end(); }

private:
  void end()
  {
    if (joinable())
      detach();
  }
};

class thread_group
{
public:
  template<class Function>
  thread* create_thread(Function function)
  {
    return threads_.emplace_back(std::make_unique<thread>(std::move(function))).get();
  }
  void add_thread(thread* made) { threads_.emplace_back(made); }
  void join_all()
  {
    for (auto& each : threads_)
      if (each->joinable())
        each->join();
  }
  std::size_t size() const { return threads_.size(); }

private:
  std::list<std::unique_ptr<thread>> threads_;
};

namespace chrono = std::chrono;

namespace posix_time
{
using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;
}  // namespace posix_time

namespace this_thread
{
using namespace std::this_thread;

template<class Duration>
void sleep(const Duration& duration)
{
  sleep_for(duration);
}
}  // namespace this_thread
}  // namespace boost

#endif

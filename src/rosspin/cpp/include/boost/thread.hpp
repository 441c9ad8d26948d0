// Boost's threads and locks are the standard library's.
#ifndef ROSSPIN_BOOST_THREAD_HPP
#define ROSSPIN_BOOST_THREAD_HPP

#include <chrono>
#include <condition_variable>
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

typedef std::condition_variable_any condition_variable;
using std::lock_guard;
using std::shared_lock;
using std::shared_mutex;
using std::thread;
using std::unique_lock;

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

// Boost's threads and locks are those of the standard library.
#ifndef ROSSPIN_BOOST_THREAD_HPP
#define ROSSPIN_BOOST_THREAD_HPP

#include <condition_variable>
#include <mutex>
#include <shared_mutex>
#include <thread>

namespace boost
{
using std::condition_variable;
using std::lock_guard;
using std::mutex;
using std::recursive_mutex;
using std::shared_mutex;
using std::thread;
using std::timed_mutex;
using std::unique_lock;
namespace this_thread = std::this_thread;
}  // namespace boost

#endif

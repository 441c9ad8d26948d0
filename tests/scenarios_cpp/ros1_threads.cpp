// Scenarios for roscpp with threads, one for each run, as in ros1.cpp.

#include <boost/thread.hpp>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <future>
#include <mutex>
#include <pthread.h>
#include <ros/callback_queue.h>
#include <rosgraph_msgs/Clock.h>
#include <shared_mutex>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <thread>

#include "ros1.hpp"

namespace
{
thread_local int calls = 10;

// Says when it begins to live, and when it ends.
struct Life
{
  explicit Life(const std::string& name) : name(name) { say(name + " begins"); }
  ~Life() { name.empty() ? void(std::puts("ends")) : say(name + " ends"); }  // without a name, when the node is gone
  std::string name;
};
thread_local Life life("life");

int called()
{
  thread_local int last = 100;
  return ++last + ++calls;
}

std::chrono::milliseconds ms(int count) { return std::chrono::milliseconds(count); }

void hear(const std_msgs::UInt32::ConstPtr& message) { say("heard " + std::to_string(message->data)); }

void hear_slowly(const std_msgs::UInt32::ConstPtr& message)
{
  hear(message);
  work(0.4);
  say("done " + std::to_string(message->data));
}

// Two timers whose callbacks take long.
struct Slow
{
  ros::Timer one, two;
  Slow(ros::NodeHandle& nh, double first, double second, double takes)
  {
    auto callback = [=](const char* name)
    {
      return [=](const ros::TimerEvent&)
      {
        say(std::string(name) + " begins");
        work(takes);
        say(std::string(name) + " ends");
      };
    };
    one = nh.createTimer(ros::Duration(first), callback("one"));
    two = nh.createTimer(ros::Duration(second), callback("two"));
  }
};

// Tells a time on /clock, each 0.1 s: what `time` gives for the number of the message.
struct Teller
{
  ros::CallbackQueue queue;
  ros::AsyncSpinner spinner{1, &queue};
  ros::Publisher publisher;
  ros::WallTimer timer;
  int count = 0;
  Teller(ros::NodeHandle nh, double (*time)(int))
  {
    nh.setCallbackQueue(&queue);
    publisher = nh.advertise<rosgraph_msgs::Clock>("/clock", 10);
    auto tell = [=](const ros::WallTimerEvent&)
    {
      rosgraph_msgs::Clock message;
      message.clock = ros::Time(time(++count));
      publisher.publish(message);
    };
    timer = nh.createWallTimer(ros::WallDuration(0.1), tell);
    spinner.start();
  }
};

// --- services ---

bool set(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response)
{
  say("asked " + std::to_string(request.data));
  response.success = true;
  response.message = request.data ? "on" : "off";
  return request.data;
}

struct Asked
{
  int count = 0;
  bool trigger(std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response)
  {
    response.message = std::to_string(++count);
    if (count == 2)
      throw std::runtime_error("two");
    return true;
  }
  bool tell(ros::ServiceEvent<std_srvs::TriggerRequest, std_srvs::TriggerResponse>& event)
  {
    event.getResponse().message = event.getCallerName();
    return true;
  }
};

Scenarios scenarios()
{
  using ros::Duration;
  using ros::NodeHandle;
  using ros::TimerEvent;
  Scenarios all;

  // --- threads ---

  all["threads"] = [](NodeHandle&)
  {
    auto count = [](const char* name, int period)
    {
      for (int each = 1; each <= 3; each++)
      {
        std::this_thread::sleep_for(ms(period));
        say(name + std::to_string(each));
      }
    };
    std::thread one(count, "one ", 300), two(count, "two ", 500);
    say("joinable " + shown(one.joinable()) + shown(one.get_id() == std::this_thread::get_id()));
    one.join();
    say("one joined " + shown(one.joinable()));
    two.join();
    say("two joined");
  };
  all["mutex"] = [](NodeHandle&)
  {
    std::mutex mutex;
    std::thread other([&]
        {
          std::lock_guard<std::mutex> lock(mutex);
          say("other has it");
          std::this_thread::sleep_for(ms(700));
          say("other gives it back");
        });
    work(0.2);
    say("tries " + shown(mutex.try_lock()));
    mutex.lock();
    say("main has it");
    mutex.unlock();
    other.join();
  };
  all["mutexes_of_other_kinds"] = [](NodeHandle&)
  {
    std::recursive_mutex again;
    std::shared_mutex shared;
    std::timed_mutex timed;
    std::thread other([&]
        {
          std::lock_guard<std::recursive_mutex> one(again), two(again);
          std::shared_lock<std::shared_mutex> reads(shared);
          std::lock_guard<std::timed_mutex> third(timed);
          work(0.7);
        });
    work(0.1);
    say("tries " + shown(again.try_lock()) + shown(shared.try_lock()) + shown(shared.try_lock_shared()));
    shared.unlock_shared();
    say("in time " + shown(timed.try_lock_for(ms(200))));
    say("in time " + shown(timed.try_lock_for(ms(900))));
    work(0.1);
    say("writes " + shown(shared.try_lock()));
    shared.unlock();
    timed.unlock();
    other.join();
  };
  all["condition"] = [](NodeHandle&)
  {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<int> queue;
    std::thread producer([&]
        {
          for (int each = 1; each <= 4; each++)
          {
            work(each * 0.2);
            std::lock_guard<std::mutex> lock(mutex);
            queue.push_back(each);
            changed.notify_one();
          }
        });
    for (bool more = true; more;)
    {
      std::unique_lock<std::mutex> lock(mutex);
      bool came = changed.wait_for(lock, ms(500), [&] { return !queue.empty(); });
      say(came ? "took " + std::to_string(queue.back()) : "nothing");
      more = !came || queue.back() < 4;
      queue.clear();
    }
    producer.join();
  };
  all["condition_for_all"] = [](NodeHandle&)
  {
    std::mutex mutex;
    std::condition_variable begins;
    bool go = false;
    auto run = [&](int number)
    {
      std::unique_lock<std::mutex> lock(mutex);
      begins.wait(lock, [&] { return go; });
      lock.unlock();
      work(number * 0.3);
      say("runner " + std::to_string(number));
    };
    std::vector<std::thread> runners;
    for (int each : {3, 1, 2})
      runners.emplace_back(run, each);
    work(0.5);
    {
      std::lock_guard<std::mutex> lock(mutex);
      go = true;
    }
    begins.notify_all();
    for (auto& each : runners)
      each.join();
    auto status = [&](int length)
    {
      std::unique_lock<std::mutex> lock(mutex);
      return begins.wait_until(lock, std::chrono::system_clock::now() + ms(length)) == std::cv_status::timeout;
    };
    say("timeout " + shown(status(300)));
  };
  all["futures"] = [](NodeHandle&)
  {
    auto later = std::async(std::launch::async, [](int length)
        {
          std::this_thread::sleep_for(ms(length));
          return length;
        }, 700);
    say("ready " + shown(later.wait_for(ms(300)) == std::future_status::ready));
    say("got " + shown(later.get()));
    auto fails = std::async(std::launch::async, []() -> int
        {
          work(0.4);
          throw std::runtime_error("of the other thread");
        });
    try
    {
      fails.get();
    }
    catch (const std::runtime_error& error)
    {
      say(error.what());
    }
    std::promise<std::string> promise;
    std::future<std::string> future = promise.get_future();
    std::thread keeps([&]
        {
          work(0.5);
          promise.set_value("kept");
        });
    say(future.get());
    keeps.join();
    auto deferred = std::async(std::launch::deferred, [] { return 1; });
    say("deferred " + shown(deferred.wait_for(ms(0)) == std::future_status::deferred));
    {
      auto waits = std::async(std::launch::async, [] { work(0.3); });
    }
    say("waited for");
  };
  all["exceptions"] = [](NodeHandle&)
  {
    auto fail = [](int number)
    {
      for (int each = 1; each <= 3; each++)
        try
        {
          work(number * 0.2);
          throw std::out_of_range(std::to_string(each));
        }
        catch (const std::exception& error)
        {
          work(0.1);
          say("thread " + std::to_string(number) + " " + error.what());
        }
    };
    std::thread one(fail, 1), two(fail, 2);
    one.join();
    two.join();
    // What the library throws.
    for (int each = 1; each <= 2; each++)
      try
      {
        each == 1 ? void(operator new(SIZE_MAX / 4)) : std::thread().join();
      }
      catch (const std::exception& error)
      {
        say(error.what());
      }
  };
  all["detached"] = [](NodeHandle&)
  {
    std::thread([]
        {
          for (int each = 1; ; each++)
          {
            work(0.5);
            say("detached " + std::to_string(each));
          }
        }).detach();
    work(1.7);
    say("main ends");
  };
  all["not_joined"] = [](NodeHandle&)
  {
    std::thread forgotten([] { work(0.5); });
    say("ends");
  };
  all["thread_throws"] = [](NodeHandle&)
  {
    std::thread thrower([]
        {
          work(0.5);
          throw std::runtime_error("uncaught");
        });
    thrower.join();
  };
  all["thread_exits"] = [](NodeHandle&)
  {
    std::thread leaves([]
        {
          work(0.5);
          std::exit(7);
        });
    leaves.join();
  };
  all["thread_locals"] = [](NodeHandle&)
  {
    say("main " + std::to_string(called()));
    std::vector<std::thread> threads;
    for (int each = 0; each < 2; each++)
      threads.emplace_back([each]
          {
            work(0.2 + 0.1 * each);
            for (int time = 0; time < 3; time++, work(0.4))
              say(std::to_string(each) + " " + std::to_string(called()));
          });
    work(0.9);
    say("main " + std::to_string(called()));
    for (std::thread& each : threads)
      each.join();
    int* own = &calls;
    std::thread([&] { say(own == &calls ? "the same" : "others"); *own = 5; }).join();
    say(std::to_string(calls));
  };
  all["thread_locals_end"] = [](NodeHandle&)
  {
    life.name = "";
    std::thread thread([]
        {
          thread_local Life first("first");
          life.name = "of the thread";
          work(0.5);
          say("returns");
        });
    work(0.2);
    say(life.name.empty() ? "its own" : life.name);
    thread.join();
    std::thread([] { say("nothing begins"); }).join();
  };
  all["pthread_exit"] = [](NodeHandle&)
  {
    pthread_t thread;
    auto run = [](void* value) -> void*
    {
      Life inner("inner");
      work(0.5);
      pthread_exit(value);
    };
    int one = 1;
    pthread_create(&thread, nullptr, run, &one);
    void* value = nullptr;
    pthread_join(thread, &value);
    say(value == &one ? "joined" : "nothing");
  };
  all["pthread_exit_of_main"] = [](NodeHandle&)
  {
    Life inner("inner");
    std::thread([] { work(1.0); say("still there"); }).detach();
    pthread_exit(nullptr);
  };
  all["read_write_lock"] = [](NodeHandle&)
  {
    pthread_rwlock_t lock;
    pthread_rwlock_init(&lock, nullptr);
    pthread_rwlock_rdlock(&lock);
    std::thread reads([&]
        {
          work(0.2);
          pthread_rwlock_rdlock(&lock);
          say("reads, too");
          work(0.8);
          pthread_rwlock_unlock(&lock);
        });
    std::thread writes([&]
        {
          work(0.5);
          say(pthread_rwlock_trywrlock(&lock) ? "busy" : "free");
          pthread_rwlock_wrlock(&lock);
          say("writes");
          work(0.5);
          say("has written");
          pthread_rwlock_unlock(&lock);
        });
    work(0.7);
    pthread_rwlock_unlock(&lock);
    work(0.6);
    say(pthread_rwlock_tryrdlock(&lock) ? "busy" : "free");
    pthread_rwlock_rdlock(&lock);
    say("reads");
    pthread_rwlock_unlock(&lock);
    reads.join();
    writes.join();
    pthread_rwlock_destroy(&lock);
  };
  all["call_once"] = [](NodeHandle&)
  {
    static std::once_flag flag;
    auto run = []
    {
      std::call_once(flag, []
          {
            work(0.4);
            say("once");
          });
      say("after it");
    };
    std::thread one(run), two(run);
    one.join();
    two.join();
  };
  all["waits_for_time"] = [](NodeHandle&)
  {
    bool done = false;
    std::thread other([&]
        {
          std::this_thread::sleep_until(std::chrono::steady_clock::now() + ms(700));
          say("other");
          done = true;
        });
    while (!done)
      std::this_thread::yield();
    say("main");
    other.join();
  };
  all["boost"] = [](NodeHandle&)
  {
    boost::mutex mutex;
    boost::recursive_mutex again;
    boost::thread other([&]
        {
          boost::mutex::scoped_lock lock(mutex);
          boost::recursive_mutex::scoped_lock one(again), two(again);
          boost::this_thread::sleep_for(boost::chrono::milliseconds(700));
          say("other");
        });
    work(0.1);
    say("tries " + shown(mutex.try_lock()) + shown(again.try_lock()));
    boost::mutex::scoped_lock lock(mutex);
    say("main");
    other.join();
  };
  all["joined_after_ctrl_c"] = [](NodeHandle&)
  {
    std::mutex mutex;
    std::thread other([&]
        {
          while (ros::ok())
            work(0.4);
          say("late, so nobody compares it");
        });
    other.join();
    say("joined");
  };

  // --- threads and the node ---

  all["spin_in_a_thread"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [](const TimerEvent&) { say("timer"); });
    std::thread spins([] { ros::spin(); });
    ros::Rate rate(Duration(0.8));
    for (int pass = 0; pass < 3; pass++)
    {
      say("main");
      rate.sleep();
    }
    ros::shutdown();
    spins.join();
    begun = ros::WallTime::now();  // that takes a while
    say("joined");
  };
  all["publishes_in_a_thread"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    std::thread publishes([&]
        {
          ros::Rate rate(Duration(0.5));
          for (unsigned each = 1; ros::ok() && each < 5; each++)
          {
            rate.sleep();
            publisher.publish(number(each));
          }
        });
    ros::Timer timer = nh.createTimer(Duration(0.8), [](const TimerEvent&) { say("timer"); });
    ros::spin();
    publishes.join();
  };
  all["shared_with_a_thread"] = [](NodeHandle& nh)
  {
    std::mutex mutex;
    int count = 0;
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        {
          std::lock_guard<std::mutex> lock(mutex);
          say("timer " + std::to_string(++count));
        });
    std::thread holds([&]
        {
          work(0.7);
          std::lock_guard<std::mutex> lock(mutex);
          count += 10;
          work(1.0);
          say("held");
        });
    ros::spin();
    holds.join();
  };
  all["queue_of_a_thread"] = [](NodeHandle& nh)
  {
    ros::NodeHandle other("~other");
    ros::CallbackQueue queue;
    other.setCallbackQueue(&queue);
    ros::Timer one = nh.createTimer(Duration(0.5), [](const TimerEvent&)
        {
          say("one begins");
          work(0.4);
          say("one ends");
        });
    ros::Timer two = other.createTimer(Duration(1.1), [](const TimerEvent&) { say("two"); });
    std::thread calls([&]
        {
          while (ros::ok())
            queue.callAvailable(ros::WallDuration(0.1));
        });
    ros::spin();
    calls.join();
  };
  all["timer_made_in_a_thread"] = [](NodeHandle& nh)
  {
    ros::Timer timer;
    std::thread makes([&]
        {
          work(0.3);
          timer = nh.createTimer(Duration(0.5), [](const TimerEvent&) { say("timer"); });
          work(1.6);
          timer.setPeriod(Duration(0.2));
        });
    ros::spin();
    makes.join();
  };

  // --- spinners ---

  all["async_spinner"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [](const TimerEvent&) { say("timer"); });
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    work(0.6);
    ros::AsyncSpinner spinner(2);
    say("starts " + shown(spinner.canStart()));
    spinner.start();
    for (unsigned each = 1; each < 3; each++)
    {
      publisher.publish(number(each));
      Duration(0.3).sleep();
      say("main");
    }
    spinner.stop();
    ros::waitForShutdown();
  };
  all["async_spinner_sleeps"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [](const TimerEvent&)
        {
          say("timer");
          work(0.7);
          say("done");
        });
    ros::AsyncSpinner spinner(1);
    spinner.start();
    ros::waitForShutdown();
  };
  all["async_spinner_is_interrupted"] = [](NodeHandle& nh)
  {
    auto hear_slowly = [](const std_msgs::UInt32&)
    {
      say("hears");
      work(1.2);
      std::printf("has heard, ok %d\n", ros::ok());
      std::fflush(stdout);
    };
    boost::function<void(const std_msgs::UInt32&)> callback = hear_slowly;
    ros::Subscriber subscriber = nh.subscribe<std_msgs::UInt32>("topic", 10, callback);
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    publisher.publish(number(1));
    work(0.5);
    std::raise(SIGINT);
    ros::waitForShutdown();
    std::puts("main goes on");
    std::fflush(stdout);
    work(1.5);
  };
  all["boost_threads"] = [](NodeHandle&)
  {
    {
      boost::thread alone([]
          {
            work(0.3);
            say("alone");
          });
    }
    boost::thread_group group;
    for (double length : {0.5, 0.7})
      group.create_thread([length]
          {
            work(length);
            say("of a group");
          });
    say(shown(group.size()));
    group.join_all();
    boost::mutex mutex;
    boost::condition_variable condition;
    boost::condition_variable_any any;
    boost::thread notifies([&]
        {
          work(0.8);
          any.notify_one();
        });
    boost::mutex::scoped_lock lock(mutex);
    bool in_time = condition.timed_wait(lock, boost::posix_time::milliseconds(400));
    say("in time " + shown(in_time));
    in_time = any.timed_wait(lock, boost::posix_time::seconds(1));
    say("in time " + shown(in_time));
    notifies.join();
  };
  all["multi_threaded_spinner"] = [](NodeHandle& nh)
  {
    ros::Timer one = nh.createTimer(Duration(0.5), [](const TimerEvent&) { say("one"); });
    ros::Timer two = nh.createTimer(Duration(0.7), [](const TimerEvent&) { say("two"); });
    ros::MultiThreadedSpinner spinner(2);
    ros::spin(spinner);
    say("over");
  };
  all["two_spinners"] = [](NodeHandle&)
  {
    ros::AsyncSpinner spinner(1);
    spinner.start();
    try
    {
      ros::spin();
    }
    catch (const std::runtime_error& error)
    {
      say(error.what());
    }
  };

  all["async_spinner_of_two"] = [](NodeHandle& nh)
  {
    Slow slow(nh, 0.5, 0.6, 0.7);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    ros::waitForShutdown();
  };
  all["async_spinner_beside_main"] = [](NodeHandle& nh)
  {
    Slow slow(nh, 0.5, 1.1, 0.8);
    ros::AsyncSpinner spinner(1);
    spinner.start();
    for (int pass = 0; pass < 6; pass++)
    {
      work(0.4);
      say("main");
    }
  };
  all["async_spinner_stops"] = [](NodeHandle& nh)
  {
    Slow slow(nh, 0.5, 0.7, 0.6);
    ros::AsyncSpinner spinner(1);
    spinner.start();
    work(0.8);
    say("stops");
    spinner.stop();
    say("has stopped");
    work(0.7);
    say("starts again");
    spinner.start();
    work(0.9);
  };
  all["async_spinner_stops_when_it_looks"] = [](NodeHandle&)  // each 0.1 s
  {
    ros::AsyncSpinner spinner(2);
    spinner.start();
    work(0.22);
    say("stops");
    spinner.stop();
    say("has stopped");
    spinner.start();
    work(0.42);
    say("stops again");
    spinner.stop();
    say("has stopped again");
  };
  all["spinner_of_a_queue_of_its_own"] = [](NodeHandle& nh)
  {
    ros::CallbackQueue queue;
    NodeHandle own(nh);
    own.setCallbackQueue(&queue);
    ros::Timer timer = own.createTimer(Duration(1.3), [](const TimerEvent&) { say("timer"); });
    std::thread thread([&]
        {
          ros::SingleThreadedSpinner spinner;
          spinner.spin(&queue);
          std::puts("ends");
        });
    ros::spin();
    thread.join();
  };
  all["multi_threaded_spinner_of_two"] = [](NodeHandle& nh)
  {
    Slow slow(nh, 0.4, 0.9, 0.8);
    ros::Timer three = nh.createTimer(Duration(0.6), [](const TimerEvent&) { say("three"); });
    ros::MultiThreadedSpinner spinner(2);
    spinner.spin();
  };
  all["a_subscriber_is_called_once_at_a_time"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear_slowly);
    ros::Timer timer = nh.createTimer(Duration(0.8), [](const TimerEvent&) { say("timer"); });
    ros::AsyncSpinner spinner(3);
    spinner.start();
    work(0.5);
    for (unsigned each = 1; each < 5; each++)
      publisher.publish(number(each));
    ros::waitForShutdown();
  };
  all["a_subscriber_that_allows_more"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::SubscribeOptions options;
    options.init<std_msgs::UInt32>("topic", 10, hear_slowly);
    options.allow_concurrent_callbacks = true;
    ros::Subscriber subscriber = nh.subscribe(options);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    work(0.3);
    for (unsigned each = 1; each < 4; each++)
    {
      publisher.publish(number(each));
      work(0.1);
    }
    ros::waitForShutdown();
  };
  all["a_subscriber_ends_while_it_is_called"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear_slowly);
    ros::AsyncSpinner spinner(1);
    spinner.start();
    work(0.5);
    publisher.publish(number(1));
    work(0.2);
    say("unsubscribes");
    subscriber.shutdown();
    say("has unsubscribed");
    work(0.6);
  };
  all["a_timer_stops_while_it_is_called"] = [](NodeHandle& nh)
  {
    Slow slow(nh, 0.5, 9.0, 0.6);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    work(0.8);
    say("stops");
    slow.one.stop();
    say("has stopped");
    work(1.0);
  };
  all["a_service_from_a_callback"] = [](NodeHandle& nh)
  {
    ros::ServiceServer server = nh.advertiseService("set", set);
    ros::ServiceClient client = nh.serviceClient<std_srvs::SetBool>("set");
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        {
          std_srvs::SetBool whole;
          whole.request.data = true;
          say("calls");
          bool ok = client.call(whole);
          say("answered " + shown(ok) + whole.response.message);
        }, true);
    ros::MultiThreadedSpinner spinner(2);
    spinner.spin();
  };
  all["a_slow_service"] = [](NodeHandle& nh)
  {
    boost::function<bool(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&)> answer =
        [](std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response)
    {
      say("asked " + std::to_string(request.data));
      work(0.6);
      return true;
    };
    ros::ServiceServer server = nh.advertiseService("set", answer);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    auto call = [&](bool value, double begins)
    {
      work(begins);
      std_srvs::SetBool whole;
      whole.request.data = value;
      say("calls " + shown(value));
      ros::service::call("~set", whole);
      say("answered " + shown(value));
    };
    std::thread one(call, true, 0.3), two(call, false, 0.5);
    one.join();
    two.join();
  };

  // --- /clock: the time of these, ~use_sim_time, is what it tells ---

  all["sim_time"] = [](NodeHandle& nh)
  {
    say(shown(ros::Time::isSimTime()) + shown(ros::Time::useSystemTime()) + shown(ros::Time::isValid()));
    say(shown(ros::Time::waitForValid(ros::WallDuration(0.05))) + shown(ros::Time::now()));
    // It stands still from the 9th message to the 12th, goes back at the 14th, and jumps at the 20th.
    auto time = [](int each)
    {
      int fifths = each > 19 ? 90 : each > 13 ? 36 + each : each > 11 ? 47 + each : 50 + std::min(each, 9);
      return 0.2 * fifths;
    };
    Teller teller(nh, time);
    auto tick = [](const char* name)
    {
      return [=](const ros::TimerEvent& event)
      {
        say(name + shown(event.current_expected) + " " + shown(event.current_real) + " " + shown(event.last_expected));
      };
    };
    ros::Timer timer = nh.createTimer(Duration(0.5), tick("timer "));
    ros::Timer once = nh.createTimer(Duration(11.3), tick("once "), true);
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("number", 10);
    boost::function<void(const ros::MessageEvent<std_msgs::UInt32 const>&)> receive =
        [](const ros::MessageEvent<std_msgs::UInt32 const>& event) { say("received " + shown(event.getReceiptTime())); };
    ros::Subscriber subscriber = nh.subscribe<std_msgs::UInt32>("number", 10, receive);
    ros::WallTimer wall = nh.createWallTimer(ros::WallDuration(0.77), [&](const ros::WallTimerEvent&)
        {
          publisher.publish(number(1));
          ROS_INFO("log");
          ROS_INFO_THROTTLE(10, "log sometimes");
        });
    ros::spin();
  };
  all["sim_time_sleeps"] = [](NodeHandle& nh)
  {
    Teller teller(nh, [](int each) { return each < 5 ? 0.0 : 0.2 * (each > 15 ? 35 + each : 50 + each); });
    bool slept = Duration(0.5).sleep();
    say("slept " + shown(slept) + " " + shown(ros::Time::now()));
    slept = Duration(-1.0).sleep();
    say("slept " + shown(slept));
    bool reached = ros::Time::sleepUntil(ros::Time(12.1));
    say("reached " + shown(reached) + " " + shown(ros::Time::now()));
    reached = ros::Time::sleepUntil(ros::Time(12.0));
    say("reached " + shown(reached));
    ros::Rate rate(2);
    for (int pass = 0; pass < 5; pass++)
    {
      slept = rate.sleep();
      say("pass " + shown(slept) + " " + shown(ros::Time::now()) + " " + shown(rate.cycleTime()));
    }
    std::thread other([]
        {
          work(0.3);
          ros::shutdown();
        });
    slept = Duration(100).sleep();
    other.join();
    bool still = Duration(0.01).sleep(), wall = ros::WallDuration(0.01).sleep(), loop = rate.sleep();
    std::printf("slept %d %d %d %d\n", slept, still, wall, loop);  // the real one takes 0.3 s for its end
  };

  // --- services ---

  all["services"] = [](NodeHandle& nh)
  {
    Asked asked;
    ros::ServiceServer one = nh.advertiseService("set", set);
    ros::ServiceServer two = nh.advertiseService("trigger", &Asked::trigger, &asked);
    ros::ServiceServer three = nh.advertiseService("caller", &Asked::tell, &asked);
    ros::ServiceServer four = nh.advertiseService("set", set);
    say(one.getService() + shown(static_cast<bool>(one)) + shown(static_cast<bool>(four)));
    ros::AsyncSpinner spinner(1);
    spinner.start();
    std_srvs::SetBool whole;
    std_srvs::Trigger empty;
    ros::ServiceClient setter = nh.serviceClient<std_srvs::SetBool>("set");
    ros::ServiceClient kept = nh.serviceClient<std_srvs::Trigger>("trigger", true);
    say(shown(setter.exists()) + shown(setter.isValid()) + shown(setter.isPersistent()) + shown(kept.isPersistent()));
    for (bool value : {true, false})
    {
      whole.request.data = value;
      bool ok = setter.call(whole);
      say(shown(ok) + whole.response.message);
    }
    for (int each = 0; each < 3; each++)
    {
      bool ok = kept.call(empty);
      say(shown(ok) + empty.response.message + shown(kept.isValid()));
    }
    say(shown(ros::service::call("~caller", empty)) + empty.response.message);
    say(shown(ros::service::exists("~caller", false)) + shown(ros::service::exists("nobody", true)));
    ros::ServiceClient none = nh.serviceClient<std_srvs::Trigger>("nobody");
    bool found = none.waitForExistence(Duration(0.5));
    bool called = none.call(empty);
    say(shown(found) + shown(called) + none.getService());
    say("looks " + shown(none.waitForExistence(Duration(0))));
    one.shutdown();
    say(shown(setter.call(whole)) + shown(setter.exists()) + one.getService());
  };
  all["services_without_a_spinner"] = [](NodeHandle& nh)
  {
    ros::ServiceServer server = nh.advertiseService("set", set);
    std_srvs::SetBool whole;
    work(0.5);
    say("calls");
    ros::service::call("~set", whole);
    say("never before the end");
  };
  return all;
}
}  // namespace

int main(int argc, char** argv)
{
  // The nodes of those whose names begin with "sim" follow /clock.
  return run(argc, argv,
      [] { ros::param::set("/use_sim_time", std::strncmp(ros::this_node::getName().c_str(), "/s_sim", 6) == 0); });
}

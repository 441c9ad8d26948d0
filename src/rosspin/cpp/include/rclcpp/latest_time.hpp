// The policy LatestTime, which message_filters have in ROS 2 (source: sync_policies/latest_time.h of Jazzy).
#ifndef ROSSPIN_RCLCPP_LATEST_TIME_HPP
#define ROSSPIN_RCLCPP_LATEST_TIME_HPP

#include "rosspin/filters.hpp"

#include <numeric>

namespace message_filters
{
namespace detail
{
// Each message of the topic that comes most often, and is not late, passes on the latest of all topics.
class Latest
{
public:
  typedef std::tuple<double, double, double> RateConfig;  // weights of a new rate and a new error; how many errors are a step

  Latest(std::size_t count, std::size_t) : latest_(count) {}
  Latest(const Latest& other) : clock(other.clock), latest_(other.latest_), rates_(other.rates_) {}  // without its configs
  template<class M>
  std::int64_t stamp_of(const M&) const
  {
    return clock->now().nanoseconds();
  }
  void add(std::size_t number, const Stamped& one, const Use& pass, const Use&)
  {
    bool is_first = !std::exchange(latest_[number], one).event;
    if (is_first)
      rates_.push_back({one.stamp, configs.size() == latest_.size() ? configs[number]
              : configs.size() == 1                                 ? configs[0]
                                                                    : RateConfig(0.9, 0.3, 10.0)});
    // Rates are in the order in which topics came first, but are looked for by the topics' own numbers, as in the source.
    else if (number < rates_.size() && rates_[number].update(one.stamp) && is_pivot(number, one.stamp) &&
             rates_.size() == latest_.size())
      pass(latest_);
  }
  rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
  std::vector<RateConfig> configs;

private:
  struct Rate
  {
    std::int64_t last;
    RateConfig config;
    double hz = 0, error = 0;
    bool has_hz = false, has_error = false;

    double at(std::int64_t now) const { return 1 / (static_cast<double>(now - last) / 1e9); }
    bool update(std::int64_t now)
    {
      if (now <= last)
        return false;
      auto [hz_weight, error_weight, step] = config;
      double found = at(now), off = std::fabs(hz - found);
      if (has_error && off > step * error)
        has_hz = has_error = false;  // it changes at once
      if (has_hz)
      {
        error = has_error ? error_weight * off + (1 - error_weight) * error : off;
        has_error = true;
      }
      hz = has_hz ? hz_weight * found + (1 - hz_weight) * hz : found;
      has_hz = true;
      last = now;
      return true;
    }
    bool is_late(std::int64_t now) const
    {
      return now != last && has_error && hz - at(now) > std::get<2>(config) * error;
    }
  };

  bool is_pivot(std::size_t number, std::int64_t now) const
  {
    std::vector<std::size_t> order(rates_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](auto one, auto other) { return rates_[one].hz > rates_[other].hz; });
    auto found = std::find_if(
        order.begin(), order.end(), [&](auto each) { return rates_[each].hz > 0 && !rates_[each].is_late(now); });
    return found != order.end() && *found == number;
  }
  std::vector<Stamped> latest_;
  std::vector<Rate> rates_;
};
}  // namespace detail

namespace sync_policies
{
template<class... M>
class LatestTime : public detail::Policy<detail::Latest, M...>
{
public:
  typedef detail::Latest::RateConfig RateConfig;
  LatestTime() : detail::Policy<detail::Latest, M...>(0) {}
  explicit LatestTime(rclcpp::Clock::SharedPtr clock) : LatestTime() { setClock(clock); }
  void setRateConfigPerMessage(const std::vector<RateConfig>& configs) { this->matcher_.configs = configs; }
  void setRateConfig(const RateConfig& config) { this->matcher_.configs = {config}; }
  void setClock(rclcpp::Clock::SharedPtr clock) { this->matcher_.clock = clock; }
};
}  // namespace sync_policies
}  // namespace message_filters

#endif

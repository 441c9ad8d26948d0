// Clients for the parameters of another node (source: parameter_client.cpp).
#ifndef ROSSPIN_RCLCPP_PARAMETER_CLIENT_HPP
#define ROSSPIN_RCLCPP_PARAMETER_CLIENT_HPP

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/executors.hpp"

namespace rclcpp
{
class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)
  typedef rcl_interfaces::msg::SetParametersResult Set;
  typedef rcl_interfaces::msg::ListParametersResult Listed;
  typedef rcl_interfaces::msg::ParameterDescriptor Descriptor;
  template<class T>
  using Future = std::shared_future<T>;
  template<class T>
  using Call = std::function<void(Future<T>)>;

  template<class AnyNode>
  explicit AsyncParametersClient(const AnyNode& node, const std::string& remote_node_name = "",
      const QoS& qos = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
    : AsyncParametersClient(node->get_node_base_interface(), remote_node_name, qos, group)
  {
  }
  AsyncParametersClient(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& remote_node_name,
      const QoS& qos, CallbackGroup::SharedPtr group);

  Future<std::vector<Parameter>> get_parameters(
      const std::vector<std::string>& names, Call<std::vector<Parameter>> call = nullptr);
  Future<std::vector<Descriptor>> describe_parameters(
      const std::vector<std::string>& names, Call<std::vector<Descriptor>> call = nullptr);
  Future<std::vector<ParameterType>> get_parameter_types(
      const std::vector<std::string>& names, Call<std::vector<ParameterType>> call = nullptr);
  Future<std::vector<Set>> set_parameters(
      const std::vector<Parameter>& parameters, Call<std::vector<Set>> call = nullptr);
  Future<Set> set_parameters_atomically(const std::vector<Parameter>& parameters, Call<Set> call = nullptr);
  Future<std::vector<Set>> delete_parameters(const std::vector<std::string>& names)
  {
    return set_parameters(std::vector<Parameter>(names.begin(), names.end()));
  }
  Future<Listed> list_parameters(
      const std::vector<std::string>& prefixes, std::uint64_t depth, Call<Listed> call = nullptr);
  template<class File>
  void load_parameters(const File&) ROSSPIN_NOT_SIMULATED("rclcpp::AsyncParametersClient::load_parameters");
  bool service_is_ready() const;
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait_for_service_nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  template<class AnyNode, class Callback>
  static auto on_parameter_event(AnyNode&& node, Callback&& callback, const QoS& qos = ParameterEventsQoS())
  {
    return node->template create_subscription<rcl_interfaces::msg::ParameterEvent>(
        "/parameter_events", qos, std::forward<Callback>(callback));
  }
  template<class Callback>
  auto on_parameter_event(Callback&& callback, const QoS& qos = ParameterEventsQoS())
  {
    typedef Subscription<rcl_interfaces::msg::ParameterEvent> Events;
    auto made = std::make_shared<Events>(
        node_, "/parameter_events", qos, std::forward<Callback>(callback), SubscriptionOptions());
    node_->get_default_callback_group()->add(made);
    return made;
  }

private:
  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  Client<rcl_interfaces::srv::GetParameters>::SharedPtr get_;
  Client<rcl_interfaces::srv::GetParameterTypes>::SharedPtr get_types_;
  Client<rcl_interfaces::srv::SetParameters>::SharedPtr set_;
  Client<rcl_interfaces::srv::SetParametersAtomically>::SharedPtr set_atomically_;
  Client<rcl_interfaces::srv::ListParameters>::SharedPtr list_;
  Client<rcl_interfaces::srv::DescribeParameters>::SharedPtr describe_;
};

// Waits for each answer by spinning.
class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)
  typedef AsyncParametersClient::Set Set;
  typedef AsyncParametersClient::Listed Listed;
  typedef AsyncParametersClient::Descriptor Descriptor;

  template<class AnyNode>
  explicit SyncParametersClient(
      const AnyNode& node, const std::string& remote_node_name = "", const QoS& qos = ParametersQoS())
    : SyncParametersClient(
          std::make_shared<executors::SingleThreadedExecutor>(), node, remote_node_name, qos)
  {
  }
  template<class AnyNode>
  SyncParametersClient(Executor::SharedPtr executor, const AnyNode& node, const std::string& remote_node_name = "",
      const QoS& qos = ParametersQoS())
    : executor_(std::move(executor)), node_(node->get_node_base_interface()), asynchronous_(node, remote_node_name, qos)
  {
  }

  template<class Rep = std::int64_t, class Period = std::milli>
  std::vector<Parameter> get_parameters(const std::vector<std::string>& names,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.get_parameters(names), timeout);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  std::vector<Descriptor> describe_parameters(const std::vector<std::string>& names,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.describe_parameters(names), timeout);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  std::vector<ParameterType> get_parameter_types(const std::vector<std::string>& names,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.get_parameter_types(names), timeout);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  std::vector<Set> set_parameters(const std::vector<Parameter>& parameters,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.set_parameters(parameters), timeout);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  std::vector<Set> delete_parameters(const std::vector<std::string>& names,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.delete_parameters(names), timeout);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  Set set_parameters_atomically(const std::vector<Parameter>& parameters,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.set_parameters_atomically(parameters), timeout,
        "Unable to get result of set parameters service call.");
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  Listed list_parameters(const std::vector<std::string>& prefixes, std::uint64_t depth,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return got(asynchronous_.list_parameters(prefixes, depth), timeout,
        "Unable to get result of list parameters service call.");
  }
  template<class File>
  void load_parameters(const File&) ROSSPIN_NOT_SIMULATED("rclcpp::SyncParametersClient::load_parameters");
  bool has_parameter(const std::string& name) { return !list_parameters({name}, 1).names.empty(); }
  template<class T>
  T get_parameter(const std::string& name, const T& default_value)
  {
    std::vector<Parameter> found = get_parameters({name});
    bool is_set = found.size() == 1 && found[0].get_type() != PARAMETER_NOT_SET;
    return is_set ? found[0].get_value<T>() : default_value;
  }
  template<class T>
  T get_parameter(const std::string& name)
  {
    std::vector<Parameter> found = get_parameters({name});
    if (found.size() != 1 || found[0].get_type() == PARAMETER_NOT_SET)
      throw std::runtime_error("Parameter '" + name + "' is not set");
    return found[0].get_value<T>();
  }
  bool service_is_ready() const { return asynchronous_.service_is_ready(); }
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return asynchronous_.wait_for_service(timeout);
  }
  template<class Callback>
  auto on_parameter_event(Callback&& callback)
  {
    return asynchronous_.on_parameter_event(std::forward<Callback>(callback));
  }
  template<class AnyNode, class Callback>
  static auto on_parameter_event(AnyNode&& node, Callback&& callback)
  {
    return AsyncParametersClient::on_parameter_event(node, std::forward<Callback>(callback));
  }

private:
  // The answer; without one this throws what it is told to, or gives nothing.
  template<class T, class Length>
  T got(std::shared_future<T> future, Length timeout, const char* otherwise = nullptr)
  {
    auto code = executors::spin_node_until_future_complete(*executor_, node_, future, timeout);
    if (code == FutureReturnCode::SUCCESS)
      return future.get();
    if (otherwise)
      throw std::runtime_error(otherwise);
    return T();
  }
  Executor::SharedPtr executor_;
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  AsyncParametersClient asynchronous_;
};
}  // namespace rclcpp

#endif

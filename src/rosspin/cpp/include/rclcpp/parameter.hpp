// Parameters of rclcpp: their values.
#ifndef ROSSPIN_RCLCPP_PARAMETER_HPP
#define ROSSPIN_RCLCPP_PARAMETER_HPP

#include <iostream>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
enum ParameterType : std::uint8_t
{
  PARAMETER_NOT_SET,
  PARAMETER_BOOL,
  PARAMETER_INTEGER,
  PARAMETER_DOUBLE,
  PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY,
  PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY,
};
std::string to_string(ParameterType type);
std::ostream& operator<<(std::ostream& stream, ParameterType type);

class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual)
    : std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]")
  {
  }
};

class ParameterValue
{
public:
  ParameterValue() = default;
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue& value);
  explicit ParameterValue(bool value) { set(PARAMETER_BOOL).bool_value = value; }
  explicit ParameterValue(int value) { set(PARAMETER_INTEGER).integer_value = value; }
  explicit ParameterValue(std::int64_t value) { set(PARAMETER_INTEGER).integer_value = value; }
  explicit ParameterValue(long value) { set(PARAMETER_INTEGER).integer_value = value; }
  explicit ParameterValue(float value) { set(PARAMETER_DOUBLE).double_value = value; }
  explicit ParameterValue(double value) { set(PARAMETER_DOUBLE).double_value = value; }
  explicit ParameterValue(const std::string& value) { set(PARAMETER_STRING).string_value = value; }
  explicit ParameterValue(const char* value) { set(PARAMETER_STRING).string_value = value; }
  explicit ParameterValue(const std::vector<std::uint8_t>& value) { set(PARAMETER_BYTE_ARRAY).byte_array_value = value; }
  explicit ParameterValue(const std::vector<bool>& value) { set(PARAMETER_BOOL_ARRAY).bool_array_value = value; }
  explicit ParameterValue(const std::vector<int>& value)
  {
    set(PARAMETER_INTEGER_ARRAY).integer_array_value.assign(value.begin(), value.end());
  }
  explicit ParameterValue(const std::vector<std::int64_t>& value)
  {
    set(PARAMETER_INTEGER_ARRAY).integer_array_value = value;
  }
  explicit ParameterValue(const std::vector<long>& value)
  {
    set(PARAMETER_INTEGER_ARRAY).integer_array_value.assign(value.begin(), value.end());
  }
  explicit ParameterValue(const std::vector<float>& value)
  {
    set(PARAMETER_DOUBLE_ARRAY).double_array_value.assign(value.begin(), value.end());
  }
  explicit ParameterValue(const std::vector<double>& value) { set(PARAMETER_DOUBLE_ARRAY).double_array_value = value; }
  explicit ParameterValue(const std::vector<std::string>& value)
  {
    set(PARAMETER_STRING_ARRAY).string_array_value = value;
  }

  ParameterType get_type() const { return static_cast<ParameterType>(value_.type); }
  rcl_interfaces::msg::ParameterValue to_value_msg() const { return value_; }
  bool operator==(const ParameterValue& other) const { return value_ == other.value_; }
  bool operator!=(const ParameterValue& other) const { return value_ != other.value_; }

  template<ParameterType type>
  const auto& get() const
  {
    if (get_type() != type)
      throw ParameterTypeException(type, get_type());
    if constexpr (type == PARAMETER_BOOL)
      return value_.bool_value;
    else if constexpr (type == PARAMETER_INTEGER)
      return value_.integer_value;
    else if constexpr (type == PARAMETER_DOUBLE)
      return value_.double_value;
    else if constexpr (type == PARAMETER_STRING)
      return value_.string_value;
    else if constexpr (type == PARAMETER_BYTE_ARRAY)
      return value_.byte_array_value;
    else if constexpr (type == PARAMETER_BOOL_ARRAY)
      return value_.bool_array_value;
    else if constexpr (type == PARAMETER_INTEGER_ARRAY)
      return value_.integer_array_value;
    else if constexpr (type == PARAMETER_DOUBLE_ARRAY)
      return value_.double_array_value;
    else
      return value_.string_array_value;
  }

  template<class T>
  const auto& get() const
  {
    if constexpr (std::is_same_v<T, bool>)
      return get<PARAMETER_BOOL>();
    else if constexpr (std::is_integral_v<T>)
      return get<PARAMETER_INTEGER>();
    else if constexpr (std::is_floating_point_v<T>)
      return get<PARAMETER_DOUBLE>();
    else if constexpr (std::is_convertible_v<T, std::string>)
      return get<PARAMETER_STRING>();
    else if constexpr (std::is_same_v<T, std::vector<std::uint8_t>>)
      return get<PARAMETER_BYTE_ARRAY>();
    else if constexpr (std::is_same_v<T, std::vector<bool>>)
      return get<PARAMETER_BOOL_ARRAY>();
    else if constexpr (std::is_same_v<T, std::vector<std::string>>)
      return get<PARAMETER_STRING_ARRAY>();
    else if constexpr (std::is_integral_v<typename T::value_type>)
      return get<PARAMETER_INTEGER_ARRAY>();
    else
      return get<PARAMETER_DOUBLE_ARRAY>();
  }

private:
  rcl_interfaces::msg::ParameterValue& set(ParameterType type)
  {
    value_.type = type;
    return value_;
  }
  rcl_interfaces::msg::ParameterValue value_;
};
std::string to_string(const ParameterValue& value);

namespace detail
{
// A value as a node asks for it. An array of numbers may be asked for as one of narrower numbers.
template<class T, class From>
T converted(const From& value)
{
  if constexpr (std::is_convertible_v<From, T>)
    return static_cast<T>(value);
  else
    return T(value.begin(), value.end());
}
}  // namespace detail

class Parameter
{
public:
  Parameter() = default;
  explicit Parameter(const std::string& name) : name_(name) {}
  Parameter(const std::string& name, const ParameterValue& value) : name_(name), value_(value) {}
  template<class T>
  Parameter(const std::string& name, T value) : name_(name), value_(ParameterValue(value))
  {
  }

  bool operator==(const Parameter& other) const { return name_ == other.name_ && value_ == other.value_; }
  bool operator!=(const Parameter& other) const { return !(*this == other); }
  ParameterType get_type() const { return value_.get_type(); }
  std::string get_type_name() const { return to_string(get_type()); }
  const std::string& get_name() const { return name_; }
  rcl_interfaces::msg::ParameterValue get_value_message() const { return value_.to_value_msg(); }
  const ParameterValue& get_parameter_value() const { return value_; }
  template<ParameterType type>
  decltype(auto) get_value() const
  {
    return value_.get<type>();
  }
  template<class T>
  T get_value() const
  {
    if constexpr (std::is_same_v<T, ParameterValue>)
      return value_;
    else if constexpr (std::is_same_v<T, Parameter>)
      return *this;
    else
      try
      {
        return detail::converted<T>(value_.get<T>());
      }
      catch (const ParameterTypeException& error)
      {
        throw exceptions::InvalidParameterTypeException(name_, error.what());
      }
  }
  bool as_bool() const { return get_value<PARAMETER_BOOL>(); }
  std::int64_t as_int() const { return get_value<PARAMETER_INTEGER>(); }
  double as_double() const { return get_value<PARAMETER_DOUBLE>(); }
  const std::string& as_string() const { return get_value<PARAMETER_STRING>(); }
  const std::vector<std::uint8_t>& as_byte_array() const { return get_value<PARAMETER_BYTE_ARRAY>(); }
  const std::vector<bool>& as_bool_array() const { return get_value<PARAMETER_BOOL_ARRAY>(); }
  const std::vector<std::int64_t>& as_integer_array() const { return get_value<PARAMETER_INTEGER_ARRAY>(); }
  const std::vector<double>& as_double_array() const { return get_value<PARAMETER_DOUBLE_ARRAY>(); }
  const std::vector<std::string>& as_string_array() const { return get_value<PARAMETER_STRING_ARRAY>(); }
  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter& message)
  {
    return Parameter(message.name, ParameterValue(message.value));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const
  {
    rcl_interfaces::msg::Parameter message;
    message.name = name_;
    message.value = value_.to_value_msg();
    return message;
  }
  std::string value_to_string() const { return to_string(value_); }

private:
  std::string name_;
  ParameterValue value_;
};
std::string _to_json_dict_entry(const Parameter& parameter);
std::ostream& operator<<(std::ostream& stream, const Parameter& parameter);
std::ostream& operator<<(std::ostream& stream, const std::vector<Parameter>& parameters);

typedef std::map<std::string, std::vector<Parameter>> ParameterMap;
}  // namespace rclcpp

namespace std
{
string to_string(const rclcpp::Parameter& parameter);
string to_string(const vector<rclcpp::Parameter>& parameters);
}  // namespace std

#endif

// The exceptions of rclcpp.
#ifndef ROSSPIN_RCLCPP_EXCEPTIONS_HPP
#define ROSSPIN_RCLCPP_EXCEPTIONS_HPP

#include <stdexcept>
#include <string>
#include <vector>

namespace rclcpp
{
namespace exceptions
{
class NameValidationError : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

#define ROSSPIN_NAME_ERROR(Name)                                                                                       \
  class Name : public NameValidationError                                                                              \
  {                                                                                                                    \
  public:                                                                                                              \
    using NameValidationError::NameValidationError;                                                                    \
  }
ROSSPIN_NAME_ERROR(InvalidNodeNameError);
ROSSPIN_NAME_ERROR(InvalidNamespaceError);
ROSSPIN_NAME_ERROR(InvalidTopicNameError);
ROSSPIN_NAME_ERROR(InvalidServiceNameError);
#undef ROSSPIN_NAME_ERROR

class RCLErrorBase
{
public:
  explicit RCLErrorBase(const std::string& message) : message(message), formatted_message(message) {}
  virtual ~RCLErrorBase() = default;
  std::string message, formatted_message;
};

class RCLError : public RCLErrorBase, public std::runtime_error
{
public:
  explicit RCLError(const std::string& message) : RCLErrorBase(message), std::runtime_error(message) {}
};

class RCLInvalidArgument : public RCLErrorBase, public std::invalid_argument
{
public:
  explicit RCLInvalidArgument(const std::string& message) : RCLErrorBase(message), std::invalid_argument(message) {}
};

class RCLInvalidROSArgsError : public RCLErrorBase, public std::runtime_error
{
public:
  explicit RCLInvalidROSArgsError(const std::string& message) : RCLErrorBase(message), std::runtime_error(message) {}
};

class UnknownROSArgsError : public std::runtime_error
{
public:
  explicit UnknownROSArgsError(const std::vector<std::string>& unknown)
    : std::runtime_error("found unknown ROS arguments: '" + joined(unknown) + "'"), unknown_ros_args(unknown)
  {
  }
  const std::vector<std::string> unknown_ros_args;

private:
  static std::string joined(const std::vector<std::string>& words)
  {
    std::string all;
    for (const std::string& word : words)
      all += (all.empty() ? "" : "', '") + word;
    return all;
  }
};

class InvalidNodeError : public std::runtime_error
{
public:
  InvalidNodeError() : std::runtime_error("node is invalid") {}
};

class InvalidEventError : public std::runtime_error
{
public:
  InvalidEventError() : std::runtime_error("event is invalid") {}
};

class EventNotRegisteredError : public std::runtime_error
{
public:
  EventNotRegisteredError() : std::runtime_error("event already registered") {}
};

class UnknownTypeError : public std::runtime_error
{
public:
  explicit UnknownTypeError(const std::string& type) : std::runtime_error("Unknown type: " + type) {}
};

class MissingGroupNodeException : public std::runtime_error
{
public:
  explicit MissingGroupNodeException(const std::string& kind)
    : std::runtime_error("cannot create: " + kind + " , callback group not in node")
  {
  }
};

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string& name, const std::string& message)
    : std::runtime_error("parameter '" + name + "' has invalid type: " + message)
  {
  }
};

class UninitializedStaticallyTypedParameterException : public std::runtime_error
{
public:
  explicit UninitializedStaticallyTypedParameterException(const std::string& name)
    : std::runtime_error("Statically typed parameter '" + name + "' must be initialized.")
  {
  }
};

class ParameterUninitializedException : public std::runtime_error
{
public:
  explicit ParameterUninitializedException(const std::string& name)
    : std::runtime_error("parameter '" + name + "' is not initialized")
  {
  }
};

#define ROSSPIN_EXCEPTION(Name)                                                                                        \
  class Name : public std::runtime_error                                                                               \
  {                                                                                                                    \
  public:                                                                                                              \
    using std::runtime_error::runtime_error;                                                                           \
  }
ROSSPIN_EXCEPTION(InvalidParametersException);
ROSSPIN_EXCEPTION(InvalidParameterValueException);
ROSSPIN_EXCEPTION(ParameterAlreadyDeclaredException);
ROSSPIN_EXCEPTION(ParameterNotDeclaredException);
ROSSPIN_EXCEPTION(ParameterImmutableException);
ROSSPIN_EXCEPTION(ParameterModifiedInCallbackException);
ROSSPIN_EXCEPTION(InvalidQosOverridesException);
#undef ROSSPIN_EXCEPTION
}  // namespace exceptions

class UnsupportedEventTypeException : public exceptions::RCLErrorBase, public std::runtime_error
{
public:
  explicit UnsupportedEventTypeException(const std::string& message) : RCLErrorBase(message), std::runtime_error(message)
  {
  }
};

class ContextAlreadyInitialized : public std::runtime_error
{
public:
  ContextAlreadyInitialized() : std::runtime_error("context is already initialized") {}
};
}  // namespace rclcpp

#endif

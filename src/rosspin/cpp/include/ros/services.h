// Services of roscpp and their clients. The host carries requests and responses, serialised.
#ifndef ROSSPIN_ROS_SERVICES_H
#define ROSSPIN_ROS_SERVICES_H

#include "ros/topics.h"

namespace ros
{
template<class MReq, class MRes>
class ServiceEvent
{
public:
  typedef MReq RequestType;
  typedef MRes ResponseType;
  ServiceEvent(const MReq& request, MRes& response, const std::string& caller)
    : request_(request), response_(response), caller_(caller)
  {
  }
  const MReq& getRequest() const { return request_; }
  MRes& getResponse() const { return response_; }
  const std::string& getCallerName() const { return caller_; }

private:
  const MReq& request_;
  MRes& response_;
  const std::string& caller_;
};

namespace detail
{
struct Asked
{
  std::int64_t number;
  std::string bytes, caller;
};

// A service that the node offers; `answer` makes a response of a request, or returns false.
class ServiceImpl : public Kept
{
public:
  typedef std::function<bool(const Asked& request, std::string& response)> Answer;
  ServiceImpl(const std::string& name, const char* request_type, Answer answer, Tracked tracked,
      CallbackQueueInterface* queue);
  ~ServiceImpl() override { end(); }
  void end() override;
  void receive(const Asked& request);
  std::string name;
  bool ended = false;

private:
  struct Call;
  boost::shared_ptr<Answer> answer_;
  Tracked tracked_;
  CallbackQueueInterface* queue_;
};

class ClientImpl : public Kept
{
public:
  ClientImpl(const std::string& name, bool persistent);
  void end() override { ended = true; }
  bool call(const char* request_type, const std::string& request, std::string& response);
  std::string name;
  bool persistent, ended = false, connected = false;

private:
  std::int64_t id_;
};
}  // namespace detail

class ServiceServer
{
public:
  ServiceServer() = default;
  explicit ServiceServer(boost::shared_ptr<detail::ServiceImpl> impl) : impl_(std::move(impl)) {}
  void shutdown()
  {
    if (impl_)
      impl_->end();
  }
  std::string getService() const { return *this ? impl_->name : ""; }
  operator void*() const { return impl_ && !impl_->ended ? impl_.get() : nullptr; }

private:
  boost::shared_ptr<detail::ServiceImpl> impl_;
};
typedef std::vector<ServiceServer> V_ServiceServer;

class ServiceClient
{
public:
  ServiceClient() = default;
  explicit ServiceClient(boost::shared_ptr<detail::ClientImpl> impl) : impl_(std::move(impl)) {}
  template<class MReq, class MRes>
  bool call(const MReq& request, MRes& response)
  {
    std::string bytes;
    if (!impl_ || !impl_->call(MReq::rosspin_type, serialization::serialized(request), bytes))
      return false;
    serialization::Reader reader(bytes);
    MRes::visit(response, reader);
    return true;
  }
  template<class S>
  bool call(S& service)
  {
    return call(service.request, service.response);
  }
  bool isValid() const { return impl_ && (!impl_->persistent || impl_->connected); }
  bool isPersistent() const { return impl_ && impl_->persistent; }
  bool exists();
  bool waitForExistence(Duration timeout = Duration(-1));
  void shutdown()
  {
    if (impl_)
      impl_->end();
  }
  std::string getService() const { return impl_ ? impl_->name : ""; }
  operator void*() const { return isValid() ? impl_.get() : nullptr; }

private:
  boost::shared_ptr<detail::ClientImpl> impl_;
};

struct AdvertiseServiceOptions
{
  template<class MReq, class MRes>
  void init(const std::string& name, const boost::function<bool(MReq&, MRes&)>& callback)
  {
    service = name;
    datatype = MReq::rosspin_type;
    answer = [callback](const detail::Asked& asked, std::string& bytes)
    {
      MReq request;
      MRes response;
      serialization::Reader reader(asked.bytes);
      MReq::visit(request, reader);
      bool ok = callback(request, response);
      bytes = serialization::serialized(response);
      return ok;
    };
  }
  template<class Event>
  void initBySpecType(const std::string& name, const boost::function<bool(Event&)>& callback)
  {
    typedef typename Event::RequestType MReq;
    typedef typename Event::ResponseType MRes;
    service = name;
    datatype = MReq::rosspin_type;
    answer = [callback](const detail::Asked& asked, std::string& bytes)
    {
      MReq request;
      MRes response;
      serialization::Reader reader(asked.bytes);
      MReq::visit(request, reader);
      Event event(request, response, asked.caller);
      bool ok = callback(event);
      bytes = serialization::serialized(response);
      return ok;
    };
  }
  std::string service;
  const char* datatype = "";
  detail::ServiceImpl::Answer answer;
  VoidConstPtr tracked_object;
  CallbackQueueInterface* callback_queue = nullptr;
};

namespace service
{
bool exists(const std::string& name, bool print_failure_reason);
bool waitForService(const std::string& name, Duration timeout = Duration(-1));
inline bool waitForService(const std::string& name, std::int32_t timeout_ms)
{
  return waitForService(name, Duration(timeout_ms / 1000.0));
}
}  // namespace service
}  // namespace ros

#endif

#include "server/robot/pending_plans.hpp"

#include <chrono>
#include <future>
#include <optional>
#include <utility>

namespace underway {
namespace {

class Asking {
 public:
  explicit Asking(PlanSource source) : source_(std::move(source)) {}

  Expected<Plan> operator()(const Request& request, const std::shared_ptr<const World>& world) {
    if (answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      Expected<Plan> answer = answer_.get();
      const bool is_same_start = request.start == asked_.start && request.start_mode == asked_.start_mode;
      if (is_same_start && world == asked_in_) return answer;  // else it is of another world or place
    }
    if (!answer_.valid()) {
      asked_ = request;
      asked_in_ = world;
      answer_ = std::async(std::launch::async, [this, request, world] { return source_(request, world); });
    }
    return fail(ErrorCode::kBusy, "waiting for the server's plan");
  }

 private:
  PlanSource source_;
  Request asked_;
  std::shared_ptr<const World> asked_in_;
  std::future<Expected<Plan>> answer_;  // last: waits for the thread that uses the rest
};

}  // namespace

PlanSource asking(PlanSource source) {
  return [state = std::make_shared<Asking>(std::move(source))](const Request& request,
                                                               const std::shared_ptr<const World>& world) {
    return (*state)(request, world);
  };
}

}  // namespace underway

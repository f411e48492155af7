#include "server/robot/pending_plans.hpp"

#include <chrono>
#include <future>
#include <optional>
#include <utility>

namespace underway {
namespace {

/// Whether a plan for one request will do for the other: the robot stands, but its belief moves a little.
bool isSame(const Request& a, const Request& b) {
  constexpr double kSame_m = 0.03;
  constexpr double kSame_rad = 0.05;
  return distance(a.start.position(), b.start.position()) < kSame_m &&
         std::abs(normalizedAngle(a.start.yaw - b.start.yaw)) < kSame_rad && a.start_mode == b.start_mode;
}

class Asking {
 public:
  explicit Asking(PlanSource source) : source_(std::move(source)) {}

  Expected<Plan> operator()(const Request& request, const std::shared_ptr<const World>& world) {
    if (answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      Expected<Plan> answer = answer_.get();
      if (isSame(request, asked_)) return answer;
    }
    if (!answer_.valid()) {
      asked_ = request;
      answer_ = std::async(std::launch::async, [this, request, world] { return source_(request, world); });
    }
    return fail(ErrorCode::kBusy, "waiting for the server's plan");
  }

 private:
  PlanSource source_;
  Request asked_;
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

#include "server/plan_service.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "server/convert.hpp"
#include "server/plan_workers.hpp"
#include "server/request_desk.hpp"
#include "server/wire_limits.hpp"

namespace underway {
namespace {

using dds::Clock;

std::size_t threadsOf(const PlanServiceSettings& settings) {
  return settings.threads > 0 ? settings.threads : std::max(1U, std::thread::hardware_concurrency());
}

/// A job that a worker has finished.
struct Finished {
  RequestId id;
  std::string partition;
  Expected<Given> answer;
};

}  // namespace

/// One thread, run(), owns the desk. It takes requests, hands them to the workers, gets finished ones back
/// through `finished` and replies. It sleeps at the desk, whence finished ones wake it.
struct PlanService::State {
  RequestDesk desk;
  Served served;
  PlanServiceSettings settings;
  std::mutex mutex;
  std::vector<Finished> finished;  ///< guarded by mutex
  std::atomic<bool> is_stopping{false};
  std::promise<Expected<void>> ended;
  std::shared_future<Expected<void>> end{ended.get_future()};
  PlanWorkers workers;
  std::jthread loop;  ///< last: it uses all of the above

  State(Link link, Served what, PlanHandler handler, const PlanServiceSettings& how)
      : desk(std::move(link), {how.hold, std::max<std::size_t>(how.most_robots, 1)}),
        served(std::move(what)),
        settings(how),
        workers(
            std::move(handler),
            [this](const Job& job, Expected<Given> given) { onPlanned(job, std::move(given)); },
            threadsOf(how), how.most_queued) {}

  void stop();
  void run();
  [[nodiscard]] Expected<void> serve();
  void onRequest(const underway_PlanRequest& wire);
  void onPlanned(const Job& job, Expected<Given> given);
  void postFinished();
  void reply(const RequestId& id, const std::string& partition, const Expected<Given>& answer);
};

void PlanService::State::stop() {
  is_stopping = true;
  workers.stop();
  desk.wake();
}

void PlanService::State::run() {
  Expected<void> result = serve();
  workers.stop();
  desk.flush();
  ended.set_value(std::move(result));
}

Expected<void> PlanService::State::serve() {
  Clock::time_point give_up = Clock::time_point::max();  // of replies that nobody fetches, once stopping
  while (true) {
    if (const Expected<void> woken = desk.wait(give_up); !woken) return woken;
    const bool was_stopping = is_stopping;  // what came before the end is taken below, and answered
    const Expected<void> taken =
        desk.takeNew<underway_PlanRequest>([this](const underway_PlanRequest& wire) { onRequest(wire); });
    if (!taken) return taken;
    postFinished();
    if (!was_stopping || desk.inFlight() > 0) continue;
    give_up = std::min(give_up, Clock::now() + settings.hold);
    if (!desk.isHolding() || Clock::now() >= give_up) return {};
  }
}

void PlanService::State::onRequest(const underway_PlanRequest& wire) {
  const Clock::time_point arrival = Clock::now();
  const RequestId id = idOf(wire.id);
  const std::string partition = partitionOf(wire.robot);
  const Expected<Received> received = fromWire(wire, served.robot);
  if (!received) return reply(id, partition, tl::unexpected(received.error()));
  if (is_stopping)
    return reply(id, partition, fail(ErrorCode::kCancelled, "the server is stopping: ask again later"));
  if (!workers.offer({id, partition, received->asked, arrival + received->deadline}))
    return reply(id, partition, fail(ErrorCode::kBusy, "too many requests wait: ask again later"));
  desk.begin(id);
}

/// On a worker's thread.
void PlanService::State::onPlanned(const Job& job, Expected<Given> given) {
  {
    const std::scoped_lock lock(mutex);
    finished.push_back({job.id, job.partition, std::move(given)});
  }
  desk.wake();
}

void PlanService::State::postFinished() {
  std::vector<Finished> batch;
  {
    const std::scoped_lock lock(mutex);
    batch.swap(finished);
  }
  for (const Finished& one : batch) reply(one.id, one.partition, one.answer);
}

void PlanService::State::reply(const RequestId& id, const std::string& partition,
                               const Expected<Given>& answer) {
  WireReply wire = toWire(id, served, answer);
  const std::size_t weight = wire->segments._length;
  desk.reply({id, partition, std::move(wire), weight});
}

PlanService::PlanService(std::unique_ptr<State> state) : state_(std::move(state)) {}
PlanService::PlanService(PlanService&&) noexcept = default;
PlanService& PlanService::operator=(PlanService&& other) noexcept {
  PlanService old(std::move(*this));
  state_ = std::move(other.state_);
  return *this;
}

PlanService::~PlanService() {
  if (state_ == nullptr) return;
  state_->stop();
  state_->end.wait();
}

Expected<PlanService> PlanService::start(std::shared_ptr<const Domain> domain, Served served,
                                         PlanHandler handler, const PlanServiceSettings& settings) {
  if (const std::string fault = faultOf(served); !fault.empty())
    return fail(ErrorCode::kInvalidRobot, "cannot serve " + served.robot.name + ": " + fault);
  Expected<Link> link = Link::open(std::move(domain));
  if (!link) return tl::unexpected(link.error());
  auto state = std::make_unique<State>(std::move(*link), std::move(served), std::move(handler), settings);
  if (const Expected<void> opened = state->desk.open(); !opened) return tl::unexpected(opened.error());
  state->loop = std::jthread([running = state.get()] { running->run(); });
  return PlanService(std::move(state));
}

void PlanService::stop() { state_->stop(); }

Expected<void> PlanService::wait() const { return state_->end.get(); }

}  // namespace underway

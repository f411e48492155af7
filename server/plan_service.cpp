#include "server/plan_service.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "server/convert.hpp"
#include "server/link.hpp"
#include "server/plan_workers.hpp"
#include "server/reply_post.hpp"
#include "server/wire_limits.hpp"

namespace underway {
namespace {

using dds::Clock;

// Tokens of the wait set; those of the reply writers are even.
constexpr dds_attach_t kRequestToken = 1;
constexpr dds_attach_t kGuardToken = 3;

// A burst of requests may outrun the take loop by this many; beyond, resends mend what is lost.
constexpr std::int32_t kRequestDepth = 1024;
// What is left for written replies to arrive when the service ends.
constexpr std::chrono::seconds kFlush{1};

std::size_t threadsOf(const PlanServiceSettings& settings) {
  return settings.threads > 0 ? settings.threads : std::max(1U, std::thread::hardware_concurrency());
}

/// A job that a worker has finished.
struct Finished {
  RequestId id;
  std::string partition;
  Expected<Plan> answer;
};

}  // namespace

/// One thread, run(), owns everything that talks DDS. It takes requests, hands them to the workers, gets
/// finished ones back through `finished` and posts the replies. It sleeps on the wait set; the guard
/// condition wakes it.
struct PlanService::State {
  Link link;
  dds::Entity reader;
  dds::Entity has_requests;
  dds::Entity guard;
  Served served;
  PlanServiceSettings settings;
  RequestLedger ledger;
  ReplyPost post;
  std::mutex mutex;
  std::vector<Finished> finished;  ///< guarded by mutex
  std::atomic<bool> is_stopping{false};
  std::promise<Expected<void>> ended;
  std::shared_future<Expected<void>> end{ended.get_future()};
  PlanWorkers workers;
  std::jthread loop;  ///< last: it uses all of the above

  State(Link opened, Served what, PlanHandler handler, const PlanServiceSettings& how)
      : link(std::move(opened)),
        served(std::move(what)),
        settings(how),
        post(link.participant, link.reply_topic, link.wait_set,
             {how.hold, std::max<std::size_t>(how.most_robots, 1)}),
        workers(
            std::move(handler),
            [this](const Job& job, Expected<Plan> plan) { onPlanned(job, std::move(plan)); }, threadsOf(how),
            how.most_queued) {}

  [[nodiscard]] Expected<void> open();
  void stop();
  void run();
  [[nodiscard]] Expected<void> serve();
  void onToken(dds_attach_t token);
  [[nodiscard]] Expected<void> takeRequests();
  void onRequest(const underway_PlanRequest& wire);
  void onPlanned(const Job& job, Expected<Plan> plan);
  void postFinished();
  void reply(const RequestId& id, const std::string& partition, const Expected<Plan>& answer);
};

Expected<void> PlanService::State::open() {
  FirstError first;
  reader = first.unwrap(dds::createReader(link.participant, link.request_topic, {.depth = kRequestDepth}));
  has_requests = first.unwrap(dds::createReadCondition(reader));
  guard = first.unwrap(dds::createGuardCondition(link.participant));
  first.check(link.wait_set.attach(has_requests, kRequestToken));
  first.check(link.wait_set.attach(guard, kGuardToken));
  if (first.error()) return tl::unexpected(*first.error());
  return {};
}

void PlanService::State::stop() {
  is_stopping = true;
  workers.stop();
  dds_set_guardcondition(guard.get(), true);
}

void PlanService::State::run() {
  Expected<void> result = serve();
  workers.stop();
  post.flush(Clock::now() + kFlush);
  ended.set_value(std::move(result));
}

Expected<void> PlanService::State::serve() {
  Clock::time_point give_up = Clock::time_point::max();  // of replies that nobody fetches, once stopping
  while (true) {
    const auto tokens = link.wait_set.wait(std::min(post.nextExpiry(), give_up));
    if (!tokens) return tl::unexpected(tokens.error());
    for (const dds_attach_t token : *tokens) onToken(token);
    const bool was_stopping = is_stopping;  // what came before the end is taken below, and answered
    if (const Expected<void> taken = takeRequests(); !taken) return taken;
    postFinished();
    post.expire(Clock::now());
    if (!was_stopping || ledger.inFlight() > 0) continue;
    give_up = std::min(give_up, Clock::now() + settings.hold);
    if (!post.isHolding() || Clock::now() >= give_up) return {};
  }
}

void PlanService::State::onToken(dds_attach_t token) {
  if (token == kGuardToken) {
    bool was_set = false;
    dds_take_guardcondition(guard.get(), &was_set);
  } else if (token != kRequestToken) {
    post.onMatched(token);
  }
}

/// Takes a full reader's worth at most, so that a flood of requests does not hold up the replies.
Expected<void> PlanService::State::takeRequests() {
  constexpr std::size_t kMostLoans = kRequestDepth / dds::Loan::kMost;
  bool is_empty = false;
  for (std::size_t i = 0; i < kMostLoans && !is_empty; ++i) {
    const auto loan = dds::Loan::take(reader);
    if (!loan) return tl::unexpected(loan.error());
    (*loan)->forEach<underway_PlanRequest>([this](const underway_PlanRequest& wire) { onRequest(wire); });
    is_empty = (*loan)->size() < dds::Loan::kMost;
  }
  return {};
}

void PlanService::State::onRequest(const underway_PlanRequest& wire) {
  const Clock::time_point arrival = Clock::now();
  const RequestId id = idOf(wire.id);
  if (ledger.isInFlight(id)) return;
  if (const Answer* answer = ledger.answerTo(id)) return post.send(*answer);

  const std::string partition = partitionOf(wire);
  const Expected<Received> received = fromWire(wire, served.robot);
  if (!received) return reply(id, partition, tl::unexpected(received.error()));
  if (is_stopping)
    return reply(id, partition, fail(ErrorCode::kCancelled, "the server is stopping: ask again later"));
  if (!workers.offer({id, partition, received->request, arrival + received->deadline}))
    return reply(id, partition, fail(ErrorCode::kBusy, "too many requests wait: ask again later"));
  ledger.begin(id);
}

/// On a worker's thread.
void PlanService::State::onPlanned(const Job& job, Expected<Plan> plan) {
  {
    const std::scoped_lock lock(mutex);
    finished.push_back({job.id, job.partition, std::move(plan)});
  }
  dds_set_guardcondition(guard.get(), true);
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
                               const Expected<Plan>& answer) {
  const Answer sealed{id, partition, toWire(id, served, answer)};
  ledger.finish(sealed);
  post.send(sealed);
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
  if (const Expected<void> opened = state->open(); !opened) return tl::unexpected(opened.error());
  state->loop = std::jthread([running = state.get()] { running->run(); });
  return PlanService(std::move(state));
}

void PlanService::stop() { state_->stop(); }

Expected<void> PlanService::wait() const { return state_->end.get(); }

}  // namespace underway

#include "server/change_service.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <thread>
#include <utility>

#include "server/convert_change.hpp"
#include "server/request_desk.hpp"

namespace underway {
namespace {

using dds::Clock;

/// The change, in which nothing may throw: a world that memory does not suffice for stays as it is.
Expected<Changed> changeOrTell(Planner& planner, const std::vector<WorldChange>& changes,
                               std::uint64_t if_revision) {
  try {
    return change(planner, changes, if_revision);
  } catch (const std::exception& thrown) {
    return fail(ErrorCode::kInternal, std::string("the world could not be changed: ") + thrown.what());
  }
}

}  // namespace

/// One thread, run(), owns the desk and changes the world.
struct ChangeService::State {
  RequestDesk desk;
  dds::Entity world_topic;
  dds::Entity world_writer;
  std::shared_ptr<Planner> planner;
  Log log;
  ChangeServiceSettings settings;
  std::atomic<bool> is_stopping{false};
  std::promise<Expected<void>> ended;
  std::shared_future<Expected<void>> end{ended.get_future()};
  std::jthread loop;  ///< last: it uses all of the above

  State(Link link, std::shared_ptr<Planner> whose, Log told, const ChangeServiceSettings& how)
      : desk(std::move(link), {how.hold, std::max<std::size_t>(how.most_clients, 1)}),
        planner(std::move(whose)),
        log(std::move(told)),
        settings(how) {}

  [[nodiscard]] Expected<void> open();
  void stop();
  void run();
  [[nodiscard]] Expected<void> serve();
  void onRequest(const underway_ChangeRequest& wire);
  [[nodiscard]] Expected<Changed> carryOut(const underway_ChangeRequest& wire);
  void publishWorld();
};

Expected<void> ChangeService::State::open() {
  FirstError first;
  const dds::Entity& participant = desk.link().participant;
  world_topic = first.unwrap(dds::createTopic(participant, underway_WorldState_desc, "underway/world"));
  world_writer = first.unwrap(dds::createWriter(participant, world_topic, {.is_for_latecomers = true}));
  if (first.error()) return tl::unexpected(*first.error());
  publishWorld();
  return desk.open();
}

void ChangeService::State::stop() {
  is_stopping = true;
  desk.wake();
}

void ChangeService::State::run() {
  Expected<void> result = serve();
  desk.flush();
  ended.set_value(std::move(result));
}

Expected<void> ChangeService::State::serve() {
  Clock::time_point give_up = Clock::time_point::max();  // of replies that nobody fetches, once stopping
  while (true) {
    if (const Expected<void> woken = desk.wait(give_up); !woken) return woken;
    const bool was_stopping = is_stopping;  // what came before the end is taken below, and answered
    const Expected<void> taken =
        desk.takeNew<underway_ChangeRequest>([this](const underway_ChangeRequest& wire) { onRequest(wire); });
    if (!taken) return taken;
    if (!was_stopping) continue;
    give_up = std::min(give_up, Clock::now() + settings.hold);
    if (!desk.isHolding() || Clock::now() >= give_up) return {};
  }
}

void ChangeService::State::onRequest(const underway_ChangeRequest& wire) {
  const RequestId id = idOf(wire.id);
  const Clock::time_point started = Clock::now();
  const Expected<Changed> outcome = carryOut(wire);
  const std::chrono::duration<double, std::milli> took = Clock::now() - started;
  const auto checker = planner->checker();
  if (log) log(wire.changes._length, checker->world(), outcome);
  // First, so that who has the reply finds the state.
  if (outcome && wire.changes._length > 0) publishWorld();
  WireChangeReply reply = toWire(id, checker->world(), outcome, took.count());
  desk.reply({id, partitionOf(wire.robot), std::move(reply)});
}

Expected<Changed> ChangeService::State::carryOut(const underway_ChangeRequest& wire) {
  const Expected<std::vector<WorldChange>> changes = fromWire(wire);
  if (!changes) return tl::unexpected(changes.error());
  if (is_stopping) return fail(ErrorCode::kCancelled, "the server is stopping: ask again later");
  return changeOrTell(*planner, *changes, wire.if_revision);
}

/// A refusal means that a reader does not keep up: it gets the next state.
void ChangeService::State::publishWorld() {
  const auto checker = planner->checker();
  underway_WorldState state{};
  write(checker->world(), state);
  dds_write(world_writer.get(), &state);
  dds_sample_free(&state, &underway_WorldState_desc, DDS_FREE_CONTENTS);
}

ChangeService::ChangeService(std::unique_ptr<State> state) : state_(std::move(state)) {}
ChangeService::ChangeService(ChangeService&&) noexcept = default;
ChangeService& ChangeService::operator=(ChangeService&& other) noexcept {
  ChangeService old(std::move(*this));
  state_ = std::move(other.state_);
  return *this;
}

ChangeService::~ChangeService() {
  if (state_ == nullptr) return;
  state_->stop();
  state_->end.wait();
}

Expected<ChangeService> ChangeService::start(std::shared_ptr<const Domain> domain,
                                             std::shared_ptr<Planner> planner, Log log,
                                             const ChangeServiceSettings& settings) {
  Expected<Link> link = Link::open(std::move(domain), changeTopics());
  if (!link) return tl::unexpected(link.error());
  auto state = std::make_unique<State>(std::move(*link), std::move(planner), std::move(log), settings);
  if (const Expected<void> opened = state->open(); !opened) return tl::unexpected(opened.error());
  state->loop = std::jthread([running = state.get()] { running->run(); });
  return ChangeService(std::move(state));
}

void ChangeService::stop() { state_->stop(); }

Expected<void> ChangeService::wait() const { return state_->end.get(); }

}  // namespace underway

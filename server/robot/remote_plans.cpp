#include "server/robot/remote_plans.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "server/wire_limits.hpp"

namespace underway {
namespace {

/// Between a robot's name and what it calls what it saw; no name has a dot in it.
constexpr std::string_view kSeen = ".seen_";
/// As Mission calls what was seen.
constexpr std::string_view kSeenHere = "seen_";

/// A server that says nothing in time is as good as none.
Error asNoServer(Error error) {
  if (error.code == ErrorCode::kTimeout) error.code = ErrorCode::kNoServer;
  return error;
}

Question questionOf(const Request& request, const Robot& robot, const std::string& name,
                    std::chrono::milliseconds deadline) {
  const auto named = [&](ModeId mode) { return robot.modes.at(mode).name; };
  Question question;
  question.robot = name;
  question.start = request.start;
  question.start_mode = named(request.start_mode);
  question.goal = request.goal;
  question.goal_yaw = request.goal_yaw;
  question.goal_mode = named(request.goal_mode);
  question.policy = request.policy;
  question.max_detour = request.max_detour;
  question.deadline = deadline;
  for (const Goal& goal : request.other_goals)
    question.other_goals.push_back({goal.at, goal.yaw, named(goal.mode)});
  return question;
}

}  // namespace

RemotePlans::RemotePlans(ChangeClient changes, PlanClient plans, std::string name,
                         std::shared_ptr<const World> map, std::shared_ptr<const Robot> robot,
                         const RemotePlansSettings& settings)
    : changes_(std::move(changes)),
      plans_(std::move(plans)),
      name_(std::move(name)),
      map_(std::move(map)),
      robot_(std::move(robot)),
      settings_(settings) {}

Expected<RemotePlans> RemotePlans::open(const std::shared_ptr<const Domain>& domain, std::string name,
                                        std::shared_ptr<const World> map, std::shared_ptr<const Robot> robot,
                                        const RemotePlansSettings& settings) {
  if (!isRobotName(name))
    return fail(ErrorCode::kInvalidRequest, "the robot's name must be 1 to 64 of A-Z a-z 0-9 _ -");
  auto changes = ChangeClient::open(domain, settings.client);
  if (!changes) return tl::unexpected(changes.error());
  auto plans = PlanClient::open(domain, settings.client);
  if (!plans) return tl::unexpected(plans.error());
  return RemotePlans(std::move(*changes), std::move(*plans), std::move(name), std::move(map),
                     std::move(robot), settings);
}

Expected<Plan> RemotePlans::plan(const Request& request, const World& world) {
  const Seen seen = seenIn(world);
  if (const auto told = tell(seen); !told) return tl::unexpected(told.error());
  const Question question = questionOf(request, *robot_, name_, settings_.deadline);
  auto document = askAround(question);
  if (document && !isOfToldWorld(*document)) {
    // Another has changed the world since, or the server is another one: it may have lost what we told.
    if (const auto told = tellAll(seen); !told) return tl::unexpected(told.error());
    document = askAround(question);
    if (document && !document->answer && !isOfToldWorld(*document))
      return fail(ErrorCode::kBusy, "the world is being changed: the server's answer is of another one");
  }
  if (!document) return tl::unexpected(document.error());
  if (document->robot_hash != hashOf(*robot_))
    return fail(ErrorCode::kInvalidRequest, "the server plans for another robot than \"" + robot_->name +
                                                "\": give both the same robot file");
  return std::move(document->answer);
}

void RemotePlans::forget() {
  if (has_told_ && !told_.empty()) (void)tellAll({});
}

// --- the world ---------------------------------------------------------------------------------------------

RemotePlans::Seen RemotePlans::seenIn(const World& world) const {
  Seen seen;
  for (const Obstacle& obstacle : world.obstacles())
    if (obstacle.id.starts_with(kSeenHere) && !map_->obstacles().find(obstacle.id))
      seen.emplace(name_ + "." + obstacle.id, obstacle.box);
  return seen;
}

/// Only what is new or gone; all of it if the server's world is not the one that we left.
Expected<void> RemotePlans::tell(const Seen& seen) {
  if (!has_told_) return tellAll(seen);
  std::vector<WorldChange> changes;
  for (const auto& [id, box] : told_)
    if (!seen.contains(id)) changes.push_back({WorldChange::Kind::kRemove, id});
  for (const auto& [id, box] : seen) {
    const auto there = told_.find(id);
    if (there != told_.end() && there->second == box) continue;
    const auto kind = there == told_.end() ? WorldChange::Kind::kAdd : WorldChange::Kind::kMove;
    changes.push_back({kind, id, box});
  }
  if (changes.empty()) return {};
  const Expected<void> changed = change(std::move(changes), server_.revision);
  if (changed) told_ = seen;
  const bool is_other = !changed && (changed.error().code == ErrorCode::kStaleRevision ||
                                     changed.error().code == ErrorCode::kInvalidRequest);
  return is_other ? tellAll(seen) : changed;
}

Expected<void> RemotePlans::tellAll(const Seen& seen) {
  std::vector<WorldChange> changes{{WorldChange::Kind::kRemoveAll, name_ + std::string(kSeen)}};
  for (const auto& [id, box] : seen) changes.push_back({WorldChange::Kind::kAdd, id, box});
  const Expected<void> changed = change(std::move(changes), 0);
  has_told_ = changed.has_value();
  told_ = changed ? seen : Seen{};
  return changed;
}

/// In as many requests as the wire needs.
Expected<void> RemotePlans::change(std::vector<WorldChange> changes, std::uint64_t if_revision) {
  for (std::size_t from = 0; from < changes.size(); from += kMostChanges) {
    const auto begin = changes.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end =
        changes.begin() + static_cast<std::ptrdiff_t>(std::min(from + kMostChanges, changes.size()));
    const auto answer = changes_.ask({name_, {begin, end}, if_revision});
    if (!answer) return tl::unexpected(asNoServer(answer.error()));
    if (const auto same = checkMap(answer->world); !same) return same;
    if (!answer->repaired) return tl::unexpected(answer->repaired.error());
    server_ = answer->world;
    if (if_revision != 0) if_revision = server_.revision;
  }
  return {};
}

Expected<void> RemotePlans::checkMap(const WorldNow& world) const {
  // Later revisions differ by what was changed; the first is the map itself.
  const bool is_same = world.map_name == map_->name() && (world.revision != 1 || world.hash == map_->hash());
  if (is_same) return {};
  const std::string which = world.map_name == map_->name()
                                ? "a map \"" + world.map_name + "\" that differs from this one"
                                : "map \"" + world.map_name + "\", not \"" + map_->name() + "\"";
  return fail(ErrorCode::kInvalidRequest,
              "the server plans in " + which + ": give --map the file that the server uses");
}

// --- the plan ----------------------------------------------------------------------------------------------

bool RemotePlans::isOfToldWorld(const PlanDocument& document) const {
  return document.revision == server_.revision && document.world_hash == server_.hash;
}

Expected<PlanDocument> RemotePlans::ask(const Question& question) {
  auto document = plans_.ask(question);
  if (!document) return tl::unexpected(asNoServer(document.error()));
  return document;
}

/// Takes away what others saw where this robot stands, a few obstacles at a time, as the server names them.
Expected<PlanDocument> RemotePlans::askAround(const Question& question) {
  constexpr int kMostTimes = 32;
  auto document = ask(question);
  for (int i = 0; i < kMostTimes && document && !document->answer; ++i) {
    std::vector<WorldChange> others = othersIn(document->answer.error());
    if (others.empty()) break;
    if (const auto gone = change(std::move(others), 0); !gone) break;
    document = ask(question);
  }
  return document;
}

std::vector<WorldChange> RemotePlans::othersIn(const Error& error) const {
  std::vector<WorldChange> others;
  if (error.code != ErrorCode::kStartInCollision) return others;
  for (const Blocking& blocking : error.blocking) {
    const std::size_t dot = blocking.obstacle.find(kSeen);
    if (dot == std::string::npos || !isRobotName(blocking.obstacle.substr(0, dot))) continue;
    if (!blocking.obstacle.starts_with(name_ + "."))
      others.push_back({WorldChange::Kind::kRemove, blocking.obstacle});
  }
  return others;
}

}  // namespace underway

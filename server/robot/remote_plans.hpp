#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "local/mission.hpp"
#include "server/change_client.hpp"
#include "server/client.hpp"

namespace underway {

struct RemotePlansSettings {
  std::chrono::milliseconds deadline{5000};  ///< of each plan, at the server
  PlanClientSettings client;
};

/// A PlanSource that asks a server. What the robot saw goes into the server's world first, as obstacles whose
/// ids begin with the robot's name, so that robots do not take each other's; then a plan is asked for, which
/// has to be of a world with them.
///
/// What a robot was told to be in the way of another is often the other itself. So who cannot start because
/// it stands in what others saw takes that away: it stands there. Thread safety: none.
class RemotePlans {
 public:
  /// `map` and `robot` are what the server plans in and for; an answer about others is refused. Errors:
  /// kInvalidRequest for a name that cannot be a robot's, kInternal when DDS refuses.
  [[nodiscard]] static Expected<RemotePlans> open(const std::shared_ptr<const Domain>& domain,
                                                  std::string name, std::shared_ptr<const World> map,
                                                  std::shared_ptr<const Robot> robot,
                                                  const RemotePlansSettings& settings = {});

  /// As PlanSource says: a plan in a world that is the map and what was seen. Errors besides the planner's:
  /// kNoServer, also for one that does not answer in time; kInvalidRequest when the server has another map or
  /// robot.
  [[nodiscard]] Expected<Plan> plan(const Request& request, const World& world);

  /// Takes what this robot saw out of the server's world again: call at the end.
  void forget();

 private:
  RemotePlans(ChangeClient changes, PlanClient plans, std::string name, std::shared_ptr<const World> map,
              std::shared_ptr<const Robot> robot, const RemotePlansSettings& settings);

  using Seen = std::map<std::string, OrientedBox>;  // by the id it has at the server
  [[nodiscard]] Seen seenIn(const World& world) const;
  [[nodiscard]] Expected<void> tell(const Seen& seen);
  [[nodiscard]] Expected<void> tellAll(const Seen& seen);
  [[nodiscard]] Expected<void> change(std::vector<WorldChange> changes, std::uint64_t if_revision);
  [[nodiscard]] Expected<void> checkMap(const WorldNow& world) const;
  [[nodiscard]] Expected<PlanDocument> ask(const Question& question);
  [[nodiscard]] Expected<PlanDocument> askAround(const Question& question);
  [[nodiscard]] std::vector<WorldChange> othersIn(const Error& error) const;
  [[nodiscard]] bool isOfToldWorld(const PlanDocument& document) const;

  ChangeClient changes_;
  PlanClient plans_;
  std::string name_;
  std::shared_ptr<const World> map_;
  std::shared_ptr<const Robot> robot_;
  RemotePlansSettings settings_;
  bool has_told_ = false;
  Seen told_;        // what the server's world has of ours
  WorldNow server_;  // its world after we told it
};

}  // namespace underway

#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// A roadmap under construction: places, and the connections between them. Freezing it works out the
/// headings, the turns between them and the directed edges.
///
/// A draft may lie over a frozen roadmap; the base's places can then be connected to like its own.
class Draft {
 public:
  using PlaceId = Roadmap::PlaceId;

  Draft(const Robot& robot, std::shared_ptr<const Roadmap> base = nullptr);

  /// A position in a mode, with no heading yet. Motions there keep `keep_m`.
  PlaceId addPlace(ModeId mode, Point at, double keep_m);
  /// Lowers what is kept at a place: where a goal is, a start may be too.
  void keepLess(PlaceId place, double keep_m);
  /// A heading that is not there for a connection's sake: a start's or a goal's.
  void addHeading(PlaceId place, double yaw);
  /// Translations between two places of one mode at a heading, in `sense` from a to b and back again the
  /// opposite way, as far as the mode has these senses.
  void addTranslation(PlaceId a, PlaceId b, double yaw, Sense sense);
  /// A switch from a heading of one place to a heading of another.
  void addSwitch(PlaceId from, double from_yaw, PlaceId to, double to_yaw);
  /// Two places at one position, in modes that change into each other where they stand: each connection of
  /// the second is also a heading of the first, with a switch there.
  void addTwins(PlaceId first, PlaceId second);

  [[nodiscard]] ModeId modeOf(PlaceId place) const { return at(place).mode; }
  [[nodiscard]] Point positionOf(PlaceId place) const { return at(place).at; }
  [[nodiscard]] double keepOf(PlaceId place) const { return at(place).keep_m; }
  [[nodiscard]] PlaceId placeCount() const { return first_own_ + static_cast<PlaceId>(own_.size()); }
  /// Whether connections lead from one place to the other, taken both ways. Of the draft's own places.
  [[nodiscard]] bool areJoined(PlaceId a, PlaceId b) { return rootOf(a) == rootOf(b); }
  /// A heading the place already has that differs by no more than a tolerance [rad], to be used in place of a
  /// new one.
  [[nodiscard]] std::optional<double> headingNear(PlaceId place, double yaw, double tolerance_rad) const;

  /// When connections are checked: before the roadmap is made, or by the search that wants to use them.
  enum class Check { kNow, kWhenUsed };
  /// The roadmap. With kNow whoever added a translation has checked it, and turns and switches are checked
  /// here and left out if they are not free; with kWhenUsed nothing is. Empty when interrupted.
  [[nodiscard]] std::optional<Roadmap> freeze(const Checker& checker, Check check,
                                              Interrupt& interrupt) const;

 private:
  struct Link {
    MotionKind kind;
    PlaceId from;
    PlaceId to;
    double from_yaw;
    double to_yaw;
    Sense sense;
  };
  struct Own {
    Roadmap::Place place;
    std::vector<double> headings;
    PlaceId parent;  // in the forest of joined places (union-find); its own number at a root
  };

  friend class Freezer;
  [[nodiscard]] const Roadmap::Place& at(PlaceId place) const {
    return place < first_own_ ? base_->places[place] : own_[place - first_own_].place;
  }
  std::vector<double>& headingsOf(PlaceId place);
  void addLink(const Link& link);
  void join(PlaceId a, PlaceId b);
  [[nodiscard]] PlaceId rootOf(PlaceId place);

  const Robot& robot_;
  std::shared_ptr<const Roadmap> base_;
  PlaceId first_own_;
  std::vector<Own> own_;
  std::unordered_map<PlaceId, std::vector<double>> base_headings_;  // added to places of the base
  std::vector<Link> links_;
  std::vector<std::pair<PlaceId, PlaceId>> twins_;
};

}  // namespace underway

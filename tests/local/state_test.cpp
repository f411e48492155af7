#include "local/state.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace underway {
namespace {

struct Step {
  const char* why;
  State from;
  Situation is;
  State to;
};

Situation with(Next next) {
  Situation is;
  is.has_plan = true;
  is.next = next;
  return is;
}
template <class Change>
Situation with(Next next, const Change& change) {
  Situation is = with(next);
  change(is);
  return is;
}

const auto kSettled = [](Situation& is) { is.is_settled = true; };
const auto kLost = [](Situation& is) { is.is_lost = true; };
const auto kBlocked = [](Situation& is) { is.is_blocked = true; };
const auto kAligned = [](Situation& is) { is.is_aligned = true; };
const auto kSwitching = [](Situation& is) { is.is_switching = true; };
const auto kRoomUp = [](Situation& is) { is.has_room_up = true; };
const auto kStalled = [](Situation& is) { is.is_stalled = true; };

const std::vector<Step> kSteps{
    {"a plan that begins standing is begun by finding out where it is", State::kIdle, with(Next::kMove),
     State::kSettling},
    {"a plan that begins lying needs no lidar", State::kIdle, with(Next::kCrawl), State::kCrawling},
    {"a plan that begins with getting up looks for room first", State::kIdle, with(Next::kUp),
     State::kCrawling},
    {"it stands until it knows where it is", State::kSettling, with(Next::kMove), State::kSettling},
    {"then it walks", State::kSettling, with(Next::kMove, kSettled), State::kWalking},
    {"or aligns, if it has to go down here", State::kSettling, with(Next::kDown, kSettled), State::kAligning},
    {"or is there", State::kSettling, with(Next::kNothing, kSettled), State::kArrived},
    {"it walks on", State::kWalking, with(Next::kMove), State::kWalking},
    {"it aligns before a low passage", State::kWalking, with(Next::kDown), State::kAligning},
    {"it arrives when the plan ends", State::kWalking, with(Next::kNothing), State::kArrived},
    {"it stops where something blocks the segment", State::kWalking, with(Next::kMove, kBlocked),
     State::kBlocked},
    {"it stops when localisation is silent", State::kWalking, with(Next::kMove, kLost), State::kLost},
    {"lost counts before blocked", State::kWalking,
     with(Next::kMove,
          [](Situation& is) {
            is.is_lost = true;
            is.is_blocked = true;
          }),
     State::kLost},
    {"it aligns until it is aligned", State::kAligning, with(Next::kDown), State::kAligning},
    {"then it goes down", State::kAligning, with(Next::kDown, kAligned), State::kGoingDown},
    {"it does not lie down on what came into the passage", State::kAligning,
     with(Next::kDown,
          [](Situation& is) {
            is.is_aligned = true;
            is.is_blocked = true;
          }),
     State::kBlocked},
    {"nor without knowing where", State::kAligning, with(Next::kDown, kLost), State::kLost},
    {"going down is not left half way", State::kGoingDown, with(Next::kDown, kSwitching), State::kGoingDown},
    {"nor given up because localisation is silent", State::kGoingDown,
     with(Next::kDown,
          [](Situation& is) {
            is.is_switching = true;
            is.is_lost = true;
          }),
     State::kGoingDown},
    {"lying, it crawls", State::kGoingDown, with(Next::kCrawl), State::kCrawling},
    {"it crawls without localisation", State::kCrawling, with(Next::kCrawl, kLost), State::kCrawling},
    {"it gets up at the end where there is room", State::kCrawling, with(Next::kUp, kRoomUp),
     State::kGettingUp},
    {"it does not get up before the end, room or not", State::kCrawling, with(Next::kCrawl, kRoomUp),
     State::kCrawling},
    {"without room it crawls on", State::kCrawling, with(Next::kUp), State::kCrawling},
    {"until it cannot", State::kCrawling, with(Next::kUp, kStalled), State::kStalled},
    {"a cycle that does not end is a stall", State::kCrawling, with(Next::kCrawl, kStalled), State::kStalled},
    {"a plan may end lying", State::kCrawling, with(Next::kNothing), State::kArrived},
    {"getting up is not left half way", State::kGettingUp, with(Next::kUp, kSwitching), State::kGettingUp},
    {"standing again, it finds out where it is", State::kGettingUp, with(Next::kMove), State::kSettling},
    {"also if that is all", State::kGettingUp, with(Next::kNothing), State::kSettling},
    {"a change that does not come is a stall", State::kGoingDown, with(Next::kDown, kStalled),
     State::kStalled},
    {"up as down", State::kGettingUp, with(Next::kUp, kStalled), State::kStalled},
    {"lost while it settles, it is lost", State::kSettling, with(Next::kMove, kLost), State::kLost},
    {"settled lying, it crawls", State::kSettling, with(Next::kCrawl, kSettled), State::kCrawling},
    {"aligned with what is no passage any more, it walks", State::kAligning, with(Next::kMove),
     State::kWalking},
    {"or is there", State::kAligning, with(Next::kNothing), State::kArrived},
    {"from a passage that ends standing it goes on by finding out where it is", State::kCrawling,
     with(Next::kMove), State::kSettling},
    {"lost, it stands", State::kLost, with(Next::kMove, kLost), State::kLost},
    {"until localisation is back", State::kLost, with(Next::kMove), State::kSettling},
    {"blocked, it waits for a new plan", State::kBlocked, with(Next::kMove), State::kBlocked},
    {"stalled, it waits for help", State::kStalled, with(Next::kUp, kRoomUp), State::kStalled},
    {"arrived, it stays", State::kArrived, with(Next::kNothing), State::kArrived},
    {"fallen, it waits for a new plan, standing or not", State::kFallen, with(Next::kMove, kSettled),
     State::kFallen},
};

TEST(States, FollowEachOtherAsTheTableSays) {
  for (const Step& step : kSteps)
    EXPECT_EQ(transition(step.from, step.is), step.to)
        << step.why << ": from " << name(step.from) << " to " << name(transition(step.from, step.is));
}

TEST(States, AllEndInFallenWhenTheRobotFalls) {
  for (int state = 0; state <= static_cast<int>(State::kStalled); ++state) {
    Situation is = with(Next::kMove);
    is.has_fallen = true;
    EXPECT_EQ(transition(static_cast<State>(state), is), State::kFallen);
  }
}

TEST(States, AllButArrivedAreIdleWithoutAPlan) {
  for (int state = 0; state <= static_cast<int>(State::kStalled); ++state) {
    const auto from = static_cast<State>(state);
    EXPECT_EQ(transition(from, {}), from == State::kArrived ? State::kArrived : State::kIdle);
  }
}

TEST(States, HaveATransitionInTheTableEach) {
  std::set<State> left;
  for (const Step& step : kSteps) left.insert(step.from);
  EXPECT_EQ(left.size(), static_cast<std::size_t>(State::kStalled) + 1);
}

TEST(States, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int state = 0; state <= static_cast<int>(State::kStalled); ++state)
    names.insert(name(static_cast<State>(state)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(State::kStalled) + 1);
}

}  // namespace
}  // namespace underway

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "planner/cost.hpp"

namespace underway {

/// No state, no room.
inline constexpr std::uint32_t kNoState = 0xffffffff;

/// What is known about a state: a pose in a mode, come to by a way of a link; the first is the start.
struct SearchState {
  Cost cost = Cost::most();
  std::uint32_t parent = kNoState;
  std::uint32_t room = kNoState;  // how far it can turn, if that is known
  std::uint32_t search = 0;       // the search that wrote this: what another one did counts as nothing
  std::uint16_t is_settled = 0;
  std::uint16_t is_surpassed = 0;
};

/// The states of a thread's searches, one after the other: to clear them each time would take longer than
/// most searches.
class StateTable {
 public:
  using Id = std::uint32_t;

  /// Forgets what was there.
  void begin(std::size_t count) {
    if (states_.size() < count) states_.resize(count);
    if (++search_ == 0) std::fill(states_.begin(), states_.end(), SearchState()), search_ = 1;
  }
  SearchState& operator[](Id id) {
    SearchState& state = states_[id];
    if (state.search != search_) {
      state = SearchState();
      state.search = search_;
    }
    return state;
  }

 private:
  std::vector<SearchState> states_;
  std::uint32_t search_ = 0;
};

}  // namespace underway

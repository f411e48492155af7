#pragma once

#include <string>

#include "planner/planner.hpp"

namespace underway {

/// The file of --roadmap, in which a roadmap outlives the program. Says on standard error what was done with
/// it; whatever is wrong with it, the roadmap is grown anew and all goes on.
class RoadmapStore {
 public:
  /// An empty name: no file, and nothing is done.
  explicit RoadmapStore(std::string file) : file_(std::move(file)) {}

  /// If the file is there. Before the planner has grown anything.
  void loadInto(Planner& planner);
  /// If the planner has more, or other, than the file. Never over a file that is no roadmap.
  void saveFrom(const Planner& planner);

 private:
  void tell(const std::string& what) const;

  std::string file_;
  std::string kept_;  // what the file holds, as far as known
  bool is_ours_ = true;
};

}  // namespace underway

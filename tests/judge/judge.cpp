#include "tests/judge/judge.hpp"

#include "tests/judge/document.hpp"
#include "tests/judge/kinematics.hpp"
#include "tests/judge/room.hpp"

namespace judge {

Verdict judgePlan(std::string_view plan, const Scene& scene, const RobotFile& robot) {
  Verdict verdict;
  const auto document = readDocument(plan, verdict.violations);
  if (!document) return verdict;
  if (document->status != "ok") {
    judgeRefusal(*document, scene, robot, verdict);
    return verdict;
  }
  judgeKinematics(*document, scene, robot, verdict);
  // A motion the robot does not have leads nowhere that could be measured.
  if (verdict.isSound()) judgeRoom(*document, scene, robot, verdict);
  return verdict;
}

}  // namespace judge

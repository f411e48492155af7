#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <utility>
#include <vector>

#include "server/change_client.hpp"
#include "server/change_service.hpp"
#include "tests/planner/fixture.hpp"
#include "tests/server/plan_fixture.hpp"

namespace underway::fixture {

constexpr std::chrono::seconds kPatience{60};  // for what must happen: long, for slow machines

/// The world of a real planner, changed over real DDS.
struct ChangeServiceTest : testing::Test {
  std::shared_ptr<const Domain> domain = openDomain();
  std::shared_ptr<Planner> planner = std::make_shared<Planner>(test::ourWorld("scenario3"), test::nao());
  ChangeService dut = ChangeService::start(domain, planner, {}, {.hold = kPatience}).value();

  [[nodiscard]] ChangeClient client() const {
    return ChangeClient::open(domain, {.discovery = kPatience}).value();
  }
  [[nodiscard]] std::uint64_t revision() const { return planner->checker()->world().revision(); }
};

inline ChangeAnswer ask(ChangeClient& client, std::vector<WorldChange> changes,
                        std::uint64_t if_revision = 0) {
  Expected<ChangeAnswer> answer = client.ask({"operator", std::move(changes), if_revision}, kPatience);
  EXPECT_TRUE(answer.has_value()) << answer.error().message;
  return std::move(*answer);
}

}  // namespace underway::fixture

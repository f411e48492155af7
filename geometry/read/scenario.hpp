#pragma once

#include "geometry/error.hpp"
#include "geometry/map.hpp"
#include "geometry/read/yaml.hpp"

namespace underway {

/// Whether a YAML file begins like a scenario: it has one of its keys.
[[nodiscard]] bool isScenario(const YamlValue& root);

/// The world and the queries of a scenario. Errors: kInvalidMap, one sentence with file and line.
[[nodiscard]] Expected<Map> mapFromScenario(YamlFile& yaml, const MapOptions& options);

}  // namespace underway

#pragma once

#include <filesystem>
#include <functional>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

struct PeerOptions {
  std::filesystem::path
      peers;  ///< folder with ilab.csv and utexas_gdc_3ne.csv: queries, and what peers made of them
  std::filesystem::path
      maps2d;          ///< folder with gt_rail/ and utexas_gdc_3ne/; empty: maps/maps2d beside `peers`
  bool quick = false;  ///< the first fifth of the queries
};

/// Queries on two real buildings that other planners have answered: how long the roadmap takes, how many are
/// solved, how long a warm query takes, and what the plans cost against SBPL's best in one second and against
/// the best of all peers; and, if not quick, how much better a plan could be (the oracle). One mode that
/// walks at .1 m/s to all four sides and turns at .5 rad/s, no margin; the cost is the time. Errors:
/// kInvalidMap, with the file.
[[nodiscard]] Expected<Report> peerQueries(const PeerOptions& options,
                                           const std::function<void(double)>& progress);

}  // namespace underway::bench

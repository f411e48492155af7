#include "gait/crawl/push.hpp"

namespace underway::gait {

Cubic cubicThrough(double from, double to, double from_rate, double to_rate) {
  const double rise = to - from;
  return {{from, from_rate, 3.0 * rise - 2.0 * from_rate - to_rate, from_rate + to_rate - 2.0 * rise}};
}

Cubic line(double from, double to) { return {{from, to - from, 0.0, 0.0}}; }

PushShape nominalPush() {
  return {line(radians(16.5), radians(16.5)), line(radians(27.5), radians(27.5)),
          line(radians(-30.0), radians(-90.0))};
}

PushShape thesisOptimum() {
  return {{{0.28798, -0.3267, 0.0893, 0.2365}},
          {{0.47997, -1.7434, -0.1365, 1.8796}},
          {{-0.52360, -1.9898, 1.1570, -0.2134}}};
}

PushShape physicsOptimum() {
  return {{{-0.019771, 5.196510, -10.897268, 5.633263}},
          {{0.483456, -6.000000, 7.928225, -2.209528}},
          {{-0.523599, -3.028399, 6.010999, -4.029797}}};
}

}  // namespace underway::gait

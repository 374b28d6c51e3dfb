#pragma once

#include <string>

#include "stages/bench_stages.h"

namespace aeolic {

/// For people: at most 110 columns, what the numbers mean below.
std::string stagesTable(const StagesBenchPlan& plan, const StagesBench& bench);

/// For programs: machine, gather_rates (null off the cpu backend), scene, rows.
std::string stagesJson(const StagesBenchPlan& plan, const StagesBench& bench);

}  // namespace aeolic

#pragma once

#include <string>

#include "codecs/bench_codecs.h"

namespace aeolic {

/// For people: at most 110 columns, what the numbers mean below.
std::string codecsTables(const CodecsBenchPlan& plan, const CodecsBench& bench);

/// For programs: machine, scene, rows with both ways of each codec.
std::string codecsJson(const CodecsBenchPlan& plan, const CodecsBench& bench);

}  // namespace aeolic

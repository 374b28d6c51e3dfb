#pragma once

#include <functional>

#include "data/load/agreement.h"

namespace aeolic {

/// Collective. Runs `action`, which is Local and asks about files (data/reading/file_questions.h), on every rank. The
/// first rank of each host goes first. The others know what it was answered, so a host starts one reader for all of its
/// ranks. Where it throws on any rank, every rank throws that error.
void askOncePerHost(Agreement& agreement, const std::function<void()>& action);

}  // namespace aeolic

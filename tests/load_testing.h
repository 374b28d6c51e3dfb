#pragma once

/// Scenes that ranks load together, each rank a thread of this process.

#include <vector>

#include "cluster/composite/communicator_agreement.h"
#include "data/load/loaded_scene.h"
#include "ranks/thread_communicator.h"

namespace aeolic::testkit {

/// Collective. One rank's part, split as the description says.
inline Scene loadOnRank(Communicator& communicator, const SceneDescription& description)
{
    CommunicatorAgreement agreement(communicator);
    return loadScene(description, splitOf(description, agreement, communicator.size()), agreement);
}

/// The parts of all ranks.
inline std::vector<Scene> loadParts(const SceneDescription& description, const Split& split, int ranks)
{
    std::vector<Scene> parts(std::size_t(ranks), Scene{});
    runRanks(ranks, [&](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        parts[std::size_t(communicator.rank())] = loadScene(description, split, agreement);
    });
    return parts;
}

}  // namespace aeolic::testkit

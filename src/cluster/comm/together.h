#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Marks an error that every rank throws: all can end by themselves, and one of them says why. Any other error is one
/// rank's alone while the others wait for it, so that rank has to call Communicator::abortJob().
struct Agreed {
    virtual ~Agreed() = default;
};

/// Collective. Runs `action` on every rank and waits for all. Where it threw on any, every rank throws the error of the
/// lowest of them (InputError stays InputError, anything else becomes std::runtime_error): one message can be printed,
/// and nobody is left waiting. It names that rank, where `namesRank` and unless all failed alike. `action` itself must
/// not be collective.
void runTogether(Communicator& communicator, const std::function<void()>& action, bool namesRank = true);

/// Local. Runs `action`. An InputError says instead what `told` makes of its text; an Agreed one stays Agreed.
void retelling(const std::function<void()>& action, const std::function<std::string(std::string)>& told);

/// Collective. Throws an Agreed InputError on every rank, naming `what` and the first rank that differs from rank 0,
/// unless `value` is the same everywhere. So a difference shows at the start instead of in the picture. From a long
/// value (a scene) the first line that differs is quoted.
void requireSame(Communicator& communicator, const std::string& what, const std::string& value);

/// Collective. runTogether() at the begin of a call that every rank makes with the same arguments: where the names of
/// the calls or the arguments differ, all ranks throw what requireSame() does, and not what `action` threw. `arguments`
/// gives a text with a line for each. `action` must change nothing: where ranks differ it ran all the same. Cost where
/// all is well: ⌈log2 size⌉ messages of 24 bytes a rank, and the text.
void callTogether(Communicator& communicator, const char* call, const std::function<std::string()>& arguments,
                  const std::function<void()>& action);

/// Collective. Every rank's texts, by rank, each text once.
std::vector<std::string> distinctOfAll(Communicator& communicator, const std::vector<std::string>& mine);

}  // namespace aeolic

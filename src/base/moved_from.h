#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace aeolic {

/// What an object of the interface holds. Throws std::logic_error where it was moved into another one.
template <class State>
State& heldBy(const std::unique_ptr<State>& state, const char* type)
{
    if (!state) throw std::logic_error(std::string("this ") + type + " was moved into another one");
    return *state;
}

}  // namespace aeolic

#pragma once

#include <string>
#include <vector>

#include "aeolic/live.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// A program's controls and their values. Every rank has the same.
class Controls {
public:
    /// Throws InputError for names that are empty, too long or the same, for ranges that hold nothing, and for values
    /// outside of them.
    Controls(std::string title, std::vector<Control> controls);

    /// Throws std::out_of_range.
    double value(const std::string& name) const { return find(name).value; }
    /// Throws std::out_of_range. A number is kept within its range, a switch becomes 0 or 1.
    void set(const std::string& name, double value);

    /// Takes what a viewer asks for: a number for each name. Throws InputError, and changes nothing, for a name that
    /// there is not and for a value out of range.
    void apply(const Json& asked);

    /// What the page is told: {"title":…, "controls":[…]}.
    Json toJson() const;

private:
    const Control& find(const std::string& name) const;

    std::string title_;
    std::vector<Control> controls_;
};

}  // namespace aeolic::stream

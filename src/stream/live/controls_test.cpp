#include "stream/live/controls.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

using Kind = Control::Kind;

Control number(const std::string& name, double value = 1, double lo = 0, double hi = 2)
{
    return {name, Kind::number, value, lo, hi, "m/s"};
}

std::string complaint(const std::vector<Control>& controls)
{
    try {
        Controls("Solver", controls);
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

std::string complaintOf(Controls& controls, const std::string& asked)
{
    try {
        controls.apply(Json::parse(asked));
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

TEST(Controls, ThoseThatAreNoneAreRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint({number("a"), number("b")}), "taken");
    EXPECT_EQ(complaint({number("")}), "control: found a name of 0 bytes; expected 1 to 64");
    EXPECT_EQ(complaint({number(std::string(65, 'x'))}), "control: found a name of 65 bytes; expected 1 to 64");
    EXPECT_EQ(complaint({number("a"), number("a")}), "control a: found twice; expected names that are different");
    EXPECT_EQ(complaint({number("a", 1, 2, 2)}),
              "control a: found 2 to 2; expected a range of finite numbers, the smaller one first");
    EXPECT_NE(complaint({number("a", 1, nan, 2)}), "taken");
    Control odd = number("a");
    odd.kind = Control::Kind(1000000);
    EXPECT_EQ(complaint({odd}), "control a: found kind 1000000; expected number, toggle or button");
    EXPECT_EQ(complaint({number("a", 3)}), "control a: found 3; expected a number from 0 to 2");
    EXPECT_NE(complaint({number("a", nan)}), "taken");
    EXPECT_EQ(complaint({{"t", Kind::toggle, 0.5, 0, 1, ""}}), "control t: found 0.5; expected 0 or 1");
    EXPECT_NE(complaint({{"b", Kind::button, -1, 0, 1, ""}}), "taken");
    EXPECT_EQ(complaint(std::vector<Control>(65, number("a"))), "controls: found 65; expected at most 64");
}

TEST(Controls, AViewerSetsThemWithinTheirRangesOrNotAtAll)
{
    Controls controls("Solver",
                      {number("speed"), {"pause", Kind::toggle, 0, 0, 1, ""}, {"step", Kind::button, 0, 0, 1, ""}});
    EXPECT_EQ(complaintOf(controls, R"({"speed":0.5,"pause":1,"step":3})"), "taken");
    EXPECT_EQ(controls.value("speed"), 0.5);
    EXPECT_EQ(controls.value("pause"), 1);
    EXPECT_EQ(controls.value("step"), 3);
    EXPECT_EQ(complaintOf(controls, R"({"speed":1.5,"step":-1})"),
              "control step: found -1; expected how often it was pressed");
    EXPECT_EQ(controls.value("speed"), 0.5) << "one wrong value, and nothing is set";
    EXPECT_EQ(complaintOf(controls, R"({"sped":1})"),
              "change: steer: found 'sped'; expected a control of the program; did you mean speed?");
    EXPECT_NE(complaintOf(controls, R"({"pause":2})"), "taken");
    EXPECT_NE(complaintOf(controls, R"({"speed":1e300})"), "taken");
}

TEST(Controls, TheProgramSetsThemAndIsKeptWithinTheirRanges)
{
    Controls controls("Solver", {number("speed"), {"pause", Kind::toggle, 0, 0, 1, ""}});
    controls.set("speed", 9);
    EXPECT_EQ(controls.value("speed"), 2);
    controls.set("speed", std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(controls.value("speed"), 2);
    controls.set("pause", 7);
    EXPECT_EQ(controls.value("pause"), 1);
    EXPECT_THROW(controls.set("none", 1), std::out_of_range);
    EXPECT_THROW(controls.value("none"), std::out_of_range);
    EXPECT_EQ(controls.toJson()["title"], "Solver");
    EXPECT_EQ(controls.toJson()["controls"][0].dump(),
              R"({"name":"speed","kind":"number","value":2.0,"lo":0.0,"hi":2.0,"unit":"m/s"})");
}

}  // namespace
}  // namespace aeolic::stream

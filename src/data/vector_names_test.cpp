#include "data/vector_names.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

std::vector<std::string> joined(const std::vector<std::string>& names, bool flat = false)
{
    std::vector<std::string> texts;
    for (const NamedComponents& each : joinComponents(names, flat)) {
        std::string text = each.name;
        for (const std::size_t i : each.of) text += " " + std::to_string(i);
        texts.push_back(text);
    }
    return texts;
}

using Texts = std::vector<std::string>;

TEST(VectorNames, CountedComponentsWhereThreeAreAll)
{
    const auto counted = [](const std::vector<std::string>& names) {
        Texts texts;
        for (const NamedComponents& each : joinComponents(names, false, true))
            texts.push_back(each.name + " " + std::to_string(each.of.size()));
        return texts;
    };
    EXPECT_EQ(counted({"vel_0", "vel_1", "vel_2", "p"}), (Texts{"vel 3", "p 1"}));
    EXPECT_EQ(counted({"U[2]", "U[1]", "U[0]", "U:0"}), (Texts{"U 3", "U:0 1"}));
    EXPECT_EQ(counted({"c_0", "c_1", "c_2", "c_3"}), (Texts{"c_0 1", "c_1 1", "c_2 1", "c_3 1"}));
    EXPECT_EQ(counted({"c0", "c1", "c2"}), (Texts{"c0 1", "c1 1", "c2 1"}));
    EXPECT_EQ(joined({"vel_0", "vel_1", "vel_2"}), (Texts{"vel_0 0", "vel_1 1", "vel_2 2"}));
}

TEST(VectorNames, WaysToNameThreeComponents)
{
    EXPECT_EQ(joined({"Pressure", "VelocityX", "VelocityY", "VelocityZ"}), (Texts{"Pressure 0", "Velocity 1 2 3"}));
    EXPECT_EQ(joined({"vel_z", "vel_y", "vel_x", "p"}), (Texts{"vel 2 1 0", "p 3"}));
    EXPECT_EQ(joined({"x-velocity", "y-velocity", "z-velocity"}), (Texts{"velocity 0 1 2"}));
    EXPECT_EQ(joined({"X Wall Shear", "Y Wall Shear", "Z Wall Shear"}), (Texts{"Wall Shear 0 1 2"}));
    EXPECT_EQ(joined({"Tau[X]", "Tau[Y]", "Tau[Z]"}), (Texts{"Tau 0 1 2"}));
    EXPECT_EQ(joined({"u", "v", "w", "U"}), (Texts{"uvw 0 1 2", "U 3"}));
}

TEST(VectorNames, WhatIsIncompleteStaysAsItIs)
{
    EXPECT_EQ(joined({"VelocityX", "VelocityY", "Velocityz"}), (Texts{"VelocityX 0", "VelocityY 1", "Velocityz 2"}));
    EXPECT_EQ(joined({"x", "y", "z", "", "_x"}), (Texts{"x 0", "y 1", "z 2", " 3", "_x 4"}));
    EXPECT_EQ(joined({"aX", "aX", "aY", "aZ"}), (Texts{"a 0 2 3", "aX 1"}));
    EXPECT_EQ(joined({"VelocityX", "VelocityY"}), (Texts{"VelocityX 0", "VelocityY 1"}));
    EXPECT_EQ(joined({"VelocityX", "VelocityY"}, true), (Texts{"Velocity 0 1"}));
}

TEST(VectorNames, TwoOfOneNameStayApart)
{
    EXPECT_EQ(joined({"p", "pX", "pY", "pZ"}), (Texts{"p 0", "pXYZ 1 2 3"}));
    EXPECT_EQ(joined({"vX", "vY", "vZ", "v_x", "v_y", "v_z"}), (Texts{"v 0 1 2", "vXYZ 3 4 5"}));
}

}  // namespace
}  // namespace aeolic

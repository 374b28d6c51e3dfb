#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "aeolic/error.h"
#include "engine/testing/plane_testing.h"

/// Directions without a sign: (u, v) and (-u, -v) are the same.
namespace aeolic {
namespace {

using namespace testkit;

/// How many values of a hundred are within a thousandth of each other.
double percentAlike(const std::vector<float>& a, const std::vector<float>& b)
{
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        same += (std::isnan(a[i]) && std::isnan(b[i])) || std::abs(a[i] - b[i]) <= 1e-3F;
    return 100.0 * double(same) / double(a.size());
}

/// `flow` with the sign of each vector chosen by chance. Angles of polarization make such vectors.
TEST(PlaneLic, PolarizationHasNoSigns)
{
    for (const Streaks streaks : {Streaks::even, Streaks::plain})
        for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
            for (const bool periodic : {false, true}) {
                LicOptions lic = options(LicMethod::direct, 24);
                lic.streaks = streaks;
                lic.integrator = integrator;
                Plane velocity = eddies(300, 220, 4), polarized = velocity;
                velocity.periodic = polarized.periodic = periodic;
                polarized.axial = true;
                std::mt19937 random(7);
                for (std::size_t i = 0; i < polarized.pixels(); ++i)
                    if (random() % 2 == 0) {
                        polarized.u[i] = -polarized.u[i];
                        polarized.v[i] = -polarized.v[i];
                    }
                const auto expected = licOfPlane(velocity.flow(), lic);
                EXPECT_GT(percentAlike(licOfPlane(polarized.flow(), lic), expected), 97);
                polarized.axial = false;
                EXPECT_LT(percentAlike(licOfPlane(polarized.flow(), lic), expected), 30) << "signs mean something";
            }
}

/// Around a point where the angle turns by half a circle no choice of signs is smooth. Where it jumps must not show.
TEST(PlaneLic, PolarizationTurnsByHalfACircle)
{
    Plane left(200, 200, 0, 0), right = left;
    left.axial = right.axial = true;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const auto i = std::size_t(y * 200 + x);
            const double angle = 0.5 * std::atan2(y - 99.5, x - 99.5);  // Jumps on the left.
            left.u[i] = float(std::cos(angle));
            left.v[i] = float(std::sin(angle));
            const float sign = y < 99.5 ? -1.F : 1.F;
            right.u[i] = sign * left.u[i];  // Jumps on the right.
            right.v[i] = sign * left.v[i];
        }
    const LicOptions lic = options(LicMethod::direct, 30);
    const auto a = licOfPlane(left.flow(), lic), b = licOfPlane(right.flow(), lic);
    EXPECT_GT(percentAlike(a, b), 99);
    left.axial = right.axial = false;
    EXPECT_LT(percentAlike(licOfPlane(left.flow(), lic), licOfPlane(right.flow(), lic)), 95) << "the jumps show";
}

TEST(PlaneLic, PolarizationTakesTheDirectMethodAlone)
{
    Plane plane(9, 9, 1, 0);
    plane.axial = true;
    EXPECT_THROW(licOfPlane(plane.flow(), options(LicMethod::hierarchical, 8)), InputError);
    LicOptions moving = options(LicMethod::direct, 8);
    moving.kernel = Kernel::hann;
    EXPECT_NO_THROW(licOfPlane(plane.flow(), moving));
    moving.phase = 1;
    EXPECT_THROW(licOfPlane(plane.flow(), moving), InputError);
}

}  // namespace
}  // namespace aeolic

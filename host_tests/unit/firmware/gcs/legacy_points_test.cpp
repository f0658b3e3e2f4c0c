// SPDX-License-Identifier: GPL-3.0-or-later
// The fence and rally messages of before the mission protocol had points: refused, never silent.
#include "firmware/gcs/legacy_points.hpp"

#include "points_ground.hpp"

namespace ground {
namespace {

using Texts = std::vector<std::string>;

class LegacyPoints : public Points {
protected:
    template <class Message>
    Texts answersTo() {
        station.forget();
        give(toVehicle<Message>());
        live_ms(200);
        return station.texts();
    }
};

TEST_F(LegacyPoints, are_refused_with_a_text) {
    const Texts why{"Fence and rally: only as mission items"};
    EXPECT_EQ(answersTo<mavlink::FencePoint>(), why);
    EXPECT_EQ(answersTo<mavlink::FenceFetchPoint>(), why);
    EXPECT_EQ(answersTo<mavlink::RallyPoint>(), why);
    EXPECT_EQ(answersTo<mavlink::RallyFetchPoint>(), why);
}

TEST_F(LegacyPoints, cannot_be_resized_by_a_parameter) {
    upload(square(), kFence);
    upload(threeRallyPoints(), kRally);
    for (const auto& [name, stored] : {std::pair{"FENCE_TOTAL", 5.0f}, {"RALLY_TOTAL", 3.0f}}) {
        station.forget();
        EXPECT_EQ(setParameter(name, 0), stored);
        EXPECT_EQ(station.texts(), Texts{"Parameter is read-only"}) << name;
    }
    expectSame(download(kFence), square());
    expectSame(download(kRally), threeRallyPoints());
}

}  // namespace
}  // namespace ground

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/parameters_set.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using namespace mavlink;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

namespace {

template <class Message>
class Whole {
public:
    Whole(const std::string& name, float value) {
        name.copy(message_.param_id, sizeof message_.param_id);
        message_.param_value = value;
        frame_.payload = reinterpret_cast<const uint8_t*>(&message_);
        frame_.id = Wire<Message>::id;
        frame_.length = sizeof message_;
    }
    Whole(const Whole&) = delete;
    operator const Frame&() const { return frame_; }

private:
    Message message_{};
    Frame frame_{};
};
using Set = Whole<ParamSet>;
using Value = Whole<ParamValue>;

}  // namespace

TEST(ParametersSet, has_what_the_autopilot_answered) {
    ParametersSet set;
    set.sent(Set("WP_RADIUS", 44.7f));
    EXPECT_THAT(set.values(), IsEmpty()) << "nobody has said yet that it was taken";
    set.received(Value("WP_RADIUS", 44));
    EXPECT_THAT(set.values(), ElementsAre(Pair("WP_RADIUS", 44)));
    set.sent(Set("WP_RADIUS", 50));
    set.received(Value("WP_RADIUS", 50));
    EXPECT_THAT(set.values(), ElementsAre(Pair("WP_RADIUS", 50)));
}

TEST(ParametersSet, has_nothing_that_was_only_read) {
    ParametersSet set;
    set.received(Value("THR_MAX", 75));
    EXPECT_THAT(set.values(), IsEmpty());
}

TEST(ParametersSet, has_names_without_an_end_of_the_text) {
    ParametersSet set;
    set.sent(Set("SIXTEEN_LETTERS_", 1));
    set.received(Value("SIXTEEN_LETTERS_", 1));
    EXPECT_THAT(set.values(), ElementsAre(Pair("SIXTEEN_LETTERS_", 1)));
}

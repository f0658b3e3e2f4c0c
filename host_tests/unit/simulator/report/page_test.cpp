// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/page.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using testing::HasSubstr;
using testing::Not;

TEST(Page, holds_its_document_and_cannot_be_left_by_it) {
    FlightDocument document;
    document.title = "</script><b>crashed after item 3";
    const std::string page = flightPage(document);

    EXPECT_THAT(page, HasSubstr("u003c/script>\\u003cb>crashed after item 3"));
    EXPECT_THAT(page, Not(HasSubstr("<b>crashed")));
    EXPECT_THAT(page, Not(HasSubstr("id=\"flight\">{}<")));
}

TEST(Page, loads_nothing_from_the_network) {
    const std::string page = flightPage(FlightDocument());

    EXPECT_THAT(page, Not(HasSubstr(" src=")));
    EXPECT_THAT(page, Not(HasSubstr("<link rel=\"stylesheet")));
    EXPECT_LT(page.size(), 900'000u);
}

TEST(Page, of_a_live_flight_asks_its_server) {
    EXPECT_THAT(livePage(), HasSubstr("<meta name=\"source\" content=\"live\">"));
    EXPECT_THAT(livePage(), HasSubstr("id=\"flight\">{}<"));
}

TEST(Page, of_a_campaign_holds_its_document) {
    EXPECT_THAT(campaignPageOf("{\"a\":1}"), HasSubstr("id=\"campaign\">{\"a\":1}</script>"));
}

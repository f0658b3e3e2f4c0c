// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which missions are executed (docs/mission.md has the same numbers), as missions and
// what happens in them. The engine flies them alone, on the chip too, and beside the oracle.
#pragma once

// `set`: 1 is APM 1.0, 2 is APM 2.0. `mission`, from item 1 on: WP, LAND, TAKEOFF, HERE (a waypoint
// at 0, 0), COND, DO, QUIT (a DO that leaves AUTO), WHAT (unknown id), ODD (a NAV out of range),
// J2x3 (2.0: jump to 2, three times), J2 (for ever; in the 1.0 set SET_INDEX 2), J (1.0: to the
// first).
// `steps`: auto, afresh (MIS_RESTART), leave, pass, nav, cond, both (have finished), trail
// (MIS_TRAILING), set3, watchdog, power, commit (the mission `then`).
// `trace`: W5 starts NAV 5 (from the last place; W5! from the airplane; W5~ resumed), +5 reached,
// a5 DO, c5 CONDITION, ?5 skipped, loop5, hold5, RTL, landed. Where it has /, these part the steps.
struct MissionRule {
    int set;
    const char *mission, *steps, *trace, *then = nullptr;
};

// clang-format off
const MissionRule kMissionRules[] = {
    // 1: entering AUTO; what is before the first NAV
    {2, "WP WP", "auto nav", "W1! / +1 W2"},
    {1, "DO COND WP", "auto", "W3!"},
    {2, "DO WP", "auto", "a1 W2!"},
    {2, "DO COND DO WP", "auto cond", "a1 W4! c2 / a3"},
    // 2: one CONDITION at a time, a DO once, any number of them in one pass
    {1, "WP COND DO COND DO", "auto pass cond pass cond pass", "W1! c2 / / a3 c4 / / a5 /"},
    {2, "WP DO WP", "auto nav pass pass pass", "W1! / +1 a2 W3 / / /"},
    {2, "WP DO DO DO WP", "auto nav pass pass", "W1! / +1 a2 a3 a4 W5 / /"},
    {2, "DO DO DO DO DO DO DO DO DO DO WP", "auto", "a1 a2 a3 a4 a5 a6 a7 a8 a9 a10 W11!"},
    // 3: a finished NAV cancels the CONDITION and drops the rest of its chain
    {1, "WP COND DO WP DO", "auto nav", "W1! c2 / +1 W4 a5"},
    {2, "COND DO WP DO WP", "auto nav", "W3! c1 / +3 a4 W5"},
    {2, "WP COND DO WP WP", "auto nav both", "W1! / +1 W4 c2 / +4 W5"},
    // 4: which NAV the others accompany
    {1, "WP DO WP", "auto nav", "W1! a2 / +1 W3"},
    {2, "WP DO WP", "auto nav", "W1! / +1 a2 W3"},
    {1, "WP DO", "trail auto nav", "W1! a2 / +1 RTL"},
    {1, "WP DO", "auto nav", "W1! a2 / +1 RTL"},
    {2, "WP DO", "auto nav", "W1! / +1 RTL"},
    {2, "WP", "trail auto nav", "W1! / +1 RTL"},
    {2, "WP DO COND DO", "trail auto nav nav cond", "W1! / +1 hold1 a2 c3 / / a4 RTL"},
    {2, "WP WP J1x1", "trail auto nav nav nav nav",
        "W1! / +1 W2 / +2 W1 / +1 W2 / +2 hold2 RTL"},
    {2, "WP LAND DO", "trail auto nav nav", "W1! / +1 W2 / +2 landed"},
    // a 2.0 jump abandons the NAV and goes on at its target
    {2, "WP WP J1x2 DO WP", "auto nav nav nav nav nav nav",
        "W1! / +1 W2 / +2 W1 / +1 W2 / +2 W1 / +1 W2 / +2 a4 W5"},
    {2, "WP J1x1 DO WP", "auto nav nav", "W1! / +1 W1 / +1 a3 W4"},
    {2, "WP J1x2 DO WP", "auto nav nav nav", "W1! / +1 W1 / +1 W1 / +1 a3 W4"},
    {2, "WP COND J1x1 DO WP", "auto nav pass cond nav cond",
        "W1! / +1 W5 c2 / / W1! / +1 W5 c2 / a4"},
    {2, "WP COND J1x1 WP", "auto nav pass pass cond", "W1! / +1 W4 c2 / / / W1!"},
    {2, "WP COND WP J2x1 WP", "auto nav nav cond", "W1! / +1 W3 c2 / +3 W3 c2 /"},
    {2, "WP DO WP J2x1 WP", "auto nav nav nav", "W1! / +1 a2 W3 / +3 a2 W3 / +3 W5"},
    {2, "WP J4x1 WP DO", "auto nav", "W1! / +1 RTL"},
    {2, "WP J4x1 WP DO", "trail auto nav", "W1! / +1 hold3 a4 RTL"},
    // what a jump behind the last NAV leads to goes on: it does not trail
    {2, "WP J1x1", "auto nav nav", "W1! / +1 W1 / +1 RTL"},
    {2, "WP J1x1", "trail auto nav nav", "W1! / +1 W1 / +1 hold1 RTL"},
    {2, "WP WP J1", "auto nav nav nav nav nav", "W1! / +1 W2 / +2 W1 / +1 W2 / +2 W1 / +1 W2"},
    {2, "DO WP WP DO J1x1 DO", "auto nav nav nav nav",
        "a1 W2! / +2 W3 / +3 a4 a1 W2 / +2 W3 / +3 RTL"},
    {2, "DO WP WP DO J1x1 DO", "trail auto nav nav nav nav",
        "a1 W2! / +2 W3 / +3 a4 a1 W2 / +2 W3 / +3 hold3 a4 a6 RTL"},
    {2, "WP WP COND DO J1x2 WHAT", "auto nav nav cond nav nav nav nav nav",
        "W1! / +1 W2 / +2 W1 c3 / a4 / +1 W2 / +2 W1 c3 / +1 W2 / +2 RTL /"},
    {2, "WP COND DO J1x1", "auto nav watchdog auto cond", "W1! / +1 W1 c2 / / W1~ c2 / a3"},
    {2, "WP J1x1 J1x1 DO", "auto nav nav nav", "W1! / +1 W1 / +1 W1 / +1 RTL"},
    {2, "WP J3 J2 DO", "auto nav", "W1! / +1 RTL"},
    {2, "WP J3 J1x2 DO", "auto nav", "W1! / +1 RTL"},
    {2, "WP DO DO J2x1", "set3 auto", "/ RTL"},
    {2, "TAKEOFF LAND DO J1x1", "auto nav nav nav", "W1! / +1 W2! / +2 a3 W1 / +1 W2!"},
    {2, "WP LAND J1", "auto nav nav", "W1! / +1 W2 / +2 landed"},
    // a 1.0 jump moves the queue only
    {1, "WP J", "auto nav nav", "W1! / +1 W1 / +1 W1"},
    {1, "WP WP J", "auto nav nav nav nav", "W1! / +1 W2 / +2 W1 / +1 W2 / +2 W1"},
    {1, "WP DO COND J2 WP", "auto cond cond nav", "W1! a2 c3 / a2 c3 / a2 c3 / +1 W5"},
    {1, "WP J4 WP DO WP", "auto nav", "W1! a4 / +1 W5"},
    {1, "WP WP J4 WP WP", "auto nav pass nav", "W1! / +1 W2 / / +2 W4"},
    {1, "WP COND J1 WP", "auto nav", "W1! c2 / +1 W4"},
    {1, "WP COND J WP", "auto pass cond nav", "W1! c2 / / / +1 W1 c2"},
    // 5: the end
    {2, "WP", "auto nav", "W1! / +1 RTL"},
    {2, "LAND WP", "auto nav", "W1! / +1 landed"},
    {1, "LAND DO WP", "auto nav", "W1! a2 / +1 landed"},
    {1, "LAND DO TAKEOFF WP", "auto nav nav", "W1! a2 / +1 W3 / +3 W4!"},
    {2, "LAND DO TAKEOFF WP", "auto nav nav", "W1! / +1 a2 W3 / +3 W4!"},
    {2, "WP LAND J1 TAKEOFF", "auto nav nav", "W1! / +1 W2 / +2 landed"},
    // 6: leaving AUTO and coming back, and resets in the air
    {2, "WP DO COND DO WP", "auto nav leave cond auto cond",
        "W1! / +1 a2 W5 c3 / / / W5~ c3 / a4"},
    {2, "WP COND DO WP WP", "auto nav nav leave auto cond", "W1! / +1 W4 c2 / +4 W5 / / W5~ /"},
    {2, "HERE", "auto leave pass auto", "W1!@500 / / / W1~@500"},
    {2, "WP J1x1 WP", "auto nav leave auto nav leave afresh nav",
        "W1! / +1 W1 / / W1~ / +1 W3 / / W1! / +1 W1"},
    {2, "WP J1x1 WP", "auto nav nav nav auto nav", "W1! / +1 W1 / +1 W3 / +3 RTL / W1! / +1 W1"},
    {2, "WP", "auto nav auto", "W1! / +1 RTL / W1!"},
    {1, "WP QUIT DO", "auto auto", "W1! a2 / W1~ a3"},
    {1, "WP QUIT J2", "auto auto auto", "W1! a2 / W1~ a2 / W1~ a2"},
    {2, "QUIT J1 WP", "auto auto auto auto auto auto", "a1 / a1 / a1 / a1 / a1 / a1"},
    {2, "WP J1x1 DO COND DO WP", "auto nav nav watchdog auto cond",
        "W1! / +1 W1 / +1 a3 W6 c4 / / W6~ c4 / a5"},
    {2, "WP DO WP DO WP", "auto nav power auto nav", "W1! / +1 a2 W3 / / W3! / +3 a4 W5"},
    {1, "WP DO WP DO WP", "auto nav power auto nav", "W1! a2 / +1 W3 a4 / / W3! / +3 W5"},
    // 7: another mission in flight
    {2, "WP DO COND WP WP", "auto nav commit cond nav", "W1! +1 a2 W4 c3 +4 W5",
        "WP DO COND WP LAND"},
    {2, "WP DO COND WP", "auto nav commit pass", "W1! +1 a2 W4 c3 W1!", "WP COND DO WP"},
    {2, "WP J1x1 WP", "auto nav commit nav", "W1! +1 W1 +1 W1", "WP J1x1 WP"},
    {2, "DO WP WP COND DO J1x1 DO", "auto nav nav commit cond",
        "a1 W2! +2 W3 +3 W2 c4 a5 a1", "DO WP WP COND DO J1x1 WHAT"},
    {2, "DO WP WP COND DO J1x1 DO", "auto nav nav commit cond",
        "a1 W2! +2 W3 +3 W2 c4 ?1 W2!", "WHAT WP WP COND DO J1x1 DO"},
    {1, "WP DO", "auto commit nav", "W1! a2 +1 W3", "WP DO WP"},
    {1, "WP J4 WP DO J7 WP DO COND DO", "auto commit pass", "W1! a4 a7 c8 W1! ?4 a7 c8",
        "WP J4 WP WHAT J7 WP DO COND DO"},
    {1, "WP J4 WP DO J7 WP DO COND DO", "auto commit cond", "W1! a4 a7 c8 a9",
        "WP J4 LAND DO J7 LAND DO COND DO"},
    {2, "WP", "auto commit", "W1! RTL", ""},
    {2, "LAND", "auto nav commit", "W1! +1 landed landed", ""},
    // 8: what never stops a mission
    {2, "WP WHAT ODD DO WP", "auto nav", "W1! / +1 ?2 ?3 a4 W5"},
    {2, "WP J2 WP", "auto nav", "W1! / +1 ?2 W3"},
    {2, "DO J1 DO WP", "auto pass nav", "a1 a1 loop2 a3 W4! / / +4 RTL"},
    {2, "WP DO DO DO DO DO J1x1 WP", "auto nav nav",
        "W1! / +1 a2 a3 a4 a5 a6 W1 / +1 a2 a3 a4 a5 a6 W8"},
    {2, "J2 J1 DO DO WP", "auto", "loop1 a3 a4 W5!"},
    {2, "WP DO J2x9 WP", "auto nav set2 pass set2 pass set2 pass set2 pass",
        "W1! / +1 a2 a2 a2 loop3 W4 / / a2 a2 a2 loop3 W4! / / a2 a2 a2 loop3 W4! /"
        " / a2 a2 a2 loop3 W4! / / a2 a2 W4!"},
    {2, "WP J1 WP", "auto nav nav nav nav nav", "W1! / +1 W1 / +1 W1 / +1 W1 / +1 W1 / +1 W1"},
    {1, "WP J2 DO", "auto", "W1! a3"},
    {1, "WP DO J2 DO COND J2 WP", "auto cond nav set1 pass",
        "W1! a2 a2 a4 c5 / a2 a4 c5 / +1 W7 / / W1! a2 a2 a4 c5"},
    {1, "WP J3 J2 DO WP", "auto nav", "W1! a4 / +1 W5"},
    // 9: a chosen item
    {2, "WP WP DO WP", "auto set3 pass", "W1! / / a3 W4!"},
    {1, "WP WP DO WP DO", "auto set3 pass", "W1! / / W4! a5"},
    {2, "WP WP", "auto set3 nav", "W1! / / +1 W2"},
    {2, "WP J1x1 WP", "set3 auto leave set1 afresh nav", "/ W3! / / / W1! / +1 W1"},
    {2, "WP J1x1 WP", "auto nav set1 pass nav set0 pass nav",
        "W1! / +1 W1 / / W1! / +1 W3 / / W1! / +1 W1"},
    {2, "WP WP J1x1 WP", "set2 auto nav nav nav", "/ W2! / +2 W1 / +1 W2 / +2 W4"},
    // 10: where a leg begins
    {2, "WP WP J1x1 WP", "auto nav nav", "W1! / +1 W2 / +2 W1"},
    {2, "TAKEOFF WP WP", "auto nav nav", "W1! / +1 W2! / +2 W3"},
    {2, "WP COND J5x1 WP WP WP", "auto nav cond nav", "W1! / +1 W4 c2 / W5! / +5 W6"},
    {2, "WP J4x1 LAND WP", "auto nav", "W1! / +1 W4"},
};
// clang-format on

// SPDX-License-Identifier: GPL-3.0-or-later
// Whole flights 200 times a second take minutes of the chip.
// clang-format off
LEFT_OUT(Attitude, holds_a_quarter_of_a_degree_of_bank_over_whole_flights_with_every_error, "whole flights")
LEFT_OUT(Attitude, bears_a_fix_that_is_older_than_believed, "whole flights")
LEFT_OUT(Attitude, puts_a_compass_to_rights_whose_offsets_are_50_mG_wrong, "whole flights")
LEFT_OUT(Attitude, stays_upright_for_two_minutes_without_gps, "whole flights")
LEFT_OUT(Attitude, stays_upright_with_neither_gps_nor_airspeed, "whole flights")
LEFT_OUT(Attitude, finds_its_heading_without_a_compass, "whole flights")
LEFT_OUT(Height, holds_a_tenth_of_a_metre_and_of_a_metre_a_second_in_a_whole_flight, "whole flights")
LEFT_OUT(Position, makes_up_for_the_age_of_the_fixes_through_steep_turns, "whole flights")
LEFT_OUT(Position, is_nearer_than_the_fixes_through_steep_turns, "whole flights")
LEFT_OUT(Position, averages_the_receivers_wander_away, "whole flights")
LEFT_OUT(Position, averages_fixes_that_come_once_a_second_as_well, "whole flights")
LEFT_OUT(Position, keeps_to_the_fixes_when_their_velocity_is_wrong, "whole flights")
LEFT_OUT(Position, works_across_the_antimeridian, "whole flights")
LEFT_OUT(Wind, gusts_do_not_move_it_much, "whole flights")

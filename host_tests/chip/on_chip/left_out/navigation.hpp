// SPDX-License-Identifier: GPL-3.0-or-later
// Closed loops of more than 40 s on the flight model: a second of it takes half a second.
// clang-format off
LEFT_OUT(Leg, is_held_in_calm_air_from_five_seconds_after_a_turn, "a long flight")
LEFT_OUT(Leg, is_held_in_wind_and_gusts, "a long flight")
LEFT_OUT(Leg, is_captured_from_far_with_hardly_any_overshoot, "a long flight")
LEFT_OUT(Leg, is_captured_flying_away_from_it_and_flying_backwards, "a long flight")
LEFT_OUT(Leg, begun_behind_its_start_is_not_closed_more_steeply_than_straight_to_the_start, "a long flight")
LEFT_OUT(Circle, is_joined_from_outside_and_held_in_calm_air, "a long flight")
LEFT_OUT(Circle, is_held_in_wind_and_gusts, "a long flight")
LEFT_OUT(Circle, is_reached_from_its_centre, "a long flight")
LEFT_OUT(Course, of_which_a_faster_wind_keeps_it_does_not_roll_it_from_side_to_side, "a long flight")
LEFT_OUT(Course, of_which_a_faster_wind_keeps_it_is_held_by_the_nose, "long flights")
LEFT_OUT(Turn, is_led_so_that_the_next_leg_is_not_overshot, "a long flight")
LEFT_OUT(Turn, with_a_strong_wind_from_behind_afterwards_is_not_overshot, "a long flight")
LEFT_OUT(BankTrim, takes_away_what_a_false_level_leaves_beside_the_path, "a long flight")
LEFT_OUT(Landing, touches_down_softly_near_the_point, "a long flight")

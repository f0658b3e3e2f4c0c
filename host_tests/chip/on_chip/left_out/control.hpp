// SPDX-License-Identifier: GPL-3.0-or-later
// Closed loops of more than 15 s on the flight model: a second of it takes half a second.
// clang-format off
LEFT_OUT(SpeedHeight, holds_height_and_speed_in_calm_air, "a long flight")
LEFT_OUT(SpeedHeight, holds_height_and_speed_in_gusts, "a long flight")
LEFT_OUT(SpeedHeight, follows_a_slope_without_lag, "a long flight")
LEFT_OUT(SpeedHeight, a_step_in_height_is_flown_without_overshoot_or_loss_of_speed, "a long flight")
LEFT_OUT(SpeedHeight, a_change_of_speed_hardly_moves_the_height, "a long flight")
LEFT_OUT(SpeedHeight, a_steep_turn_costs_little_height_and_speed, "a long flight")
LEFT_OUT(SpeedHeight, demands_outside_the_speed_limits_are_not_flown, "a long flight")
LEFT_OUT(SpeedHeight, near_the_stall_it_gives_up_height_for_speed, "a long flight")
LEFT_OUT(SpeedHeight, takes_errors_back_in_a_time_of_its_own_while_landing, "a long flight")
LEFT_OUT(SpeedHeight, flies_without_an_airspeed_sensor, "a long flight")
LEFT_OUT(SpeedHeight, climbs_out_with_all_throttle_at_the_demanded_speed, "a long flight")

# SPDX-License-Identifier: GPL-3.0-or-later
# The limits of toolchain/image/budgets.json as a header, for the report of a flight.
set(budgets_json ${CMAKE_SOURCE_DIR}/toolchain/image/budgets.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${budgets_json})
file(READ ${budgets_json} budgets)

# budget(VARIABLE NAME [BOARD]): the board's own budget where it has one, else everybody's
function(budget variable name)
    string(JSON value ERROR_VARIABLE missing GET "${budgets}" ${ARGN} ${name})
    if(missing)
        string(JSON value GET "${budgets}" ${name})
    endif()
    set(${variable} ${value} PARENT_SCOPE)
endfunction()

set(rows)
foreach(board IN ITEMS apm1 apm2)
    budget(processor processor_percent ${board})
    budget(interrupts interrupts_percent ${board})
    string(APPEND rows "constexpr BoardBudget k_${board} = {${processor}, ${interrupts}};\n")
endforeach()
budget(flash flash)
budget(ram ram_static_and_stack)
budget(frame frame_us)
budget(latency gyro_to_servo_us)
budget(interrupt interrupt_cycles)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/budgets.hpp CONTENT [[
// Made of toolchain/image/budgets.json by toolchain/cmake/budget_header.cmake.
#pragma once
namespace budgets {
struct BoardBudget {
    double processor_percent, interrupts_percent;
};
@rows@constexpr double kFlash_bytes = @flash@, kRamAndStack_bytes = @ram@;
constexpr double kFrame_us = @frame@, kGyroToServo_us = @latency@;
constexpr double kInterrupt_us = @interrupt@ / 16.0;  // from cycles of 16 MHz
}  // namespace budgets
]] @ONLY)

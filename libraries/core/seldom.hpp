// SPDX-License-Identifier: GPL-3.0-or-later
// Marks what a task of every frame calls seldom: when it starts, in a fault, on a request. The
// compiler makes it small and puts it into a function of its own; inlined it would cost the task,
// in every run, registers saved and a stack too large for short addresses.
#pragma once

#define SELDOM __attribute__((noinline, cold))

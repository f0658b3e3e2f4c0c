// SPDX-License-Identifier: GPL-3.0-or-later
// What a source file remembers from call to call: one struct, named for what it holds,
//
//     struct Shutter {
//         float every_m;
//         uint8_t open_ticks;
//     };
//     core::FileState<Shutter> shutter{};
//
// On the chip that is the struct and nothing more. On a computer the tests put every one back to
// what it was at start by resetFileStates().
#pragma once
#ifndef __AVR__
#include <new>
#endif

namespace core {

#ifdef __AVR__

template <class State>
using FileState = State;

#else

// All of them, in a list.
class FileStates {
public:
    using Reset = void (*)(FileStates&);
    explicit FileStates(Reset reset) : reset_(reset), next_(first()) { first() = this; }
    FileStates(const FileStates&) = delete;
    FileStates& operator=(const FileStates&) = delete;
    static void resetAll() {
        for (FileStates* each = first(); each != nullptr; each = each->next_) each->reset_(*each);
    }

private:
    static FileStates*& first() {
        static FileStates* newest = nullptr;
        return newest;
    }
    const Reset reset_;
    FileStates* const next_;
};

// The struct comes first: its address is that of the whole.
template <class State>
class FileState : public State, private FileStates {
public:
    FileState() : FileState(State{}) {}
    explicit FileState(const State& at_start)
        : State(at_start), FileStates(reset), at_start_(at_start) {}
    using State::operator=;
    FileState& operator=(FileState&) = delete;  // so that `= {}` is the struct's

private:
    static void reset(FileStates& one) {
        FileState& self = static_cast<FileState&>(one);
        State& state = self;
        state.~State();
        new (&state) State(self.at_start_);
    }
    const State at_start_;
};

inline void resetFileStates() { FileStates::resetAll(); }

#endif

}  // namespace core

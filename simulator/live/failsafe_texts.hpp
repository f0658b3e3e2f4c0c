// SPDX-License-Identifier: GPL-3.0-or-later
// The status texts with which our firmware reports that a failsafe begins and is over, as
// docs/failsafes.md lists them; a test compares the two.
#pragma once
#include <string>
#include <vector>

namespace simulator::live {

struct FailsafeText {
    const char* begins;
    std::vector<const char*> over;  // any of these; disarming ends them all
};

const std::vector<FailsafeText>& failsafeTexts();

// nullptr: the text begins none.
const FailsafeText* failsafeBegunBy(const std::string& text);

}  // namespace simulator::live

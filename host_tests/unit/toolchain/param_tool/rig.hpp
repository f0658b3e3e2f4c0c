// SPDX-License-Identifier: GPL-3.0-or-later
// The tool's program with files of its own.
#pragma once
#include <gmock/gmock.h>

#include "mission_tool_rig.hpp"
#include "toolchain/param_tool/board.hpp"
#include "toolchain/param_tool/manual.hpp"
#include "toolchain/param_tool/program.hpp"
#include "toolchain/param_tool/table.hpp"

namespace param_tool {

class ParamTool : public mission_tool::Tool {
protected:
    int param(const std::vector<std::string>& words) {
        std::ostringstream out, err;
        const int status = run(words, out, err);
        out_ = out.str();
        err_ = err.str();
        return status;
    }
    // What `check` says of this file, called f.param; empty: nothing.
    std::string errorsOf(const std::string& contents) {
        status_ = param({"check", file("f.param", contents)});
        std::string reported = err_;
        const std::string folder = folder_.string() + '/';
        for (size_t at; (at = reported.find(folder)) != std::string::npos;)
            reported.erase(at, folder.size());
        return reported;
    }
    // The value of the parameter in the image.
    std::string valueIn(const std::string& image, const std::string& name) {
        EXPECT_EQ(param({"decode", image}), 0) << err_;
        const size_t at = ('\n' + out_).find('\n' + name + ',');
        if (at == std::string::npos) return "absent";
        const size_t value = at + name.size() + 1;
        return out_.substr(value, out_.find('\n', value) - value);
    }

    int status_ = -1;
};

}  // namespace param_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// What every page of the simulator is made of: one style, sections, tables, cards.
#pragma once
#include <string>
#include <vector>

namespace simulator {

std::string htmlHead(const std::string& title);  // up to the beginning of <main>
constexpr char kHtmlEnd[] = "</main></body></html>\n";

// Empty without a body.
std::string htmlSection(const std::string& title, const std::string& body,
                        const std::string& note = "");
std::string htmlCard(const std::string& name, const std::string& value);

// The first column is words, the others are numbers.
class Table {
public:
    explicit Table(const std::vector<std::string>& heads);
    void row(const std::vector<std::string>& cells);
    std::string done() const { return text_ + "</tbody></table></div>\n"; }

private:
    void cell(const std::string& tag, const std::string& words, bool number);
    std::string text_;
};

std::string fixed(double value, int decimals);

}  // namespace simulator

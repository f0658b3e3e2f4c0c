// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/http_request.hpp"

#include <algorithm>

namespace simulator::live {
namespace {

constexpr std::string_view kEnd = "\r\n", kEndOfHead = "\r\n\r\n";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lowered(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

// RFC 9110, 5.6.2.
bool isToken(std::string_view text) {
    const auto allowed = [](char c) {
        const bool letter = lower(c) >= 'a' && lower(c) <= 'z';
        return letter || (c >= '0' && c <= '9') ||
               std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

// Of the head: nothing but printable ASCII, tabs and ends of lines.
bool isText(std::string_view bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](char c) {
        return (c >= ' ' && c <= '~') || c == '\t' || c == '\r' || c == '\n';
    });
}

std::string_view trimmed(std::string_view text) {
    const size_t from = text.find_first_not_of(" \t");
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

}  // namespace

const std::string& Request::header(const std::string& name) const {
    static const std::string kNone;
    const auto found = headers.find(name);
    return found == headers.end() ? kNone : found->second;
}

bool RequestParser::fail(int status) {
    error_ = status;
    buffer_.clear();
    in_body_ = whole_ = false;
    return false;
}

bool RequestParser::put(std::string_view bytes) {
    if (error_ != 0) return false;
    buffer_.append(bytes);
    return whole_ || parse();
}

bool RequestParser::next() {
    whole_ = in_body_ = false;
    request_ = {};
    return error_ == 0 && parse();
}

bool RequestParser::parse() { return (in_body_ || takeHead()) && takeBody(); }

bool RequestParser::takeHead() {
    const size_t end = buffer_.find(kEndOfHead);
    const std::string_view head = std::string_view(buffer_).substr(0, end);
    if (!isText(head)) return fail(400);
    const size_t line = head.find(kEnd);
    if (line == head.npos && head.size() > kMaxLine) return fail(414);
    if (head.size() > kMaxHead) return fail(431);
    if (end == buffer_.npos) return false;
    if (!takeRequestLine(head.substr(0, line))) return fail(error_ == 0 ? 400 : error_);
    if (line != head.npos && !takeHeaders(head.substr(line + kEnd.size()))) return false;
    if (!takeLength()) return false;
    buffer_.erase(0, end + kEndOfHead.size());
    in_body_ = true;
    return true;
}

bool RequestParser::takeRequestLine(std::string_view line) {
    const size_t first = line.find(' '), last = line.rfind(' ');
    if (line.size() > kMaxLine) return fail(414);
    if (first == line.npos || first == last) return false;
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    request_.method = line.substr(0, first);
    request_.path = target.substr(0, target.find('?'));
    request_.keep_alive = version == "HTTP/1.1";
    const bool known = version == "HTTP/1.1" || version == "HTTP/1.0";
    return isToken(request_.method) && !target.empty() && target[0] == '/' &&
           target.find(' ') == target.npos && known;
}

bool RequestParser::takeHeaders(std::string_view lines) {
    while (!lines.empty()) {
        const size_t end = lines.find(kEnd);
        if (!takeHeader(lines.substr(0, end))) return false;
        lines = end == lines.npos ? std::string_view() : lines.substr(end + kEnd.size());
    }
    return true;
}

// One that is given twice could mean two things: refused.
bool RequestParser::takeHeader(std::string_view line) {
    const size_t colon = line.find(':');
    if (colon == line.npos || !isToken(line.substr(0, colon))) return fail(400);
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (value.find_first_of("\r\n") != value.npos) return fail(400);
    if (request_.headers.size() >= kMaxHeaders) return fail(431);
    const std::string name = lowered(line.substr(0, colon));
    const bool fresh = request_.headers.emplace(name, value).second;
    const bool once = name == "host" || name == "content-length" || name == "origin";
    return fresh || !once || fail(400);
}

bool RequestParser::takeLength() {
    if (lowered(request_.header("connection")) == "close") request_.keep_alive = false;
    if (request_.headers.count("transfer-encoding") > 0) return fail(400);
    const bool given = request_.headers.count("content-length") > 0;
    const std::string& digits = request_.header("content-length");
    if (given && (digits.empty() || digits.find_first_not_of("0123456789") != digits.npos))
        return fail(400);
    length_ = 0;
    for (const char digit : digits) {
        length_ = length_ * 10 + static_cast<size_t>(digit - '0');
        if (length_ > kMaxBody) return fail(413);
    }
    return true;
}

bool RequestParser::takeBody() {
    if (buffer_.size() < length_) return false;
    request_.body = buffer_.substr(0, length_);
    buffer_.erase(0, length_);
    return whole_ = true;
}

}  // namespace simulator::live

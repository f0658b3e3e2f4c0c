// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of HTTP/1.1 (RFC 9112) out of a stream of bytes, as far as a page and its commands need
// them: no transfer encodings, no trailers, no upgrades. What exceeds a limit or is no request
// makes the stream unusable, with the status to answer.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace simulator::live {

struct Request {
    std::string method, path;                    // the path without its query
    std::map<std::string, std::string> headers;  // names in lower case
    std::string body;
    bool keep_alive = true;

    const std::string& header(const std::string& name) const;  // empty: not given
};

class RequestParser {
public:
    static constexpr size_t kMaxLine = 2048, kMaxHead = 16'384, kMaxHeaders = 64, kMaxBody = 16'384;

    // Both: true when a whole request is there; next() forgets the one before.
    bool put(std::string_view bytes);
    bool next();

    const Request& request() const { return request_; }
    int error() const { return error_; }  // the status to answer; 0: none. Nothing is read after it
    bool begun() const { return in_body_ || !buffer_.empty(); }

private:
    bool parse();
    bool takeHead();
    bool takeHeaders(std::string_view lines);
    bool takeRequestLine(std::string_view line);
    bool takeHeader(std::string_view line);
    bool takeLength();
    bool takeBody();
    bool fail(int status);

    std::string buffer_;
    Request request_;
    size_t length_ = 0;  // of the body
    bool in_body_ = false, whole_ = false;
    int error_ = 0;
};

}  // namespace simulator::live

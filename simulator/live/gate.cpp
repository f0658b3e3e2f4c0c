// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/gate.hpp"

#include <nlohmann/json.hpp>

namespace simulator::live {
namespace {

// Port 80 is left out by browsers.
bool isOurs(const std::string& authority, uint16_t port) {
    for (const std::string name : {"127.0.0.1", "localhost"}) {
        if (authority == name + ":" + std::to_string(port)) return true;
        if (port == 80 && authority == name) return true;
    }
    return false;
}

bool fromElsewhere(const Request& request) {
    const std::string& origin = request.header("origin");
    return !origin.empty() && origin != "http://" + request.header("host");
}

bool isJson(const std::string& type) {
    const std::string kind = type.substr(0, type.find(';'));
    return kind.substr(0, kind.find_last_not_of(' ') + 1) == "application/json";
}

struct Route {
    const char *path, *method;
};
constexpr Route kRoutes[] = {{"/", "GET"}, {"/live", "GET"}, {"/command", "POST"}};

}  // namespace

Response answerJson(int status, bool ok, const std::string& text) {
    const nlohmann::ordered_json json = {{"ok", ok}, {"text", text}};
    return {status, "application/json",
            json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"};
}

std::optional<Response> refusal(const Request& request, uint16_t port) {
    if (request.header("host").empty()) return answerJson(400, false, "no Host");
    if (!isOurs(request.header("host"), port)) return answerJson(403, false, "another Host");
    if (fromElsewhere(request)) return answerJson(403, false, "another page's Origin");
    for (const Route& route : kRoutes) {
        if (request.path != route.path) continue;
        if (request.method != route.method) {
            Response response = answerJson(405, false, std::string("expected ") + route.method);
            response.more_headers = std::string("Allow: ") + route.method + "\r\n";
            return response;
        }
        if (request.method == "POST" && !isJson(request.header("content-type")))
            return answerJson(415, false, "expected Content-Type application/json");
        return std::nullopt;
    }
    return answerJson(404, false, "there are /, /live and /command");
}

}  // namespace simulator::live

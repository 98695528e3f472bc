// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_serve.h"

#include <algorithm>
#include <sstream>

#include "app/cli/serve.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::fuzz {
namespace {

constexpr std::size_t kMaxServeBytes = 16 * 1024;
constexpr int kMaxServeLines = 20;
/// A bent square and a tube of three sides.
constexpr auto kServedMesh =
    "v 0 0 0\nv 100 0 5\nv 100 100 0\nv 0 100 5\n"
    "v 200 0 0\nv 240 0 0\nv 220 0 30\nv 200 90 0\nv 240 90 0\nv 220 90 30\n"
    "o panel\nf 1 2 3\nf 1 3 4\n"
    "o tube\nf 5 6 9 8\nf 6 7 10 9\nf 7 5 8 10\n";
constexpr auto kTellAll =
    R"({"id":0,"do":"query","what":["vertices","triangles","cuts","problems"]})";

/// The words that name files, and those whose cost has no bound.
bool isHarmless(const std::vector<std::string>& words) {
    return std::ranges::none_of(words, [](const std::string& word) {
        for (const char* part : {"/", ".obj", "--remesh", "--edge", "--seams", "--body", "-o",
                                 "--output", "--report", "--pattern-unit"}) {
            if (word.find(part) != std::string::npos) {
                return true;
            }
        }
        return !word.starts_with("-") &&
               word.find_first_not_of("0123456789.") != std::string::npos && word.size() > 20;
    });
}

/// Whether the request is done, and not only read: a load reads the small garment.
bool isDone(app::ServeRequest& request, const std::string& file) {
    if (request.refusal) {
        return true;
    }
    if (!isHarmless(request.args) || (request.what == "prove" && request.hasArgs)) {
        return false;
    }
    if (request.what == "load") {
        std::erase_if(request.args, [](const std::string& word) { return word == "g"; });
        request.args.insert(request.args.begin(), file);
    }
    return request.what != "export";
}

std::string whatIsWrong(const std::string& answer, const std::string& id) {
    const auto json = OrderedJson::parse(answer, nullptr, false);
    if (json.is_discarded() || answer.empty() || answer.find('\n') != answer.size() - 1) {
        return "an answer is no line of JSON";
    }
    if (!json.contains("id") || json["id"].dump() != id) {
        return "an answer has another id than its request";
    }
    if (json.contains("result") == json.contains("error")) {
        return "an answer is neither result nor error";
    }
    if (json.contains("error")) {
        const auto& error = json["error"];
        if (error["code"].get<std::string>().empty() ||
            error["message"].get<std::string>().empty()) {
            return "an error has no code or no sentence";
        }
    }
    return "";
}

}  // namespace

std::string whatBreaksInServe(std::string bytes) {
    if (bytes.size() > kMaxServeBytes) {
        return "";
    }
    static const test::TemporaryFolder folder;
    static const std::string file = folder.write("g.obj", kServedMesh).string();
    app::ServeSession session;
    std::istringstream lines(bytes);
    int count = 0;
    for (std::string line; std::getline(lines, line) && count < kMaxServeLines; ++count) {
        app::ServeRequest request = app::readServeRequest(line);
        if (!isDone(request, file)) {
            continue;
        }
        Progress progress;
        const auto tellAll = [&] {
            return session.answer(app::readServeRequest(kTellAll), progress);
        };
        const std::string before = tellAll();
        const std::string answer = session.answer(request, progress);
        if (std::string wrong = whatIsWrong(answer, request.id); !wrong.empty()) {
            return wrong + ": " + answer.substr(0, 300);
        }
        if (OrderedJson::parse(answer).contains("error") && tellAll() != before) {
            return "what is refused has changed the garment";
        }
    }
    return "";
}

}  // namespace toile::fuzz

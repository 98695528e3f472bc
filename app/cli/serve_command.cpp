// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <istream>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <thread>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/serve.h"

namespace toile::app {
namespace {

constexpr auto kWrongRequest = "wrong-request";
constexpr auto kLineName = "request";

std::string lineOf(const std::string& id, const char* key, const OrderedJson& json) {
    return R"({"id":)" + id + ",\"" + key +
           "\":" + json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "}\n";
}

/// Answers repeat the id, so it must be an integer or a short text.
bool isId(const JsonDocument& json) {
    return json.is_number_integer() ||
           (json.is_string() && json.get_ref<const std::string&>().size() <= kMaxServeId);
}

void readId(JsonFields& fields, const char* key, std::string& id) {
    if (const JsonDocument* json = fields.need(key)) {
        if (isId(*json)) {
            id = json->dump(-1, ' ', false, JsonDocument::error_handler_t::replace);
        } else {
            fields.fail(key, "must be a whole number or a string of at most 100 bytes");
        }
    }
}

void readTexts(JsonFields& fields, const char* key, std::vector<std::string>& texts) {
    fields.readEach(key, [&](const JsonDocument& json, const std::string& place) {
        const auto* text = json.get_ptr<const std::string*>();
        if (!text || text->find('\0') != std::string::npos) {
            fields.failAt(place, "must be a string");
            return;
        }
        texts.push_back(*text);
    });
}

/// Reads the fields specific to each kind of request.
void readOthers(JsonFields& fields, ServeRequest& request) {
    const std::string& what = request.what;
    if (what == "load" || what == "edit" || what == "export" || what == "prove") {
        request.hasArgs = fields.find("args") != nullptr;
        readTexts(fields, "args", request.args);
    }
    if (what == "load" || what == "edit") {
        if (const JsonDocument* seams = fields.find("seams")) {
            request.seams = seams->dump(-1, ' ', false, JsonDocument::error_handler_t::replace);
        }
    }
    if (what == "flatten") {
        fields.read("settle", request.settle);
    }
    if (what == "query") {
        fields.need("what");
        readTexts(fields, "what", request.wanted);
        readTexts(fields, "pieces", request.pieces);
    }
    if (what == "cancel") {
        readId(fields, "of", request.of);
    }
}

// Limits of waiting requests. Refuse more, so that "cancel" is always read.
constexpr std::size_t kMaxWaiting = 1024;
constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20U;
constexpr std::chrono::milliseconds kBetweenProgress{100};
constexpr double kProgressStep = 0.01;

struct ReadLine {
    ServeRequest request;
    std::size_t bytes = 0;
};

/// A line without its line break; discards the excess of a long one. Nullopt at the end of input.
std::optional<ReadLine> nextLine(std::istream& in) {
    std::streambuf& bytes = *in.rdbuf();
    std::string line;
    bool isTooLong = false;
    int byte = bytes.sbumpc();
    if (byte == std::streambuf::traits_type::eof()) {
        return std::nullopt;
    }
    for (; byte != std::streambuf::traits_type::eof() && byte != '\n'; byte = bytes.sbumpc()) {
        isTooLong = isTooLong || line.size() >= kMaxServeLine;
        if (!isTooLong) {
            line += static_cast<char>(byte);
        }
    }
    return ReadLine{isTooLong ? tooLongServeRequest() : readServeRequest(line), line.size()};
}

class ServeLoop {
public:
    explicit ServeLoop(std::ostream& out) : out_(out) {}

    void run(std::istream& in) {
        std::thread worker([this] { work(); });
        std::thread teller([this] { tell(); });
        bool goesOn = true;
        while (goesOn) {
            auto line = nextLine(in);
            goesOn = line && line->request.what != "quit";
            if (line && line->request.what == "cancel" && !line->request.refusal) {
                cancel(line->request);
            } else if (line) {
                add(*std::move(line));
            }
        }
        {
            const std::lock_guard lock(mutex_);
            isEnding_ = true;
        }
        changed_.notify_all();
        worker.join();
        teller.join();
    }

private:
    struct Job {
        explicit Job(ReadLine line) : request(std::move(line.request)), bytes(line.bytes) {}
        ServeRequest request;
        std::size_t bytes;
        Progress progress;
    };

    /// Accepts "quit" even if the queue is full.
    void add(ReadLine line) {
        const std::lock_guard lock(mutex_);
        const bool isFull = waiting_.size() >= kMaxWaiting ||
                            (!waiting_.empty() && waitingBytes_ + line.bytes > kMaxWaitingBytes);
        if (isFull && line.request.what != "quit") {
            say(serveAnswer(
                line.request.id,
                Refusal(kTooManyRequests,
                        "too many requests are waiting; send it again when some are answered")));
            return;
        }
        waitingBytes_ += line.bytes;
        waiting_.push_back(std::make_unique<Job>(std::move(line)));
        changed_.notify_all();
    }

    /// Answers at once, even while another request is running.
    void cancel(const ServeRequest& request) {
        const std::lock_guard lock(mutex_);
        bool isFound = false;
        const auto stop = [&](const std::unique_ptr<Job>& job) {
            if (job && job->request.id == request.of) {
                job->progress.cancel();
                isFound = true;
            }
        };
        stop(running_);
        for (const auto& job : waiting_) {
            stop(job);
        }
        say(serveAnswer(request.id, OrderedJson{{"cancelled", isFound}}));
    }

    void work() {
        for (;;) {
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || isEnding_; });
                if (waiting_.empty()) {
                    return;
                }
                running_ = std::move(waiting_.front());
                waiting_.pop_front();
                waitingBytes_ -= running_->bytes;
                told_ = 0;
            }
            changed_.notify_all();
            const std::string answer = session_.answer(running_->request, running_->progress);
            const std::lock_guard lock(mutex_);
            running_.reset();
            say(answer);
        }
    }

    /// Reports the progress of running requests until the end.
    void tell() {
        std::unique_lock lock(mutex_);
        while (!isEnding_ || running_ || !waiting_.empty()) {
            changed_.wait_for(lock, kBetweenProgress);
            const double done = running_ ? running_->progress.fraction() : 0;
            if (running_ && done >= told_ + kProgressStep) {
                told_ = done;
                say(serveProgress(running_->request.id, done));
            }
        }
    }

    void say(const std::string& line) { out_ << line << std::flush; }

    std::ostream& out_;
    std::mutex mutex_;  ///< guards everything below except the session, and `out_`
    std::condition_variable changed_;
    std::deque<std::unique_ptr<Job>> waiting_;
    std::size_t waitingBytes_ = 0;
    std::unique_ptr<Job> running_;
    double told_ = 0;
    bool isEnding_ = false;
    ServeSession session_;  ///< used by the worker only
};

}  // namespace

ServeRequest readServeRequest(std::string_view line) {
    ServeRequest request;
    const auto json = parseJson(line, kLineName, ErrorCode::MalformedFile);
    if (!json) {
        request.refusal = {kWrongRequest, std::string(json.error().detail)};
        return request;
    }
    if (!json->is_object()) {
        request.refusal = {kWrongRequest, "a request must be an object"};
        return request;
    }
    JsonFaults faults;
    {
        JsonFields fields(*json, "", faults);
        readId(fields, "id", request.id);
        fields.need("do");
        fields.read("do", request.what);
        if (!fields.failed() &&
            std::ranges::find(kServeWords, request.what) == std::end(kServeWords)) {
            std::string words;
            for (const std::string_view word : kServeWords) {
                words += (words.empty() ? "" : ", ") + std::string(word);
            }
            fields.fail("do", "must be one of " + words);
        }
        if (!fields.failed()) {
            readOthers(fields, request);
        }
    }
    if (!faults.first.empty()) {
        request.refusal = {kWrongRequest, faults.first};
    } else if (!faults.unknown.empty()) {
        request.refusal = {kWrongRequest, '"' + request.what + "\" has no field \"" +
                                              faults.unknown.front() + '"'};
    }
    return request;
}

ServeRequest tooLongServeRequest() {
    ServeRequest request;
    request.refusal = {kWrongRequest,
                       "the line is longer than " + std::to_string(kMaxServeLine >> 20U) + " MiB"};
    return request;
}

std::string serveAnswer(const std::string& id, const OrderedJson& result) {
    return lineOf(id, "result", result);
}

std::string serveAnswer(const std::string& id, const Refusal& refusal) {
    return lineOf(id, "error", refusalJson(refusal));
}

std::string serveProgress(const std::string& id, double fraction) {
    return lineOf(id, "progress", fraction);
}

int runServe(std::istream& in, std::ostream& out) {
    ServeLoop(out).run(in);
    return out ? kExitDone : kExitUnreadable;
}

}  // namespace toile::app

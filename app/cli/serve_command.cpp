// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/serve_command.h"

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
#include "app/cli/serve_session.h"

namespace toile::app {
namespace {

// Of what waits. More is refused: who reads no further hears no "cancel".
constexpr std::size_t kMaxWaiting = 1024;
constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20U;
constexpr std::chrono::milliseconds kBetweenProgress{100};
constexpr double kProgressStep = 0.01;

struct ReadLine {
    ServeRequest request;
    std::size_t bytes = 0;
};

/// A line without its end; what is too long is passed over. None at the end of the input.
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

    /// "quit" always finds a place.
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

    /// Answered at once, whatever is being done.
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

    /// Says how far the running request is, until there is nothing more to do.
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
    std::mutex mutex_;  ///< of all below but the session, and of what is said
    std::condition_variable changed_;
    std::deque<std::unique_ptr<Job>> waiting_;
    std::size_t waitingBytes_ = 0;
    std::unique_ptr<Job> running_;
    double told_ = 0;
    bool isEnding_ = false;
    ServeSession session_;  ///< the worker's
};

}  // namespace

int runServe(std::istream& in, std::ostream& out) {
    ServeLoop(out).run(in);
    return out ? kExitDone : kExitUnreadable;
}

}  // namespace toile::app

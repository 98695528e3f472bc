// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/plt_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace toile {
namespace {

constexpr double kUnitsPerMillimetre = 40;
constexpr double kFarthestUnit = 1e9;  // beyond: no plot
constexpr int kMaxPens = 256;
constexpr char kLabelEnd = '\x03', kEscape = '\x1b';

bool isPltLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Draws instruction by instruction.
class PltReader {
public:
    explicit PltReader(std::string_view bytes) : rest_(bytes) {}

    Result<std::vector<PltLine>> read() {
        while (!rest_.empty() && !isScaled_) {
            if (rest_.front() == kEscape) {
                skipEscape();
            } else if (rest_.size() > 1 && isPltLetter(rest_[0]) && isPltLetter(rest_[1])) {
                const char name[] = {upper(rest_[0]), upper(rest_[1])};
                rest_.remove_prefix(2);
                take(std::string_view(name, 2));
            } else {
                rest_.remove_prefix(1);
            }
        }
        finish();
        if (isScaled_) {
            return Error{ErrorCode::MalformedFile, {}, "it has a scale of its own (SC)"};
        }
        if (!hasDrawn_) {
            return Error{ErrorCode::MalformedFile, {}, "it has no PU, PD, PA or PR"};
        }
        return std::move(lines_);
    }

private:
    void take(std::string_view name) {
        if (name == "LB") {
            rest_.remove_prefix(std::min(rest_.find(labelEnd_), rest_.size()));
        } else if (name == "DT") {
            labelEnd_ = rest_.empty() || rest_.front() == ';' ? kLabelEnd : rest_.front();
        } else if (name == "PE") {
            rest_.remove_prefix(std::min(rest_.find(';'), rest_.size()));  // not in plain numbers
        } else if (name == "IN" || name == "DF") {
            finish();
            isRelative_ = isDown_ = false;
        } else if (name == "SC") {
            isScaled_ = number().has_value();
        } else if (name == "SP") {
            finish();
            pen_ = static_cast<int>(std::clamp(number().value_or(0), 0.0, kMaxPens - 1.0));
        } else if (name == "PU" || name == "PD" || name == "PA" || name == "PR") {
            move(name);
        }
    }

    void move(std::string_view name) {
        hasDrawn_ = true;
        if (name == "PU") {
            finish();
        }
        isDown_ = name == "PD" || (isDown_ && name != "PU");
        isRelative_ = name == "PR" || (isRelative_ && name != "PA");
        while (const auto x = number()) {
            const auto y = number();
            if (!y) {
                return;
            }
            const Eigen::Vector2d to =
                Eigen::Vector2d(*x, *y) + (isRelative_ ? at_ : Eigen::Vector2d(0, 0));
            if (!(to.array().abs() < kFarthestUnit).all()) {
                return;
            }
            if (isDown_ && points_.empty()) {
                points_.push_back(at_);
            }
            at_ = to;
            if (isDown_) {
                points_.push_back(at_);
            }
        }
    }

    std::optional<double> number() {
        const std::size_t blanks = rest_.find_first_not_of(" ,\t\r\n");
        rest_.remove_prefix(std::min(blanks, rest_.size()));
        std::string_view text = rest_;
        text.remove_prefix(text.starts_with('+') ? 1 : 0);
        const std::size_t digit = text.starts_with('-') ? 1 : 0;
        if (text.size() <= digit || isPltLetter(text[digit])) {
            return {};
        }
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value,
                                                  std::chars_format::fixed);
        if (error != std::errc() || !std::isfinite(value)) {
            return {};
        }
        rest_ = text.substr(static_cast<std::size_t>(end - text.data()));
        return value;
    }

    /// To the device, not to the pen: "ESC.(;" ends with a colon or at once, others with a letter.
    void skipEscape() {
        const bool isDevice = rest_.size() > 1 && rest_[1] == '.';
        std::size_t end = 1;
        while (end < rest_.size() && (isDevice ? rest_[end] != ':' && rest_[end] != ';'
                                               : !(rest_[end] >= 'A' && rest_[end] <= 'Z'))) {
            ++end;
        }
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
    }

    void finish() {
        if (points_.size() > 1) {
            PltLine& line = lines_.emplace_back();
            line.pen = pen_;
            line.closed = points_.size() > 3 && points_.front() == points_.back();
            points_.resize(points_.size() - (line.closed ? 1 : 0));
            line.points.resize(static_cast<Eigen::Index>(points_.size()), 2);
            for (std::size_t k = 0; k < points_.size(); ++k) {
                line.points.row(static_cast<Eigen::Index>(k)) =
                    points_[k].transpose() / kUnitsPerMillimetre;
            }
        }
        points_.clear();
    }

    std::string_view rest_;
    std::vector<PltLine> lines_;
    std::vector<Eigen::Vector2d> points_;  ///< units
    Eigen::Vector2d at_{0, 0};
    int pen_ = 0;
    char labelEnd_ = kLabelEnd;
    bool isDown_ = false, isRelative_ = false, isScaled_ = false, hasDrawn_ = false;
};

}  // namespace

Result<std::vector<PltLine>> readPlt(std::string_view bytes) {
    return PltReader(bytes).read();
}

}  // namespace toile

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace toile {
namespace {

constexpr std::string_view kSvgBlanks = " \t\r\n\f,";
constexpr double kPixel = 25.4 / 96;  // mm

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

struct SvgUnit {
    std::string_view name;
    double millimetres;
};

constexpr SvgUnit kSvgUnits[] = {{"", kPixel}, {"px", kPixel}, {"pt", 25.4 / 72}, {"pc", 25.4 / 6},
                                 {"mm", 1},    {"cm", 10},     {"in", 25.4},      {"Q", 0.25}};

/// One map of a list; the identity if numbers are missing.
Eigen::Affine2d singleTransform(std::string_view name, const std::vector<double>& n) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
    if (name == "matrix" && n.size() == 6) {
        map.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
    } else if (name == "translate" && !n.empty()) {
        map.translate(Eigen::Vector2d(n[0], n.size() > 1 ? n[1] : 0));
    } else if (name == "scale" && !n.empty()) {
        map.scale(Eigen::Vector2d(n[0], n.size() > 1 ? n[1] : n[0]));
    } else if (name == "rotate" && !n.empty()) {
        const Eigen::Vector2d middle =
            n.size() > 2 ? Eigen::Vector2d(n[1], n[2]) : Eigen::Vector2d(0, 0);
        map.translate(middle).rotate(radians(n[0])).translate(-middle);
    } else if (name == "skewX" && n.size() == 1) {
        map.matrix()(0, 1) = std::tan(radians(n[0]));
    } else if (name == "skewY" && n.size() == 1) {
        map.matrix()(1, 0) = std::tan(radians(n[0]));
    }
    return map;
}

}  // namespace

void SvgNumbers::skipBlanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSvgBlanks), rest_.size()));
}

std::optional<double> SvgNumbers::number() {
    skipBlanks();
    std::string_view text = rest_;
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    // from_chars would also accept "nan" and "infinity".
    const std::size_t digit = text.starts_with('-') ? 1 : 0;
    if (text.size() <= digit ||
        !((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.')) {
        return {};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
        return {};
    }
    rest_ = text.substr(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<Eigen::Vector2d> SvgNumbers::pair() {
    const auto x = number();
    const auto y = x ? number() : std::nullopt;
    return y ? std::optional(Eigen::Vector2d(*x, *y)) : std::nullopt;
}

std::optional<bool> SvgNumbers::flag() {
    skipBlanks();
    if (!rest_.starts_with('0') && !rest_.starts_with('1')) {
        return {};
    }
    const bool isSet = rest_.front() == '1';
    rest_.remove_prefix(1);
    return isSet;
}

std::optional<char> SvgNumbers::letter() {
    skipBlanks();
    if (rest_.empty() || !isLetter(rest_.front())) {
        return {};
    }
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    return letter;
}

std::optional<SvgNumbers::Call> SvgNumbers::call() {
    skipBlanks();
    const std::size_t open = rest_.find('('), close = rest_.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        return {};
    }
    std::string_view name = rest_.substr(0, open);
    const std::size_t last = name.find_last_not_of(kSvgBlanks);
    name = name.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const Call call{name, rest_.substr(open + 1, close - open - 1)};
    rest_.remove_prefix(close + 1);
    return call;
}

Eigen::Affine2d svgTransform(std::string_view list) {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    SvgNumbers calls(list);
    while (const auto call = calls.call()) {
        std::vector<double> numbers;
        SvgNumbers arguments(call->list);
        while (const auto number = arguments.number()) {
            numbers.push_back(*number);
        }
        map = map * singleTransform(call->name, numbers);
    }
    return map;
}

std::optional<double> svgLength(std::string_view text) {
    SvgNumbers numbers(text);
    const auto value = numbers.number();
    std::string_view unit = numbers.rest();
    const std::size_t last = unit.find_last_not_of(kSvgBlanks);
    unit = unit.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const auto known = std::ranges::find(kSvgUnits, unit, &SvgUnit::name);
    return value && known != std::end(kSvgUnits) ? std::optional(*value * known->millimetres)
                                                 : std::nullopt;
}

namespace {

using Eigen::Vector2d;

constexpr double kFineness = 0.005;    // of curves, mm
constexpr double kFarthest = 1e7;      // of a point, mm
constexpr double kMaxPerCurve = 4096;  // points

/// Draws the commands of a path one by one.
class PathBuilder {
public:
    PathBuilder(const Eigen::Affine2d& place, std::size_t& most) : place_(place), most_(most) {}

    const Vector2d& at() const { return at_; }
    /// The handle for S and T: the previous curve's last handle reflected, else the current point.
    Vector2d reflected(bool isCubic) const {
        return isCubic == isCubic_ && hasHandle_ ? Vector2d(2 * at_ - handle_) : at_;
    }

    void move(const Vector2d& to) {
        finish(false);
        start_ = at_ = to;
        hasHandle_ = false;
    }

    void line(const Vector2d& to) {
        begin();
        push(place_ * to);
        at_ = to;
        hasHandle_ = false;
    }

    void cubic(const Vector2d& first, const Vector2d& second, const Vector2d& to) {
        begin();
        const Vector2d a = place_ * at_, b = place_ * first, c = place_ * second, d = place_ * to;
        const double bend = std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
        const double count = std::ceil(std::sqrt(0.75 * bend / kFineness));
        if (!std::isfinite(count)) {
            isBroken_ = true;
            return;
        }
        const int steps = static_cast<int>(std::clamp(count, 1.0, kMaxPerCurve));
        for (int k = 1; k < steps && most_ > 0; ++k) {
            const double t = static_cast<double>(k) / steps, s = 1 - t;
            push(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
        }
        push(d);
        at_ = to;
        keepHandle(second, true);
    }

    void quadratic(const Vector2d& handle, const Vector2d& to) {
        cubic(at_ + (handle - at_) * 2 / 3, to + (handle - to) * 2 / 3, to);
        keepHandle(handle, false);
    }

    void arc(Vector2d radii, double degrees, bool isLong, bool isPositive, const Vector2d& to);

    void close() {
        finish(true);
        at_ = start_;
        hasHandle_ = false;
    }

    std::vector<SvgContour> taken() {
        finish(false);
        return std::move(contours_);
    }

private:
    void keepHandle(const Vector2d& handle, bool isCubic) {
        handle_ = handle;
        isCubic_ = isCubic;
        hasHandle_ = true;
    }

    void begin() {
        if (points_.empty()) {
            push(place_ * at_);
        }
    }

    void push(const Vector2d& point) {
        isBroken_ = isBroken_ || !(point.array().abs() < kFarthest).all() || most_ == 0;
        if (!isBroken_) {
            points_.push_back(point);
            --most_;
        }
    }

    void finish(bool isClosed) {
        if (isClosed && points_.size() > 2 &&
            (points_.front() - points_.back()).norm() < 1e-3 * kFineness) {
            points_.pop_back();
        }
        if (!isBroken_ && points_.size() > 1) {
            SvgContour& contour = contours_.emplace_back();
            contour.closed = isClosed;
            contour.points.resize(static_cast<Eigen::Index>(points_.size()), 2);
            for (std::size_t k = 0; k < points_.size(); ++k) {
                contour.points.row(static_cast<Eigen::Index>(k)) = points_[k].transpose();
            }
        }
        points_.clear();
        isBroken_ = false;
    }

    const Eigen::Affine2d& place_;
    std::size_t& most_;
    Vector2d at_{0, 0}, start_{0, 0}, handle_{0, 0};
    bool hasHandle_ = false, isCubic_ = false, isBroken_ = false;
    std::vector<Vector2d> points_;
    std::vector<SvgContour> contours_;
};

/// Draws an arc by the centre of its ellipse, in curves of at most a sixteenth of a turn.
void PathBuilder::arc(Vector2d radii, double degrees, bool isLong, bool isPositive,
                      const Vector2d& to) {
    radii = radii.cwiseAbs();
    const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
    if (!(radii.minCoeff() > 0) || to == at_) {
        line(to);
        return;
    }
    // In the frame where the ellipse is the unit circle about `middle`.
    const auto toCircle = [&](const Vector2d& point) -> Vector2d {
        return (turn.inverse() * point).cwiseQuotient(radii);
    };
    Vector2d from = toCircle(at_), end = toCircle(to);
    const double half = (end - from).norm() / 2;
    if (half > 1) {  // radii too small: enlarge them to the minimum
        radii *= half;
        from = toCircle(at_);
        end = toCircle(to);
    }
    const Vector2d chord = end - from;
    const double away = std::sqrt(std::max(0.0, 1 / chord.squaredNorm() - 0.25));
    const Vector2d side = Vector2d(-chord.y(), chord.x()) * (isLong == isPositive ? -away : away);
    const Vector2d middle = (from + end) / 2 + side;
    const auto angleOf = [&middle](const Vector2d& point) {
        return std::atan2(point.y() - middle.y(), point.x() - middle.x());
    };
    const double first = angleOf(from);
    double sweep = angleOf(end) - first;
    constexpr double kTurn = 2 * std::numbers::pi;
    sweep += isPositive && sweep < 0 ? kTurn : !isPositive && sweep > 0 ? -kTurn : 0;
    if (!std::isfinite(sweep)) {
        isBroken_ = true;
        return;
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (kTurn / 16))));
    const double step = sweep / parts, reach = 4.0 / 3 * std::tan(step / 4);
    const auto fromCircle = [&](const Vector2d& point) -> Vector2d {
        return turn * (middle + point).cwiseProduct(radii);
    };
    for (int k = 0; k < parts; ++k) {
        const double a = first + k * step, b = a + step;
        const Vector2d p(std::cos(a), std::sin(a)), q(std::cos(b), std::sin(b));
        cubic(fromCircle(p + reach * Vector2d(-p.y(), p.x())),
              fromCircle(q - reach * Vector2d(-q.y(), q.x())), k + 1 == parts ? to : fromCircle(q));
    }
    hasHandle_ = false;
}

/// Reads the numbers of one command and draws it; false if they are invalid.
bool drawCommand(char command, SvgNumbers& numbers, PathBuilder& path) {
    const bool isRelative = command >= 'a';
    const Vector2d base = isRelative ? path.at() : Vector2d(0, 0);
    const auto place = [&]() -> std::optional<Vector2d> {
        const auto pair = numbers.pair();
        return pair ? std::optional<Vector2d>(base + *pair) : std::nullopt;
    };
    const char kind = isRelative ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind == 'H' || kind == 'V') {
        const auto value = numbers.number();
        if (value) {
            path.line(kind == 'H' ? Vector2d(base.x() + *value, path.at().y())
                                  : Vector2d(path.at().x(), base.y() + *value));
        }
        return value.has_value();
    }
    if (kind == 'A') {
        const auto radii = numbers.pair();
        const auto degrees = radii ? numbers.number() : std::nullopt;
        const auto isLong = degrees ? numbers.flag() : std::nullopt;
        const auto isPositive = isLong ? numbers.flag() : std::nullopt;
        const auto to = isPositive ? place() : std::nullopt;
        if (to) {
            path.arc(*radii, *degrees, *isLong, *isPositive, *to);
        }
        return to.has_value();
    }
    const int count = kind == 'C' ? 3 : kind == 'S' || kind == 'Q' ? 2 : 1;
    Vector2d points[3];
    for (int k = 0; k < count; ++k) {
        const auto point = place();
        if (!point) {
            return false;
        }
        points[k] = *point;
    }
    switch (kind) {
        case 'M':
            path.move(points[0]);
            return true;
        case 'L':
            path.line(points[0]);
            return true;
        case 'C':
            path.cubic(points[0], points[1], points[2]);
            return true;
        case 'S':
            path.cubic(path.reflected(true), points[0], points[1]);
            return true;
        case 'Q':
            path.quadratic(points[0], points[1]);
            return true;
        case 'T':
            path.quadratic(path.reflected(false), points[0]);
            return true;
        default:
            return false;
    }
}

}  // namespace

std::vector<SvgContour> svgContours(std::string_view data, const Eigen::Affine2d& place,
                                    std::size_t& most) {
    SvgNumbers numbers(data);
    PathBuilder path(place, most);
    char command = 0;
    while (most > 0) {
        if (const auto letter = numbers.letter()) {
            command = *letter;
            if (command == 'Z' || command == 'z') {
                path.close();
                continue;
            }
        } else if (command == 'Z' || command == 'z') {
            break;
        }
        if (command == 0 || !drawCommand(command, numbers, path)) {
            break;
        }
        // Further pairs after M are lines.
        command = command == 'M' ? 'L' : command == 'm' ? 'l' : command;
    }
    return path.taken();
}

}  // namespace toile

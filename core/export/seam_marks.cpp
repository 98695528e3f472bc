// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/export/drawing.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

constexpr double kTick = 5;            // mm; shorter on a short seam
constexpr double kTickOfSeam = 0.2;    // of the seam's length, at most
constexpr double kNameHeight = 2.5;    // mm, of a capital
constexpr double kSmallestText = 0.8;  // mm: what cannot be read is not written
constexpr double kNameOfSeam = 0.8;    // of the seam's length that a text may take
constexpr double kOffCut = 1.2;        // capital heights between the outline and the text's middle
constexpr double kSameTick = 0.1;      // mm

double lengthOf(const Points2& line) {
    double length = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        length += (line.row(i) - line.row(i - 1)).norm();
    }
    return length;
}

/// The point at an arc length.
Eigen::Vector2d pointAt(const Points2& line, double arc) {
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const double step = (line.row(i) - line.row(i - 1)).norm();
        if (arc <= step && step > 0) {
            return (line.row(i - 1) + arc / step * (line.row(i) - line.row(i - 1))).transpose();
        }
        arc -= step;
    }
    return line.bottomRows<1>().transpose();
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

class Marker {
public:
    Marker(Drawing& drawing, const PatternPiece& piece, const Eigen::Vector2d& offset)
        : drawing_(drawing), id_("piece-" + piece.id + "--seam-"), offset_(offset) {}

    void mark(const SeamMark& seam) {
        const double length = lengthOf(seam.line);
        if (!(length > 0)) {
            return;
        }
        const bool second = !numbers_.insert(seam.number).second;
        const std::string id = id_ + std::to_string(seam.number) + (second ? "b" : "");
        const double tick = std::min(kTick, kTickOfSeam * length);
        addTick(id + "-tick-1", pointAt(seam.line, 0), pointAt(seam.line, tick), tick);
        if (!seam.closed) {
            // Seen from the end backwards the cloth is on the right.
            addTick(id + "-tick-2", pointAt(seam.line, length), pointAt(seam.line, length - tick),
                    -tick);
        }
        addName(id + "-name", seam, length);
    }

private:
    /// A tick at `from`, square to the way towards `towards`, `size` to its left.
    void addTick(std::string id, const Eigen::Vector2d& from, const Eigen::Vector2d& towards,
                 double size) {
        const Eigen::Vector2d way = towards - from;
        if (!(way.norm() > 0)) {
            return;
        }
        const Eigen::Vector2d tip = from + size * leftOf(way.normalized());
        for (const auto& [otherFrom, otherTip] : ticks_) {
            if ((from - otherFrom).norm() < kSameTick && (tip - otherTip).norm() < kSameTick) {
                return;  // the seam before ends here, straight on
            }
        }
        ticks_.emplace_back(from, tip);
        Points2 line(2, 2);
        line << from.transpose(), tip.transpose();
        line.rowwise() += offset_.transpose();
        drawing_.paths.push_back({std::move(id), LayerKind::Marks, std::move(line), false});
    }

    void addName(std::string id, const SeamMark& seam, double length) {
        const std::string number = std::to_string(seam.number);
        std::string words = number + "  " + seam.name;
        double height = kNameHeight;
        if (textExtent({words}, height).x() > kNameOfSeam * length) {
            words = number;
            height = std::min(height, kNameOfSeam * length / textExtent({words}, 1).x());
        }
        if (height < kSmallestText) {
            return;
        }
        const double half = 0.5 * textExtent({words}, height).x();
        const Eigen::Vector2d before = pointAt(seam.line, std::max(0.0, 0.5 * length - half));
        const Eigen::Vector2d after = pointAt(seam.line, std::min(length, 0.5 * length + half));
        Eigen::Vector2d along = after - before;
        if (!(along.norm() > 0)) {
            return;
        }
        along.normalize();
        // Clear of an edge that bulges into the cloth under the text.
        double bulge = 0;
        for (Eigen::Index i = 0; i < seam.line.rows(); ++i) {
            const Eigen::Vector2d p = seam.line.row(i).transpose() - before;
            const double place = p.dot(along);
            if (place > 0 && place < 2 * half) {
                bulge = std::max(bulge, p.dot(leftOf(along)));
            }
        }
        const Eigen::Vector2d middle =
            0.5 * (before + after) + (bulge + kOffCut * height) * leftOf(along) + offset_;
        double angle = std::atan2(along.y(), along.x());
        if (angle > 0.5 * std::numbers::pi + 1e-9 || angle <= -0.5 * std::numbers::pi + 1e-9) {
            angle += angle > 0 ? -std::numbers::pi : std::numbers::pi;  // never upside down
        }
        drawing_.texts.push_back(
            {std::move(id), LayerKind::Marks, middle, height, {std::move(words)}, angle});
    }

    Drawing& drawing_;
    std::string id_;
    Eigen::Vector2d offset_;
    std::set<int> numbers_;
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> ticks_;
};

}  // namespace

void addSeamMarks(Drawing& drawing, const PatternPiece& piece, const Eigen::Vector2d& offset) {
    Marker marker(drawing, piece, offset);
    for (const SeamMark& seam : piece.seams) {
        marker.mark(seam);
    }
}

}  // namespace toile

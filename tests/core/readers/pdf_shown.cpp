// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_shown.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/core/readers/pdf_document.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Kind = PdfValue::Kind;
using PageMatrix = Eigen::Matrix<double, 2, 3>;

constexpr std::size_t kMaxSaved = 64, kMaxMarked = 64, kMaxOperands = 64;
/// Of a stream: ours have some ten thousand points.
constexpr std::size_t kMaxPagePoints = std::size_t{1} << 23;
constexpr double kSampledWithin = 1e-3, kMaxSamples = 4096;
constexpr double kFarthestOnPage = 1e9;  // of a point
constexpr std::size_t kLongestId = 1000, kMaxForms = 100000;

const std::map<std::string, LayerKind, std::less<>>& kindsOfLayers() {
    static const std::map<std::string, LayerKind, std::less<>> kNamed{
        {"cut", LayerKind::Cut},         {"seam line", LayerKind::Sew},
        {"notches", LayerKind::Notches}, {"internal lines", LayerKind::Internal},
        {"marks", LayerKind::Marks},     {"grain", LayerKind::Grain},
        {"labels", LayerKind::Text},     {"check", LayerKind::Check}};
    return kNamed;
}

Vector2d through(const PageMatrix& matrix, const Vector2d& point) {
    return matrix.leftCols<2>() * point + matrix.col(2);
}

/// What is inside `inner` first goes through it, then through `outer`.
PageMatrix matrixThrough(const PageMatrix& outer, const PageMatrix& inner) {
    PageMatrix both;
    both.leftCols<2>() = outer.leftCols<2>() * inner.leftCols<2>();
    both.col(2) = through(outer, inner.col(2));
    return both;
}

/// A path as it is drawn: its points, curves sampled.
struct PathPoints {
    std::vector<Vector2d> points;
    bool closed = false;

    void curveTo(const Vector2d& b, const Vector2d& c, const Vector2d& d) {
        const Vector2d a = points.back();
        const double bend = std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
        const double steps =
            std::clamp(std::ceil(std::sqrt(0.75 * bend / kSampledWithin)), 1.0, kMaxSamples);
        for (int k = 1; k < steps; ++k) {
            const double t = k / steps, s = 1 - t;
            points.emplace_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c +
                                t * t * t * d);
        }
        points.push_back(d);
    }

    ReadLine line() const {
        ReadLine found{.closed = closed};
        // The first point of a closed line is not repeated.
        std::size_t count = points.size();
        if (closed && count > 1 && points.front() == points.back()) {
            --count;
        }
        found.points.resize(static_cast<Eigen::Index>(count), 2);
        for (std::size_t k = 0; k < count; ++k) {
            found.points.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
        }
        return found;
    }
};

struct Marked {
    std::string layer{}, id{}, piece{};
};

class ContentReader {
public:
    /// @param layers  names by keys of the resources
    explicit ContentReader(const std::map<std::string, std::string>& layers) : layers_(layers) {}

    Result<PdfShown> read(std::string_view content) {
        PdfLexer lexer(content, false);
        while (std::optional<PdfValue> value = lexer.next()) {
            if (value->kind != Kind::Word) {
                operands_.push_back(std::move(*value));
                if (operands_.size() > kMaxOperands) {
                    return malformedPdf("a content stream has too many operands");
                }
                continue;
            }
            if (!apply(value->text)) {
                return malformedPdf("a content stream has a wrong \"" + value->text + "\"");
            }
            operands_.clear();
        }
        if (content.find_first_not_of(" \r\n\t", lexer.at()) != std::string_view::npos ||
            !marked_.empty() || !saved_.empty()) {
            return malformedPdf("a content stream is cut short");
        }
        return std::move(shown_);
    }

private:
    struct State {
        PageMatrix matrix = PageMatrix::Identity();
        AlignedBox2d clip{Vector2d::Constant(-1e12), Vector2d::Constant(1e12)};
    };

    std::optional<double> number(std::size_t k) const {
        return k < operands_.size() && operands_[k].kind == Kind::Number
                   ? std::optional(operands_[k].number)
                   : std::nullopt;
    }

    /// So many numbers, and nothing else.
    bool takes(std::size_t count) const {
        return operands_.size() == count &&
               std::ranges::all_of(operands_, [](const PdfValue& value) -> bool {
                   return value.kind == Kind::Number;
               });
    }

    Vector2d point(std::size_t k) const {
        return through(state_.matrix, {operands_[k].number, operands_[k + 1].number});
    }

    /// Whether a point is anywhere near a page, so that what comes of it is finite.
    bool isNear(std::size_t k) const { return (point(k).array().abs() < kFarthestOnPage).all(); }

    bool apply(const std::string& word) {
        if (word == "m" || word == "l" || word == "c" || word == "re") {
            return build(word);
        }
        if (word == "h") {
            return close();
        }
        if (word == "q" || word == "Q" || word == "cm") {
            return changeState(word);
        }
        if (word == "BDC" || word == "EMC") {
            return mark(word);
        }
        if (word == "W") {
            isClipping_ = true;
            return true;
        }
        if (word == "Do") {
            if (operands_.size() != 1 || operands_[0].kind != Kind::Name ||
                operands_[0].text.size() > kLongestId || shown_.forms.size() >= kMaxForms) {
                return false;
            }
            shown_.forms.push_back({operands_[0].text, {state_.matrix, state_.clip}});
            return true;
        }
        if (word == "s") {
            return close() && paint();
        }
        if (word == "S" || word == "f" || word == "n") {
            return paint();
        }
        return true;  // widths, greys, text
    }

    bool build(const std::string& word) {
        if (word == "re") {
            if (!takes(4)) {
                return false;
            }
            const Vector2d low(operands_[0].number, operands_[1].number);
            const Vector2d size(operands_[2].number, operands_[3].number);
            PathPoints& box = paths_.emplace_back();
            for (const Vector2d& share :
                 {Vector2d(0, 0), Vector2d(1, 0), Vector2d(1, 1), Vector2d(0, 1)}) {
                box.points.push_back(through(state_.matrix, low + size.cwiseProduct(share)));
                if (!(box.points.back().array().abs() < kFarthestOnPage).all()) {
                    return false;
                }
            }
            box.closed = true;
            points_ += box.points.size();
            return points_ <= kMaxPagePoints;
        }
        if (!takes(word == "c" ? 6 : 2) || (word != "m" && paths_.empty())) {
            return false;
        }
        for (std::size_t k = 0; k < operands_.size(); k += 2) {
            if (!isNear(k)) {
                return false;
            }
        }
        ++points_;
        if (word == "m") {
            paths_.emplace_back().points.push_back(point(0));
        } else if (word == "l") {
            paths_.back().points.push_back(point(0));
        } else {
            PathPoints& path = paths_.back();
            const std::size_t before = path.points.size();
            path.curveTo(point(0), point(2), point(4));
            points_ += path.points.size() - before;
        }
        return points_ <= kMaxPagePoints;
    }

    bool close() {
        if (paths_.empty()) {
            return false;
        }
        paths_.back().closed = true;
        return true;
    }

    bool changeState(const std::string& word) {
        if (word == "q") {
            saved_.push_back(state_);
            return saved_.size() <= kMaxSaved;
        }
        if (word == "Q") {
            if (saved_.empty()) {
                return false;
            }
            state_ = saved_.back();
            saved_.pop_back();
            return true;
        }
        if (!takes(6)) {
            return false;
        }
        PageMatrix own;
        own << operands_[0].number, operands_[2].number, operands_[4].number, operands_[1].number,
            operands_[3].number, operands_[5].number;
        state_.matrix = matrixThrough(state_.matrix, own);
        return state_.matrix.allFinite();
    }

    bool mark(const std::string& word) {
        if (word == "EMC") {
            if (marked_.empty()) {
                return false;
            }
            marked_.pop_back();
            return true;
        }
        if (operands_.size() != 2 || operands_[0].kind != Kind::Name ||
            marked_.size() >= kMaxMarked) {
            return false;
        }
        Marked next = marked_.empty() ? Marked{} : marked_.back();
        if (operands_[0].isName("OC")) {
            const auto at = layers_.find(operands_[1].text);
            if (at == layers_.end()) {
                return false;
            }
            next.layer = at->second;
        } else if (operands_[0].isName("Toile")) {
            const PdfValue* id = operands_[1].find("Id");
            const PdfValue* piece = operands_[1].find("Piece");
            if (!id || id->kind != Kind::String || id->text.size() > kLongestId ||
                (piece && piece->kind != Kind::String)) {
                return false;
            }
            next.id = id->text;
            next.piece = piece ? piece->text : "";
        }
        marked_.push_back(std::move(next));
        return true;
    }

    bool paint() {
        const std::vector<PathPoints> paths = std::exchange(paths_, {});
        if (std::exchange(isClipping_, false)) {
            AlignedBox2d box;
            for (const PathPoints& path : paths) {
                for (const Vector2d& corner : path.points) {
                    box.extend(corner);
                }
            }
            state_.clip = state_.clip.intersection(box);
            return true;
        }
        if (marked_.empty() || marked_.back().id.empty()) {
            return true;
        }
        const auto kind = kindsOfLayers().find(marked_.back().layer);
        if (kind == kindsOfLayers().end()) {
            return false;
        }
        for (const PathPoints& path : paths) {
            ReadLine& line = shown_.lines.emplace_back(path.line());
            line.layer = kind->second;
            line.id = marked_.back().id;
            points_ += 4 + line.id.size() / sizeof(Vector2d);
        }
        if (!marked_.back().piece.empty()) {
            shown_.pieces.insert(marked_.back().piece);
        }
        return points_ <= kMaxPagePoints;
    }

    const std::map<std::string, std::string>& layers_;
    PdfShown shown_;
    State state_;
    std::vector<State> saved_;
    std::vector<Marked> marked_;
    std::vector<PathPoints> paths_;
    bool isClipping_ = false;
    std::size_t points_ = 0;  ///< and what weighs as much
    std::vector<PdfValue> operands_;
};

}  // namespace

Result<PdfShown> readPdfContent(std::string_view content,
                                const std::map<std::string, std::string>& layers) {
    return ContentReader(layers).read(content);
}

}  // namespace toile

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/pdf_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/reading/pdf_document.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Kind = PdfValue::Kind;
using Matrix = Eigen::Matrix<double, 2, 3>;

constexpr std::size_t kMostSaved = 64, kMostMarked = 64, kMostOperands = 64;
constexpr std::size_t kMostPages = 20000;
/// Of all that a file shows: ours have some ten thousand points, and a megabyte of content.
constexpr std::size_t kMostPoints = std::size_t{1} << 24, kMostContent = std::size_t{1} << 29;
constexpr double kSampledWithin = 1e-3, kMostSamples = 4096;

const std::map<std::string, LayerKind, std::less<>>& kinds() {
    static const std::map<std::string, LayerKind, std::less<>> kNamed{
        {"cut", LayerKind::Cut},         {"seam line", LayerKind::Sew},
        {"notches", LayerKind::Notches}, {"internal lines", LayerKind::Internal},
        {"marks", LayerKind::Marks},     {"grain", LayerKind::Grain},
        {"labels", LayerKind::Text},     {"check", LayerKind::Check}};
    return kNamed;
}

Vector2d through(const Matrix& matrix, const Vector2d& point) {
    return matrix.leftCols<2>() * point + matrix.col(2);
}

/// What is inside `inner` first goes through it, then through `outer`.
Matrix joined(const Matrix& outer, const Matrix& inner) {
    Matrix both;
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
            std::clamp(std::ceil(std::sqrt(0.75 * bend / kSampledWithin)), 1.0, kMostSamples);
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

/// What a content stream shows.
struct Shown {
    std::vector<ReadLine> lines;
    std::set<std::string> pieces;
    std::vector<std::pair<std::string, ReadPdfView>> forms;  ///< by their keys
};

class ContentReader {
public:
    /// @param layers  names by keys of the resources
    explicit ContentReader(const std::map<std::string, std::string>& layers) : layers_(layers) {}

    Result<Shown> read(std::string_view content) {
        PdfLexer lexer(content, false);
        while (std::optional<PdfValue> value = lexer.next()) {
            if (value->kind != Kind::Word) {
                operands_.push_back(std::move(*value));
                if (operands_.size() > kMostOperands) {
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
        Matrix matrix = Matrix::Identity();
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
            if (operands_.size() != 1 || operands_[0].kind != Kind::Name) {
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
            }
            box.closed = true;
            return true;
        }
        if (!takes(word == "c" ? 6 : 2) || (word != "m" && paths_.empty())) {
            return false;
        }
        if (word == "m") {
            paths_.emplace_back().points.push_back(point(0));
        } else if (word == "l") {
            paths_.back().points.push_back(point(0));
        } else {
            PathPoints& path = paths_.back();
            const std::size_t before = path.points.size();
            path.curveTo(point(0), point(2), point(4));
            curvePoints_ += path.points.size() - before;
        }
        return curvePoints_ <= kMostPoints;
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
            return saved_.size() <= kMostSaved;
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
        Matrix own;
        own << operands_[0].number, operands_[2].number, operands_[4].number, operands_[1].number,
            operands_[3].number, operands_[5].number;
        state_.matrix = joined(state_.matrix, own);
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
            marked_.size() >= kMostMarked) {
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
            if (!id || id->kind != Kind::String || (piece && piece->kind != Kind::String)) {
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
        const auto kind = kinds().find(marked_.back().layer);
        if (kind == kinds().end()) {
            return false;
        }
        for (const PathPoints& path : paths) {
            ReadLine& line = shown_.lines.emplace_back(path.line());
            line.layer = kind->second;
            line.id = marked_.back().id;
        }
        if (!marked_.back().piece.empty()) {
            shown_.pieces.insert(marked_.back().piece);
        }
        return true;
    }

    const std::map<std::string, std::string>& layers_;
    Shown shown_;
    State state_;
    std::vector<State> saved_;
    std::vector<Marked> marked_;
    std::vector<PathPoints> paths_;
    bool isClipping_ = false;
    std::size_t curvePoints_ = 0;
    std::vector<PdfValue> operands_;
};

/// Pages, layers and content of a document.
class PdfReader {
public:
    explicit PdfReader(const PdfDocument& document) : document_(document) {}

    Result<ReadPdf> read() {
        const auto catalog = document_.entry(document_.trailer(), "Root");
        if (!catalog) {
            return catalog.error();
        }
        if (const auto done = readLayers(*catalog); !done) {
            return done.error();
        }
        const auto root = document_.entry(*catalog, "Pages");
        if (!root) {
            return root.error();
        }
        const auto kids = document_.entry(*root, "Kids");
        const auto count = document_.entry(*root, "Count");
        if (!kids || !count || kids->items.size() > kMostPages ||
            count->number != static_cast<double>(kids->items.size())) {
            return malformedPdf("the pages are not counted");
        }
        for (const PdfValue& kid : kids->items) {
            if (const auto done = readPage(kid); !done) {
                return done.error();
            }
        }
        if (formKey_.empty()) {
            return malformedPdf("no page shows the drawing");
        }
        return std::move(read_);
    }

private:
    Result<void> readLayers(const PdfValue& catalog) {
        const auto properties = document_.entry(catalog, "OCProperties");
        if (!properties) {
            return properties.error();
        }
        const auto groups = document_.entry(*properties, "OCGs");
        const auto usual = document_.entry(*properties, "D");
        if (!groups || !usual) {
            return malformedPdf("the layers are not listed");
        }
        if (const auto done = addNames(*groups, read_.layers); !done) {
            return done.error();
        }
        const auto hidden = document_.entry(*usual, "OFF");
        return hidden ? addNames(*hidden, read_.hiddenLayers) : hidden.error();
    }

    Result<void> addNames(const PdfValue& groups, std::vector<std::string>& names) const {
        for (const PdfValue& group : groups.items) {
            const auto found = document_.resolved(group);
            const PdfValue* name = found ? found->find("Name") : nullptr;
            if (!name || name->kind != Kind::String) {
                return malformedPdf("a layer has no name");
            }
            names.push_back(name->text);
        }
        return {};
    }

    /// Names of layers by their keys in a dictionary of resources.
    Result<std::map<std::string, std::string>> layerKeys(const PdfValue& resources) const {
        std::map<std::string, std::string> keys;
        const auto properties = document_.entry(resources, "Properties");
        if (!properties) {
            return properties.error();
        }
        for (std::size_t k = 0; k < properties->keys.size(); ++k) {
            const auto group = document_.resolved(properties->items[k]);
            const PdfValue* name = group ? group->find("Name") : nullptr;
            if (!name) {
                return malformedPdf("a layer has no name");
            }
            keys[properties->keys[k]] = name->text;
        }
        return keys;
    }

    Result<Shown> shownIn(const PdfValue& resources, const PdfValue& stream) {
        const auto keys = layerKeys(resources);
        if (!keys) {
            return keys.error();
        }
        const auto content = document_.stream(stream);
        if (!content) {
            return content.error();
        }
        length_ += content->size();
        if (length_ > kMostContent) {
            return malformedPdf("its pages are too long");
        }
        return ContentReader(*keys).read(*content);
    }

    Result<void> readPage(const PdfValue& reference) {
        const auto page = document_.resolved(reference);
        if (!page) {
            return page.error();
        }
        const auto box = document_.entry(*page, "MediaBox");
        const auto resources = document_.entry(*page, "Resources");
        const PdfValue* content = page->find("Contents");
        if (!box || box->items.size() != 4 || !resources || !content) {
            return malformedPdf("a page is incomplete");
        }
        const auto& side = box->items;
        ReadPdfPage& made = read_.pages.emplace_back(
            ReadPdfPage{{side[2].number - side[0].number, side[3].number - side[1].number}});
        auto shown = shownIn(*resources, *content);
        if (!shown) {
            return shown.error();
        }
        made.lines = std::move(shown->lines);
        for (const auto& [key, view] : shown->forms) {
            if (formKey_.empty()) {
                if (const auto done = readForm(*resources, key); !done) {
                    return done.error();
                }
            } else if (key != formKey_) {
                return malformedPdf("pages show more than one drawing");
            }
            made.views.push_back(view);
        }
        return {};
    }

    Result<void> readForm(const PdfValue& resources, const std::string& key) {
        const auto forms = document_.entry(resources, "XObject");
        const PdfValue* reference = forms ? forms->find(key) : nullptr;
        const auto form = reference ? document_.resolved(*reference) : malformedPdf("no drawing");
        if (!form || form->find("Matrix")) {
            return malformedPdf("the drawing is missing");
        }
        const auto own = document_.entry(*form, "Resources");
        if (!own) {
            return own.error();
        }
        auto shown = shownIn(*own, *reference);
        if (!shown) {
            return shown.error();
        }
        read_.drawing.lines = std::move(shown->lines);
        read_.drawing.pieces = static_cast<int>(shown->pieces.size());
        formKey_ = key;
        return {};
    }

    const PdfDocument& document_;
    ReadPdf read_;
    std::string formKey_;
    std::size_t length_ = 0;  ///< of the content so far
};

}  // namespace

Result<ReadPdf> readPdf(std::string_view bytes) {
    const auto document = PdfDocument::read(bytes);
    if (!document) {
        return document.error();
    }
    return PdfReader(*document).read();
}

}  // namespace toile

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/name_plates.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <numeric>
#include <optional>

#include "app/views/view_text.h"

namespace toile::app {

namespace {

/// Of its piece's width: a plate in the middle still lies on its own piece by half.
constexpr double kRoom = 2;
/// Letters that a shortened name must keep.
constexpr int kLeastLetters = 4;
constexpr double kAir = 2;       ///< pixels between plates
constexpr double kLeastBox = 6;  ///< smaller pieces are dots

bool meetsAny(const QRectF& plate, const std::vector<QRectF>& others) {
    return std::ranges::any_of(
        others, [&plate](const QRectF& other) -> bool { return plate.intersects(other); });
}

/// How many letters all names begin with, up to the end of a word: "panel 5", "panel 15".
int commonBeginning(const std::vector<NamedPiece>& pieces) {
    if (pieces.size() < 2) {
        return 0;
    }
    const QString& first = pieces.front().name;
    qsizetype common = first.size();
    for (const NamedPiece& piece : pieces) {
        const auto ends = std::ranges::mismatch(first, piece.name);
        common = std::min<qsizetype>(common, ends.in1 - first.begin());
    }
    while (common > 0 && first[common - 1].isLetterOrNumber()) {
        --common;
    }
    const bool leavesAll = std::ranges::all_of(
        pieces, [common](const NamedPiece& piece) -> bool { return piece.name.size() > common; });
    return leavesAll ? static_cast<int>(common) : 0;
}

class Layout {
public:
    Layout(const QFont& font, const std::vector<NamedPiece>& pieces, std::vector<QRectF> taken)
        : font_(font),
          pieces_(pieces),
          taken_(std::move(taken)),
          common_(commonBeginning(pieces)) {}

    std::optional<NamePlate> place(int index) {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        if (std::max(piece.box.width(), piece.box.height()) < kLeastBox) {
            return std::nullopt;
        }
        QStringList texts{piece.name + piece.note, piece.name, piece.name.mid(common_)};
        if (const QString shortened = shortenedName(index); !shortened.isEmpty()) {
            texts << shortened;
        }
        texts.removeDuplicates();
        for (const QString& text : std::as_const(texts)) {
            if (const auto plate = plateFor(index, text)) {
                taken_.push_back(plate->adjusted(-kAir, -kAir, kAir, kAir));
                return NamePlate{index, *plate, text};
            }
        }
        return std::nullopt;
    }

private:
    /// Empty where nothing is left that tells it from the others.
    QString shortenedName(int index) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        const QFontMetricsF metrics(plateFont(font_, piece.selected));
        const double padding = plateSize(font_, QString(), piece.selected).width();
        const QString text =
            metrics.elidedText(piece.name, Qt::ElideMiddle, kRoom * piece.box.width() - padding);
        const qsizetype gap = text.indexOf(QChar(0x2026));
        if (gap < 0 || text.size() - 1 < kLeastLetters) {
            return {};
        }
        const QString head = text.left(gap), tail = text.mid(gap + 1);
        const auto same = std::ranges::count_if(pieces_, [&](const NamedPiece& other) -> bool {
            return other.name.startsWith(head) && other.name.endsWith(tail);
        });
        return same == 1 ? text : QString();
    }

    bool isFree(int index, const QRectF& plate) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (static_cast<int>(i) != index && plate.intersects(pieces_[i].box)) {
                return false;
            }
        }
        return true;
    }

    std::optional<QRectF> plateFor(int index, const QString& text) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        const QSizeF size = plateSize(font_, text, piece.selected);
        for (const int step : {0, 1, -1, 2, -2}) {
            QRectF plate(QPointF(), size);
            plate.moveCenter(piece.at + QPointF(0, step * (size.height() + kAir)));
            const bool onPiece = step == 0 || (plate.top() >= piece.box.top() &&
                                               plate.bottom() <= piece.box.bottom());
            const bool fits = size.width() <= kRoom * piece.box.width() || isFree(index, plate);
            if (onPiece && fits && !meetsAny(plate, taken_)) {
                return plate;
            }
        }
        return std::nullopt;
    }

    const QFont& font_;
    const std::vector<NamedPiece>& pieces_;
    std::vector<QRectF> taken_;
    int common_;
};

}  // namespace

std::vector<NamePlate> namePlates(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  std::vector<QRectF> taken) {
    std::vector<int> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&pieces](int a, int b) -> bool {
        const NamedPiece& one = pieces[static_cast<std::size_t>(a)];
        const NamedPiece& other = pieces[static_cast<std::size_t>(b)];
        if (one.selected != other.selected) {
            return one.selected;
        }
        return one.box.width() * one.box.height() > other.box.width() * other.box.height();
    });
    Layout layout(font, pieces, std::move(taken));
    std::vector<NamePlate> plates;
    for (const int index : order) {
        if (const auto plate = layout.place(index)) {
            plates.push_back(*plate);
        }
    }
    return plates;
}

}  // namespace toile::app

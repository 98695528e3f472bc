// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/export/pdf_letters.h"
#include "core/export/sheet_canvas.h"

namespace toile {

inline constexpr int kPdfLayerCount = kPageLayer + 1;

/// The name in a reader's list, "seam line".
const char* pdfLayerName(int layer);
/// The name in content streams.
std::string pdfLayerKey(int layer);

/// The operators of a content stream, in the unit of its matrix.
class PdfContent : public SheetCanvas {
public:
    /// @param letters  of the same file; must outlive this object
    explicit PdfContent(PdfLetters& letters) : letters_(&letters) {}

    void save() override { out_ += "q\n"; }
    void restore() override { out_ += "Q\n"; }
    void transform(double a, double b, double c, double d, const Eigen::Vector2d& move) override;
    void clip(const Eigen::AlignedBox2d& box) override;
    /// The form "P" of the resources.
    void drawing() override { form("P"); }

    void beginLayer(int layer) override;
    void beginItem(std::string_view id, std::string_view piece = {}) override;
    void end() override { out_ += "EMC\n"; }

    void setGrey(double grey) override;
    void setWidth(double width) override;
    void setDashes(double line, double gap) override;
    void setRoundEnds() override;

    void line(const Points2& points, bool closed) override;
    void curves(const std::vector<CubicCurve>& curves, bool closed) override;
    void box(const Eigen::AlignedBox2d& box) override;
    void segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) override;
    double text(std::string_view text, const Eigen::Vector2d& position, double height,
                TextStart start, double angle = 0, double most = 0) override;

    std::string take() { return std::move(out_); }

private:
    void form(std::string_view name);
    void number(double value);
    void point(const Eigen::Vector2d& point);

    PdfLetters* letters_;
    std::string out_;
};

}  // namespace toile

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/export/drawing.h"
#include "core/export/pdf_letters.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/cubic_curve.h"

namespace toile {

/// The layers of a PDF file, by their index: those of the drawing's kinds, then two of the pages.
inline constexpr int kGridLayer = static_cast<int>(kLayerKinds.size());
inline constexpr int kPageLayer = kGridLayer + 1;
inline constexpr int kPdfLayerCount = kPageLayer + 1;

/// As readers list it, "seam line".
const char* pdfLayerName(int layer);
/// By which content streams refer to it.
std::string pdfLayerKey(int layer);

/// From where a line of text goes on.
enum class TextStart { Left, Middle };

/// The operators of a content stream, in whatever unit its matrix gives, y up. Each `begin` has its
/// `end`; state that is set between `save` and `restore` ends with it.
class PdfContent {
public:
    /// @param letters  of the same file; they outlive it
    explicit PdfContent(PdfLetters& letters) : letters_(&letters) {}

    void save() { out_ += "q\n"; }
    void restore() { out_ += "Q\n"; }
    void transform(double a, double b, double c, double d, const Eigen::Vector2d& move);
    void clip(const Eigen::AlignedBox2d& box);
    void form(std::string_view name);

    void beginLayer(int layer);
    /// What is drawn until its end is known by this in other programs, and in reading back.
    /// @param piece  empty: of none
    void beginItem(std::string_view id, std::string_view piece = {});
    void end() { out_ += "EMC\n"; }

    /// 0 is black, 1 white.
    void setGrey(double grey);
    void setWidth(double width);
    void setDashes(double line, double gap);
    void setRoundEnds();

    void line(const Points2& points, bool closed);
    /// Closed where the last ends where the first starts. @param curves  at least one, joined
    void curves(const std::vector<CubicCurve>& curves, bool closed);
    void box(const Eigen::AlignedBox2d& box);
    void segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

    /// A line of text, in any script. @param position  on the baseline  @param height  of a capital
    /// @param angle  radians  @param most  it is made smaller where it would be longer; 0: it is
    /// not
    /// @return its width
    double text(std::string_view text, const Eigen::Vector2d& position, double height,
                TextStart start, double angle = 0, double most = 0);

    std::string take() { return std::move(out_); }

private:
    void number(double value);
    void point(const Eigen::Vector2d& point);

    PdfLetters* letters_;
    std::string out_;
};

}  // namespace toile

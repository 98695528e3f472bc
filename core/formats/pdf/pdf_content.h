// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/drawing/sheet_drawing.h"

namespace toile {

/// The objects of a PDF file (ISO 32000-1, version 1.7), numbered from 1: dictionaries as written,
/// and streams compressed by Flate. No dates, and an identifier derived from the content: the same
/// objects give the same bytes.
class PdfFile {
public:
    /// Reserves a number for an object that is set later.
    int reserve();
    /// @param body  without "obj" and "endobj"
    void set(int number, std::string body);
    /// @param entries  of its dictionary, except /Length and /Filter
    void setStream(int number, std::string_view entries, std::string_view bytes);

    int add(std::string body);
    int addStream(std::string_view entries, std::string_view bytes);

    /// The whole file. Precondition: every reserved number is set. Cost: linear.
    std::string finished(int catalog, int info) const;

private:
    std::vector<std::string> bodies_;
};

/// "12 0 R".
std::string pdfReference(int number);
/// A name, a text for people or a key as a string: in parentheses if it is printable ASCII, else as
/// UTF-16. @param text  UTF-8; control characters become blanks
std::string pdfText(std::string_view text);
/// A length of pages in points, from mm.
std::string pdfPoints(double millimetres);
/// With limited decimals, no zeros at the end and never an exponent.
std::string pdfNumber(double value);
void appendPdfNumber(std::string& out, double value, int decimals = 4);

class PdfFile;

/// Lines of text as forms, each stored once per file: filled outlines of its letters, and the same
/// text invisibly, for searching. From (0, 0) on the baseline to the right.
class PdfLetters {
public:
    /// Height of a capital, in the unit of the forms; outlines are in whole units.
    static constexpr double kHeight = 1000;

    struct Line {
        std::string key;   ///< in resources; empty: nothing visible
        double width = 0;  ///< in the unit of the forms
        std::string content{};
    };

    /// Cost: that of `textOutlines` for a new line.
    const Line& line(std::string_view text);

    /// Writes the forms. @param font  the resource entry for searchable text
    /// @return their entries of a dictionary "/XObject"
    std::string addTo(PdfFile& file, const std::string& font) const;

private:
    std::map<std::string, Line, std::less<>> lines_;
    int count_ = 0;
};

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/dxf_reader.h"

#include <charconv>

namespace toile::test {
namespace {

double toNumber(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

Points2 DxfPolyline::matrix() const {
    Points2 result(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.row(static_cast<Eigen::Index>(i)) = points[i];
    }
    return result;
}

DxfFile::DxfFile(const std::string& bytes) {
    readTags(bytes);
    for (std::size_t i = 0; i < tags_.size(); ++i) {
        if (tags_[i].code == 0 && tags_[i].value == "SECTION" && i + 1 < tags_.size()) {
            section_ = tags_[++i].value;
            continue;
        }
        readTag(tags_[i]);
    }
    if (tags_.empty() || tags_.back().code != 0 || tags_.back().value != "EOF") {
        faults.emplace_back("no EOF at the end");
    }
}

void DxfFile::readTags(const std::string& bytes) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = bytes.find("\r\n", at);
        if (end == std::string::npos) {
            faults.emplace_back("a line without CRLF");
            break;
        }
        lines.push_back(bytes.substr(at, end - at));
        at = end + 2;
        for (const char c : lines.back()) {
            if (c < 0x20 || c > 0x7E) {
                faults.push_back("not printable ASCII: " + lines.back());
            }
        }
    }
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        tags_.push_back({std::stoi(lines[i]), lines[i + 1]});
    }
}

void DxfFile::readTag(const DxfTag& tag) {
    if (tag.code == 0) {
        entity_ = tag.value;
        if (entity_ == "POLYLINE") {
            polylines.emplace_back();
        } else if (entity_ == "VERTEX") {
            polylines.back().points.emplace_back(0, 0);
        } else if (entity_ == "TEXT") {
            texts.emplace_back();
        } else if (entity_ == "BLOCK") {
            ++blocks;
        }
    } else if (section_ == "HEADER") {
        if (tag.code == 9) {
            variable_ = tag.value;
        } else {
            header[variable_].push_back(tag);
        }
    } else if (entity_ == "LAYER" && tag.code == 2) {
        layerName_ = tag.value;
    } else if (entity_ == "LAYER" && tag.code == 62) {
        layers[layerName_] = std::stoi(tag.value);
    } else if (entity_ == "POLYLINE" && tag.code == 8) {
        polylines.back().layer = tag.value;
    } else if (entity_ == "POLYLINE" && tag.code == 70) {
        polylines.back().closed = (std::stoi(tag.value) & 1) != 0;
    } else if (entity_ == "VERTEX" && (tag.code == 10 || tag.code == 20)) {
        polylines.back().points.back()[tag.code / 10 - 1] = toNumber(tag.value);
    } else if (entity_ == "TEXT" && (tag.code == 11 || tag.code == 21)) {
        texts.back().middle[tag.code / 10 - 1] = toNumber(tag.value);
    } else if (entity_ == "TEXT" && tag.code == 40) {
        texts.back().height = toNumber(tag.value);
    } else if (entity_ == "TEXT" && tag.code == 1) {
        texts.back().value = tag.value;
    } else if (entity_ == "TEXT" && tag.code == 8) {
        texts.back().layer = tag.value;
    }
}

}  // namespace toile::test

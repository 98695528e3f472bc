// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/landmark_distances.h"

#include <algorithm>
#include <limits>

namespace toile {
namespace {

constexpr int kNotReached = -1;
constexpr int kFarthest = std::numeric_limits<std::uint16_t>::max();

}  // namespace

LandmarkSurvey::LandmarkSurvey(const CouplingGraph& graph)
    : graph_(graph),
      depth_(static_cast<std::size_t>(graph.size())),
      nearest_(static_cast<std::size_t>(graph.size())) {
    queue_.reserve(depth_.size());
}

void LandmarkSurvey::measure(const std::vector<int>& vertices, const std::vector<char>& closed,
                             std::vector<LandmarkDistances>& distances) {
    // The end of a walk from anywhere is on the rim: a better first landmark.
    walkFrom({}, vertices, closed);
    for (const int v : vertices) {
        nearest_[v] = depth_[v];
    }
    std::vector<int> landmarks = farthestOfParts();
    for (const int v : vertices) {
        nearest_[v] = std::numeric_limits<int>::max();
    }
    for (int k = 0; k < kLandmarks; ++k) {
        walkFrom(landmarks, vertices, closed);
        for (const int v : vertices) {
            nearest_[v] = std::min(nearest_[v], depth_[v]);
            distances[v][k] = static_cast<std::uint16_t>(std::min(depth_[v], kFarthest));
        }
        landmarks = farthestOfParts();
    }
}

/// Walks through the vertices breadth first: from the landmarks, and through parts that none of
/// them is in from their first vertex.
void LandmarkSurvey::walkFrom(const std::vector<int>& landmarks, const std::vector<int>& vertices,
                              const std::vector<char>& closed) {
    for (const int v : vertices) {
        depth_[v] = kNotReached;
    }
    queue_.clear();
    parts_.clear();
    for (const int v : landmarks) {
        walkPart(v, closed);
    }
    for (std::size_t k = 0; k < vertices.size() && queue_.size() < vertices.size(); ++k) {
        walkPart(vertices[k], closed);
    }
}

void LandmarkSurvey::walkPart(int first, const std::vector<char>& closed) {
    if (depth_[first] != kNotReached) {
        return;
    }
    parts_.push_back(queue_.size());
    depth_[first] = 0;
    std::size_t head = queue_.size();
    queue_.push_back(first);
    for (; head < queue_.size(); ++head) {
        const int v = queue_[head];
        const int next = depth_[v] + 1;
        for (int e = graph_.start[v]; e < graph_.start[v + 1]; ++e) {
            const int w = graph_.neighbour[e];
            if (closed[w] == 0 && depth_[w] == kNotReached) {
                depth_[w] = next;
                queue_.push_back(w);
            }
        }
    }
}

std::size_t LandmarkSurvey::endOf(std::size_t part) const {
    return part + 1 < parts_.size() ? parts_[part + 1] : queue_.size();
}

/// Of each part the vertex farthest from the landmarks so far.
std::vector<int> LandmarkSurvey::farthestOfParts() const {
    std::vector<int> farthest;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        int best = queue_[parts_[part]];
        for (std::size_t i = parts_[part]; i < endOf(part); ++i) {
            best = nearest_[queue_[i]] > nearest_[best] ? queue_[i] : best;
        }
        farthest.push_back(best);
    }
    return farthest;
}

}  // namespace toile

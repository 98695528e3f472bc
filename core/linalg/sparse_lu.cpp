// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_lu.h"

#include <umfpack.h>

namespace toile {

/// The matrix, column by column (UMFPACK looks at it again when it solves), and its factors.
struct SparseLu::State {
    int size = 0;
    std::vector<int> columnStart;
    std::vector<int> row;
    std::vector<double> value;
    void* numeric = nullptr;

    State() = default;
    ~State() { umfpack_di_free_numeric(&numeric); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

SparseLu::SparseLu() : state_(std::make_unique<State>()) {}

SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu& SparseLu::operator=(SparseLu&&) noexcept = default;

namespace {

Error failureOf(int status) {
    if (status == UMFPACK_ERROR_out_of_memory) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return Error{ErrorCode::FactorisationFailed, {}, "the matrix is singular"};
}

}  // namespace

Result<void> SparseLu::factorise(int size, const std::vector<MatrixEntry>& entries) {
    State& s = *state_;
    umfpack_di_free_numeric(&s.numeric);
    const std::size_t count = entries.size();
    std::vector<int> rows(count);
    std::vector<int> columns(count);
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k) {
        rows[k] = entries[k].row;
        columns[k] = entries[k].column;
        values[k] = entries[k].value;
    }
    s.size = size;
    s.columnStart.resize(static_cast<std::size_t>(size) + 1);
    s.row.resize(count);
    s.value.resize(count);
    int status = umfpack_di_triplet_to_col(size, size, static_cast<int>(count), rows.data(),
                                           columns.data(), values.data(), s.columnStart.data(),
                                           s.row.data(), s.value.data(), nullptr);
    if (status != UMFPACK_OK) {
        return failureOf(status);
    }
    double control[UMFPACK_CONTROL];
    umfpack_di_defaults(control);
    // Left to itself it may take a lopsided pattern of nearly symmetric values for an unsymmetric
    // one, and order by columns only.
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    void* symbolic = nullptr;
    status = umfpack_di_symbolic(size, size, s.columnStart.data(), s.row.data(), s.value.data(),
                                 &symbolic, control, nullptr);
    if (status == UMFPACK_OK) {
        status = umfpack_di_numeric(s.columnStart.data(), s.row.data(), s.value.data(), symbolic,
                                    &s.numeric, control, nullptr);
    }
    umfpack_di_free_symbolic(&symbolic);
    if (status != UMFPACK_OK) {
        return failureOf(status);
    }
    return {};
}

Result<Eigen::MatrixXd> SparseLu::solve(const Eigen::MatrixXd& B) const {
    Eigen::MatrixXd X(B.rows(), B.cols());
    for (Eigen::Index k = 0; k < B.cols(); ++k) {
        const int status = umfpack_di_solve(
            UMFPACK_A, state_->columnStart.data(), state_->row.data(), state_->value.data(),
            X.col(k).data(), B.col(k).data(), state_->numeric, nullptr, nullptr);
        if (status != UMFPACK_OK) {
            return failureOf(status);
        }
    }
    return X;
}

}  // namespace toile

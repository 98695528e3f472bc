// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::linalg {

/// During its lifetime, as many threads at a time may call the BLAS as there is memory for.
/// OpenBLAS allocates a working buffer per calling thread, keeps it for later, and retries forever
/// if the process may have no more memory (`ulimit -v`, RLIMIT_DATA). So the buffers are allocated
/// here, before the first call, and before threads are started whose stacks would take their space.
/// Thread-safe.
class BlasCall {
public:
    /// @param threads  number of threads that want to call; at least 1
    explicit BlasCall(int threads = 1);
    ~BlasCall();
    BlasCall(const BlasCall&) = delete;
    BlasCall& operator=(const BlasCall&) = delete;

    /// How many of them may call, from 0.
    int room() const { return room_; }

private:
    int room_ = 0;
};

/// Makes OpenBLAS work on the calling thread alone from now on, in this process and its later
/// forks: pieces are solved in parallel already, and the same input gives the same bits. A process
/// that was forked before restarts OpenBLAS's threads. Thread-safe.
void useOneBlasThread();

}  // namespace toile::linalg

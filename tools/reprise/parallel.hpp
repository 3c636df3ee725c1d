// SPDX-License-Identifier: Apache-2.0
// A loop over independent pieces of work on all cores. The first exception is thrown again by the caller's
// thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace report {

template <class Work> void parallelFor(size_t count, const Work& work) {
    std::atomic<size_t> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto loop = [&] {
        for (size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                next = count;
            }
        }
    };
    const size_t threads = std::min<size_t>(std::max(1u, std::thread::hardware_concurrency()), count);
    std::vector<std::jthread> others;
    for (size_t t = 1; t < threads; ++t)
        others.emplace_back(loop);
    loop();
    others.clear(); // joins
    if (failure) std::rethrow_exception(failure);
}

} // namespace report

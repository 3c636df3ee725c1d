// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace report {
namespace {

std::string clockTime(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

} // namespace

std::string progressLine(double fraction, double elapsedSeconds, std::string_view what, bool bar) {
    const double f = std::clamp(fraction, 0.0, 1.0);
    std::string line;
    if (bar) {
        const auto full = static_cast<size_t>(f * 24.0 + 0.5);
        line = fmt::format("[{}{}] ", std::string(full, '#'), std::string(24 - full, '.'));
    }
    line += fmt::format("{:3.0f} %", 100.0 * f);
    // Before a hundredth is done an estimate is a guess.
    if (f >= 1.0)
        line += fmt::format("  {} in all", clockTime(elapsedSeconds));
    else if (f >= 0.01)
        line += fmt::format("  {} left", clockTime(elapsedSeconds * (1.0 - f) / f));
    return what.empty() ? line : fmt::format("{}  {}", line, what);
}

Progress::Progress(double total)
    : total_(std::max(total, 1e-9)), terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()), lastPrint_(start_) {}

Progress::~Progress() {
    if (!finished_ && terminal_ && lastLength_ > 0) std::fputc('\n', stderr);
}

void Progress::step(double work, std::string_view what) {
    done_ = std::min(done_ + work, total_);
    const auto now = std::chrono::steady_clock::now();
    if (terminal_) {
        if (now - lastPrint_ < std::chrono::milliseconds(100)) return;
        lastPrint_ = now;
        print(what);
        return;
    }
    const int tenth = static_cast<int>(10.0 * done_ / total_);
    if (tenth == lastTenth_) return;
    lastTenth_ = tenth;
    print(what);
}

void Progress::finish() {
    if (finished_) return;
    done_ = total_;
    if (terminal_ || lastTenth_ < 10) print("");
    if (terminal_) std::fputc('\n', stderr);
    finished_ = true;
}

void Progress::print(std::string_view what) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::string line = progressLine(done_ / total_, elapsed, what, terminal_);
    if (!terminal_) {
        fmt::print(stderr, "{}\n", line);
        return;
    }
    const size_t length = line.size();
    line.resize(std::max(length, lastLength_), ' ');
    lastLength_ = length;
    fmt::print(stderr, "\r{}", line);
    std::fflush(stderr);
}

} // namespace report

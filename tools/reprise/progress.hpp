// SPDX-License-Identifier: Apache-2.0
// Progress on stderr: a bar with the time left on a terminal, plain lines elsewhere.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace report {

// One line, without the carriage return: "[#####.....]  50 %  0:12 left  thin_geometry".
std::string progressLine(double fraction, double elapsedSeconds, std::string_view what, bool bar);

class Progress {
public:
    // total: the work in any unit.
    explicit Progress(double total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step(double work, std::string_view what);
    void finish();

private:
    void print(std::string_view what);

    double total_, done_ = 0.0;
    bool terminal_, finished_ = false;
    int lastTenth_ = -1;
    size_t lastLength_ = 0;
    std::chrono::steady_clock::time_point start_, lastPrint_;
};

} // namespace report

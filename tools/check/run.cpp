// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include <chrono>
#include <stdexcept>

namespace check {

Outcome run(const functions::Bench& bench, const Case& checked, const Effort& effort,
            const functions::Mutation& mutation) {
    const auto start = std::chrono::steady_clock::now();
    const Sweep sweep = checked.make(effort);
    if (sweep.inputs.empty()) throw std::runtime_error(checked.function() + " has a sweep without inputs");
    Outcome outcome;
    outcome.checked = &checked;
    outcome.pack =
        tally(sweep.inputs, functions::run(bench, checked.call, sweep.inputs, {.mutation = mutation}),
              sweep.oracle, checked.bound);
    if (checked.printed) {
        functions::Function call = checked.call;
        call.name += " as printed";
        call.body = checked.printed->body;
        call.helpers += checked.printed->helpers;
        outcome.printed =
            tally(sweep.inputs, functions::run(bench, call, sweep.inputs), sweep.oracle, checked.bound);
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace check

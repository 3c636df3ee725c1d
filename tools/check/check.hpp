// SPDX-License-Identifier: Apache-2.0
// Numerical stability of every function of hlsl/reprise: a table of cases, each one function over one sweep
// of stiff and extreme inputs, run on a device against the oracle in double precision. M2.
#pragma once

#include "hlsl_functions.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace check {

using functions::dvec2;
using functions::dvec3;
using functions::dvec4;
using functions::Row;
using functions::vec4;

// In what a bound is stated.
enum class Unit {
    exact,     // no error at all
    absolute,  // in the unit of the result
    relative,  // of the exact result
    ulp,       // steps of binary32 at the exact result
    roundings, // of half a step (2^-24) at the size of what the function rounds, which the oracle gives
    finite,    // nothing but that the result is no NaN and no infinity
};

struct Bound {
    Unit unit = Unit::exact;
    double value = 0.0;
    const char* reason = "";
};

// What is right for one output of a row: its first `components` values. `size` is for bounds in roundings;
// where it is infinite the inputs leave the value open, and any finite one is right.
struct Right {
    dvec4 value{0.0}, size{0.0};
    int components = 4;
};
Right right(double value, double size = 0.0);
Right right(dvec2 value, double size = 0.0);
Right right(dvec3 value, double size = 0.0);
Right right(dvec3 value, dvec3 size);
Right right(dvec4 value, double size = 0.0);
Right open(int components);

using Oracle = std::function<std::vector<Right>(const Row&)>;

struct Sweep {
    std::vector<Row> inputs;
    Oracle oracle;
};

struct Effort {
    bool quick = false;
    size_t of(size_t full) const { return quick ? (full + 9) / 10 : full; }
};

// The listing as the document prints it, made to compile and nothing else, over the same inputs.
struct Printed {
    std::string where, body, helpers;
};

struct Case {
    std::string sweep;        // what the inputs are
    functions::Function call; // its name is the function's, its first header the function's
    Bound bound;
    std::function<Sweep(const Effort&)> make;
    std::optional<Printed> printed = {};

    const std::string& function() const { return call.name; }
    const std::string& header() const { return call.headers.front(); }
};

// Every case, by header.
std::vector<Case> table();

struct PublicFunction {
    std::string header, name;
    bool operator==(const PublicFunction&) const = default;
};
// What the headers of hlsl/reprise define at file scope, by their text; overloads once.
std::vector<PublicFunction> publicFunctions(const std::filesystem::path& hlsl);
// Those of the functions that no case runs.
std::vector<PublicFunction> withoutCase(const std::vector<PublicFunction>& functions,
                                        const std::vector<Case>& cases);

// Where an error was largest.
struct Worst {
    double value = 0.0, expected = 0.0;
    float actual = 0.0f;
    Row input; // empty: nowhere
};

struct Tally {
    size_t inputs = 0;
    size_t open = 0;               // rows of which the inputs leave some value open
    size_t nan = 0, infinity = 0;  // rows that give one
    Row firstNotFinite;            // of them
    Worst absolute, relative, ulp; // relative and ulp: of results that are no denormals
    Worst share;                   // of the bound: above 1 exceeds it
};

// Errors of up to four of the smallest normal number count as none: a device may take denormals for 0.
Tally tally(const std::vector<Row>& inputs, const std::vector<Row>& outputs, const Oracle& oracle,
            const Bound& bound);
// |actual - expected| in steps of binary32 at `expected`; the step of denormals is that of the smallest
// normal number.
double ulpDistance(float actual, double expected);

struct Outcome {
    const Case* checked = nullptr;
    Tally pack;
    std::optional<Tally> printed;
    double seconds = 0.0;
};

Outcome run(const functions::Bench& bench, const Case& checked, const Effort& effort,
            const functions::Mutation& mutation = {});

// Empty, or what is wrong: NaN, infinity, the bound.
std::string failure(const Outcome& outcome);

std::string boundText(const Bound& bound);
// Lines of the terminal: one for the pack's form, one for the printed one.
std::string tableHead();
std::vector<std::string> tableLines(const Outcome& outcome);

struct DeviceInfo {
    std::string name, driver, type;
};
// check.json: one row a line, the pack's form and the printed one each its own.
std::string jsonText(const DeviceInfo& device, const std::vector<Outcome>& outcomes, bool quick);

} // namespace check

// SPDX-License-Identifier: Apache-2.0
// The outcome of a call that can fail: a value, or a code and one sentence that says what and what to do.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace reprise {

enum class ErrorCode {
    invalidArgument,
    missingInput,
    missingFeature,
    missingVariant,
    unsupportedFormat,
    zeroExtent,
    outOfMemory,
    badShader,
    fileError,
    deviceLost,
};

struct Error {
    ErrorCode code;
    std::string message;
};

template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}
    Result(Error error) : state_(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(state_); }
    T& operator*() { return std::get<T>(state_); }
    const T& operator*() const { return std::get<T>(state_); }
    T* operator->() { return &std::get<T>(state_); }
    const T* operator->() const { return &std::get<T>(state_); }
    const Error& error() const { return std::get<Error>(state_); }

private:
    std::variant<T, Error> state_;
};

// A call that only succeeds or fails. `return {};` is success.
template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), failed_(true) {}

    explicit operator bool() const { return !failed_; }
    const Error& error() const { return error_; }

private:
    Error error_{};
    bool failed_ = false;
};

} // namespace reprise

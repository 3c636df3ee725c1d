// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reprise/result.hpp"

#include <exception>
#include <new>

namespace reprise {

// Runs the body of a public call: an exception of the standard library or of a callback becomes an Error.
template <class Body> auto guarded(Body&& body) noexcept -> decltype(body()) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "Out of memory."};
    } catch (const std::exception& exception) {
        return Error{ErrorCode::invalidArgument, exception.what()};
    }
}

} // namespace reprise

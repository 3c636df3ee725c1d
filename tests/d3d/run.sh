#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every pass on a Direct3D 9 and a Direct3D 11 device, with Microsoft's compiler, against the oracle. Called by
# ./run d3d, which installs packages and builds d3d_cases. Everything lies in build/d3d, also what wine writes.
set -euo pipefail
cd "$(dirname "$0")/../.."

work=$PWD/build/d3d
jobs=build/d3d/jobs
# The compiler comes in an npm package, for nobody may pass it on by itself.
package=webgpu@0.6.2
archive=$work/webgpu-0.6.2.tgz
compiler=$work/windows/d3dcompiler_47.dll
compiler_sha256=289767b49dc8525bce262ea06fee4ef9fced2e131a55b25654ce871c1f0498b2

say() { echo "run d3d: $*" >&2; }
fail() {
    say "$*"
    exit 1
}

is_compiler() { echo "$compiler_sha256  $1" | sha256sum --check --status 2>/dev/null; }

fetch_compiler() {
    is_compiler "$compiler" && return
    say "fetching $package, which carries Microsoft's shader compiler"
    mkdir -p "$work/windows"
    npm pack "$package" --pack-destination "$work" --cache "$work/npm" --no-update-notifier --loglevel=error \
        >/dev/null || fail "npm could not fetch $package, which carries the shader compiler; check the network."
    tar -xzf "$archive" -C "$work" --strip-components=3 package/dist/win32-x64/d3dcompiler_47.dll ||
        fail "$package has no dist/win32-x64/d3dcompiler_47.dll; take another version and its checksum."
    rm -rf "$archive" "$work/npm"
    is_compiler "$work/d3dcompiler_47.dll" ||
        fail "the shader compiler in $package is not the one that was pinned (sha256 differs)."
    mv "$work/d3dcompiler_47.dll" "$compiler"
}

build_program() {
    cmake -S tests/d3d/windows -B "$work/windows" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_TOOLCHAIN_FILE="$PWD/tests/d3d/windows/mingw.cmake" >/dev/null
    cmake --build "$work/windows" >&2
}

# wined3d on OpenGL on Mesa's software renderer, on a display of its own. It calls its adapter by the name of a
# card that it resembles. Only Microsoft's compiler will do: wine's own turns some shaders into wrong code.
run_program() {
    export WINEPREFIX=$work/prefix WINEARCH=win64 WINEDEBUG=-all HOME=$work/home
    export WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=;d3dcompiler_47=n"
    export LIBGL_ALWAYS_SOFTWARE=1 MESA_SHADER_CACHE_DISABLE=true XDG_CACHE_HOME=$work/home/.cache
    unset DISPLAY WAYLAND_DISPLAY
    mkdir -p "$HOME"
    # -k and -w speak to the server of this prefix alone.
    trap 'wineserver -k 2>/dev/null || true' EXIT
    local code=0
    xvfb-run -a sh -c \
        'timeout 900 wine "$0" "$1"; code=$?; wineserver -k; wineserver -w; exit $code' \
        "$work/windows/d3d_run.exe" "$jobs" >"$work/wine.log" 2>&1 || code=$?
    [ "$code" -eq 0 ] && return
    tail -n 20 "$work/wine.log" >&2
    fail "the program under wine ended with $code; its output is in build/d3d/wine.log."
}

fetch_compiler
build_program
build/default/bin/d3d_cases prepare "$jobs" >&2
say "compiling and running under wine"
run_program
exec build/default/bin/d3d_cases judge "$jobs"

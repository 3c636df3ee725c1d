// SPDX-License-Identifier: Apache-2.0
// Explicit refresh of a cache: Drobot, "Reprojection Caching" (D4), and Scherzer, "Refreshing strategies"
// (S4). Every pixel has a group i in [0, n) and is computed anew when (t + i) mod n = 0, so within n frames,
// and once. The guarantee needs no more than a group that stays: a hash that took the frame too would give it
// away.
//
// Float arithmetic alone, as shader model 3 wants it, exact as long as frame + n <= 2^24. Wrap the frame on
// the CPU, at a multiple of every n in use so that no pixel notices: 720720 is one of all n up to 16. Where a
// pixel's n changes over time, it is refreshed within the least common multiple of its values: take powers of
// 2.
#ifndef REPRISE_REFRESH_HLSLI
#define REPRISE_REFRESH_HLSLI

// Largest period or side of a tile; larger ones count as this, and less than 1 counts as 1.
static const float MAX_REFRESH_PERIOD = 4096.0;

float wholePeriod(float n) {
    return floor(clamp(n, 1.0, MAX_REFRESH_PERIOD) + 0.5);
}

// a mod n in [0, n) for whole a in (-2^24, 2^24) and whole n >= 1. A quotient of a platform whose division is
// not exact may be one off, which the remainder shows. What is no number, or too large to have one, gives 0.
float wholeModulo(float a, float n) {
    float remainder = a - n * floor(a / n);
    remainder = remainder < 0.0 ? remainder + n : remainder;
    remainder = remainder >= n ? remainder - n : remainder;
    return remainder >= 0.0 && remainder < n ? remainder : 0.0;
}

// Whether the pixel of this group is computed anew in this frame. n: period in frames, may differ per pixel.
bool isRefreshed(float group, float frame, float n) {
    return wholeModulo(frame + group, wholePeriod(n)) < 0.5;
}

// "Updating one of n parts of the buffer every frame in sequence": n bands of rows, in turn from top to
// bottom. positionPx: a place in the pixel; height in pixels.
float groupOfBand(float2 positionPx, float height, float n) {
    float period = wholePeriod(n);
    float band = floor((floor(positionPx.y) * period + 0.5) / max(height, 1.0));
    return period - 1.0 - clamp(band, 0.0, period - 1.0);
}

// "Tiled refresh": the place in a tile of tileSize pixels, in rows, "0 1 / 2 3". n is tileSize.x *
// tileSize.y.
float groupOfTile(float2 positionPx, float2 tileSize) {
    float2 size = float2(wholePeriod(tileSize.x), wholePeriod(tileSize.y));
    float2 pixel = floor(positionPx);
    return wholeModulo(pixel.x, size.x) + size.x * wholeModulo(pixel.y, size.y);
}

// A permutation of [0, 289), by a polynomial, as its integers stay exact; up to 577 for a sum of two.
float scrambled(float value) {
    return wholeModulo((34.0 * value + 1.0) * value, 289.0);
}

float scrambled(float2 tile, float place) {
    float2 wrapped = float2(wholeModulo(tile.x, 289.0), wholeModulo(tile.y, 289.0));
    return scrambled(scrambled(scrambled(wrapped.x) + wrapped.y) + wholeModulo(place, 289.0));
}

// "Random block refresh", blocks of blockSize² pixels, at least 2x2 for the GPU's quads. Every tile of
// tileSize blocks holds each of its n = tileSize.x * tileSize.y groups once, as on the slide, so that every
// frame costs the same: its rows are turned each by another number of blocks, then its columns.
float groupOfBlock(float2 positionPx, float blockSize, float2 tileSize) {
    float2 size = float2(wholePeriod(tileSize.x), wholePeriod(tileSize.y));
    float2 block = floor((floor(positionPx) + 0.5) / max(wholePeriod(blockSize), 2.0));
    float2 tile = floor((block + 0.5) / size);
    float2 place = float2(wholeModulo(block.x, size.x), wholeModulo(block.y, size.y));
    float x = wholeModulo(place.x + scrambled(tile, place.y), size.x);
    float y = wholeModulo(place.y + scrambled(tile, size.y + x), size.y);
    return x + size.x * y;
}

#endif

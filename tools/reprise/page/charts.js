// SPDX-License-Identifier: Apache-2.0
// Two charts as SVG text: points against two axes, and lines over frames.
"use strict";

const palette = ["#0b62c4", "#c2410c", "#177a3c", "#8b3fc1", "#00808a", "#9a6a00", "#d1478f", "#b3261e",
  "#5b6470", "#4f7d00"];

function escapeHtml(text) {
  return String(text).replace(/[&<>"]/g, c => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}[c]));
}

// Round steps that cover [0 or low, high] in about `count` parts.
function ticks(low, high, count) {
  const span = Math.max(high - low, 1e-12);
  const power = Math.pow(10, Math.floor(Math.log10(span / count)));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => span / s <= count);
  const result = [];
  for (let t = Math.ceil(low / step - 1e-9) * step; t <= high + step * 1e-6; t += step) result.push(t);
  return result;
}

function number(value, digits = 3) {
  if (value === null || value === undefined) return "";
  if (Number.isInteger(value)) return String(value);
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  if (magnitude >= digits) return value.toFixed(0);
  return value.toFixed(Math.min(6, Math.max(0, digits - 1 - magnitude)));
}

function axis(value) { return String(Number(value.toPrecision(6))); }

// A frame with axes; returns the two scales and the SVG text so far.
function frameOf(width, height, x, y, xLabel, yLabel) {
  const left = 58, right = width - 14, top = 12, bottom = height - 36;
  const sx = v => left + (v - x[0]) / Math.max(x[1] - x[0], 1e-12) * (right - left);
  const sy = v => bottom - (v - y[0]) / Math.max(y[1] - y[0], 1e-12) * (bottom - top);
  let svg = "";
  for (const t of ticks(x[0], x[1], 7))
    svg += `<line class="axis" x1="${sx(t)}" x2="${sx(t)}" y1="${top}" y2="${bottom}"/>` +
      `<text x="${sx(t)}" y="${bottom + 15}" text-anchor="middle">${axis(t)}</text>`;
  for (const t of ticks(y[0], y[1], 6))
    svg += `<line class="axis" x1="${left}" x2="${right}" y1="${sy(t)}" y2="${sy(t)}"/>` +
      `<text x="${left - 7}" y="${sy(t) + 4}" text-anchor="end">${axis(t)}</text>`;
  svg += `<text x="${(left + right) / 2}" y="${height - 4}" text-anchor="middle">
    ${escapeHtml(xLabel)}</text>`;
  svg += `<text x="12" y="${(top + bottom) / 2}" text-anchor="middle"
    transform="rotate(-90 12 ${(top + bottom) / 2})">${escapeHtml(yLabel)}</text>`;
  return {sx, sy, svg, left, right, top, bottom};
}

function padded(values, fromZero) {
  const low = Math.min(...values), high = Math.max(...values);
  const margin = (high - low || Math.abs(high) || 1) * 0.07;
  return [fromZero ? 0 : Math.max(0, low - margin), high + margin];
}

// A label beside a point, unless it would cover one that is already there.
function placeLabel(placed, x, y, text, left, right) {
  const width = text.length * 6.3;
  for (const [dx, dy] of [[8, 4], [8, -8], [8, 16], [-8 - width, 4], [-8 - width, -8], [-8 - width, 16]]) {
    const box = [x + dx, y + dy - 10, x + dx + width, y + dy + 2];
    if (box[0] < left || box[2] > right + 10) continue;
    if (placed.some(p => box[0] < p[2] && box[2] > p[0] && box[1] < p[3] && box[3] > p[1])) continue;
    placed.push(box);
    return `<text class="label" x="${x + dx}" y="${y + dy}">${escapeHtml(text)}</text>`;
  }
  return "";
}

// points: {id, x, y, label, named, front, colour, title}; level: dashed line or null.
function scatterChart(points, level, xLabel, yLabel) {
  if (points.length === 0) return "<p class='note'>No row has both a time and this error.</p>";
  const width = 720, height = 430;
  const ys = points.map(p => p.y).concat(level === null ? [] : [level]);
  const f = frameOf(width, height, padded(points.map(p => p.x), false), padded(ys, false), xLabel, yLabel);
  let svg = f.svg;
  if (level !== null)
    svg += `<line class="none-line" x1="${f.left}" x2="${f.right}" y1="${f.sy(level)}" y2="${f.sy(level)}"/>`;
  const front = points.filter(p => p.front).sort((a, b) => a.x - b.x);
  const placed = points.map(p => [f.sx(p.x) - 5, f.sy(p.y) - 5, f.sx(p.x) + 5, f.sy(p.y) + 5]);
  if (front.length > 1)
    svg += `<polyline class="front-line" points="${
      front.map(p => `${f.sx(p.x)},${f.sy(p.y)}`).join(" ")}"/>`;
  const rank = p => 2 * Number(p.named) + Number(p.front);
  const ordered = points.slice().sort((a, b) => rank(b) - rank(a));
  for (const p of ordered.slice().reverse())
    svg += `<circle data-id="${p.id}" cx="${f.sx(p.x)}" cy="${f.sy(p.y)}" r="${p.named ? 6 : 4.5}"
      fill="${p.colour}" fill-opacity="${p.named || p.front ? 1 : 0.55}"><title>${escapeHtml(p.title)}</title></circle>`;
  for (const p of ordered) svg += placeLabel(placed, f.sx(p.x), f.sy(p.y), p.label, f.left, f.right);
  return `<svg viewBox="0 0 ${width} ${height}" role="img">${svg}</svg>`;
}

// lines: {label, values, colour, first: frame of the first value}; cut: frame of a camera cut or another event, or -1; event: its name.
function lineChart(lines, cut, yLabel, event = "camera cut") {
  const drawn = lines.filter(l => l.values.length > 0);
  if (drawn.length === 0) return "<p class='note'>No chosen row has this error per frame.</p>";
  const width = 720, height = 430, start = Math.min(...drawn.map(l => l.first));
  const frames = Math.max(...drawn.map(l => l.first + l.values.length));
  const range = padded(drawn.flatMap(l => l.values), true);
  const f = frameOf(width, height, [start, Math.max(frames - 1, start + 1)], range, "frame", yLabel);
  let svg = f.svg;
  if (cut >= start && cut < frames)
    svg += `<line class="none-line" x1="${f.sx(cut)}" x2="${f.sx(cut)}" y1="${f.top}" y2="${f.bottom}"/>
      <text x="${f.sx(cut) + 4}" y="${f.top + 10}">${escapeHtml(event)}</text>`;
  for (const l of drawn)
    svg += `<polyline fill="none" stroke="${l.colour}" stroke-width="1.8"
      points="${l.values.map((v, i) => `${f.sx(l.first + i)},${f.sy(v)}`).join(" ")}"><title>${escapeHtml(l.label)}</title>
      </polyline>`;
  const legend = drawn.map(l =>
    `<span><i class="swatch" style="background:${l.colour}"></i>${escapeHtml(l.label)}</span>`).join("");
  return `<svg viewBox="0 0 ${width} ${height}" role="img">${svg}</svg>
    <div class="legend">${legend}</div>`;
}

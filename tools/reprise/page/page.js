// SPDX-License-Identifier: Apache-2.0
// The page's state and its tables. A row is found by its index in the report.
"use strict";

const report = JSON.parse(document.getElementById("data").textContent);
const pictures = JSON.parse(document.getElementById("pictures").textContent);
const byId = id => document.getElementById(id);
const unique = values => [...new Set(values)];
const presetNames = (report.settings.presets || []).concat(report.settings.chief_lighting || []);
const picked = new Set();
let sortKey = "flip", sortUp = true;

report.rows.forEach((row, index) => { row.index = index; });

const measures = {flip: "FLIP", rmse: "RMSE", flicker: "flicker", max: "maximum"};
const columns = [
  ["variant", "variant", r => r.variant],
  ["ms", "time, ms", r => r.gpu_ms && r.gpu_ms.median],
  ["nine", "/ nine taps", r => r.per_nine_taps],
  ["copy", "/ copy", r => r.per_copy],
  ["efficiency", "efficiency", r => r.efficiency],
  ["flip", "FLIP", r => r.error.flip],
  ["rmse", "RMSE", r => r.error.rmse],
  ["max", "maximum", r => r.error.max],
  ["flicker", "flicker", r => r.error.flicker],
  ["reads", "reads / px", r => r.reads_per_pixel],
  ["memory", "memory, MiB", r => r.memory_bytes === null ? null : r.memory_bytes / 1048576],
  ["pareto", "front", r => r.pareto ? "front" : ""],
];

function fill(id, values, chosen) {
  byId(id).innerHTML = values.map(v =>
    `<option value="${escapeHtml(v)}">${escapeHtml(v || "-")}</option>`).join("");
  if (chosen !== undefined && values.includes(chosen)) byId(id).value = chosen;
}

function fillFilters() {
  const rows = report.rows.filter(r => r.technique === byId("technique").value);
  fill("scene", unique(rows.map(r => r.scene)), byId("scene").value);
  fill("stage", unique(rows.filter(r => r.stage).map(r => r.stage)), byId("stage").value);
  const known = Object.keys(measures).filter(m => rows.some(r => r.error[m] !== null));
  byId("measure").innerHTML = known.map(m => `<option value="${m}">${measures[m]}</option>`).join("");
  sortKey = known[0] || "ms";
  sortUp = true;
}

function visibleRows() {
  return report.rows.filter(r => r.technique === byId("technique").value && r.scene === byId("scene").value &&
    (r.stage === null || r.stage === byId("stage").value));
}

function colourOf(row, rows) { return palette[rows.indexOf(row) % palette.length]; }
function isNamed(row) { return row.variant === "none" || presetNames.includes(row.variant); }
function pickedRows() { return visibleRows().filter(r => picked.has(r.variant)); }
function shortName(row) { return row.variant.replace(/^inside \+ /, "+ "); }

function drawScatter() {
  const measure = byId("measure").value, rows = visibleRows(), none = rows.find(r => r.variant === "none");
  const points = rows.filter(r => r.gpu_ms && r.error[measure] !== null).map(r => ({
    id: r.index, x: r.gpu_ms.median, y: r.error[measure], label: shortName(r), named: isNamed(r),
    front: false, colour: picked.has(r.variant) ? colourOf(r, pickedRows()) : "#8a939e",
    title: `${r.variant}\n${number(r.gpu_ms.median)} ms, ${measures[measure]} ${number(r.error[measure])}`}));
  // The front of the chosen error; the report's own flag is that of FLIP.
  for (const p of points)
    p.front = !points.some(q => q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y));
  const level = none && none.error[measure] !== null ? none.error[measure] : null;
  byId("scatter").innerHTML = scatterChart(points, level, "GPU time, ms", measures[measure]);
  byId("scatter").querySelectorAll("circle").forEach(c =>
    c.addEventListener("click", () => toggle(report.rows[Number(c.dataset.id)])));
}

function drawCurves() {
  const measure = byId("measure").value === "flip" ? "flip" : "rmse", rows = pickedRows();
  const scene = (report.settings.scenes || []).find(s => s.name === byId("scene").value);
  // Where each frame's truth takes rays of its own, only the last ones are compared.
  const lines = rows.map(r => ({label: r.variant, values: r.per_frame[measure], colour: colourOf(r, rows),
    first: Math.max(0, (r.frames || 0) - r.per_frame[measure].length)}));
  byId("curves").innerHTML = lineChart(lines, scene ? Math.max(scene.cut_frame, scene.event_frame) : -1, measures[measure],
    scene && scene.event_frame >= 0 ? "occluder gone" : "camera cut");
}

function cell(row, key, value) {
  if (key === "variant") {
    const mark = picked.has(row.variant) ? colourOf(row, pickedRows()) : "transparent";
    const bad = row.not_finite ? ` <span class="bad">${row.not_finite} values not finite</span>` : "";
    return `<td><i class="swatch" style="background:${mark}"></i>${escapeHtml(value)}${bad}</td>`;
  }
  if (key === "ms" && row.gpu_ms)
    return `<td title="${number(row.gpu_ms.min)} to ${number(row.gpu_ms.max)}, ${row.gpu_ms.samples} runs">` +
      `${number(value, 4)}</td>`;
  if (key === "pareto") return `<td class="front">${value ? "●" : ""}</td>`;
  return `<td>${number(value)}</td>`;
}

function compareRows(a, b) {
  const get = columns.find(c => c[0] === sortKey)[2], x = get(a), y = get(b);
  if (x === y) return 0;
  if (x === null || x === undefined) return 1;
  if (y === null || y === undefined) return -1;
  return (x < y ? -1 : 1) * (sortUp ? 1 : -1);
}

function drawRows() {
  const rows = visibleRows().sort(compareRows);
  const isEmpty = value => value === null || value === undefined || value === "";
  const shown = columns.filter(([, , get]) => rows.some(r => !isEmpty(get(r))));
  const heads = shown.map(([key, title]) =>
    `<th data-key="${key}" class="${key === sortKey ? "sorted" : ""}">${title}` +
    `${key === sortKey ? (sortUp ? " ↑" : " ↓") : ""}</th>`).join("");
  byId("rows").innerHTML = `<thead><tr>${heads}</tr></thead><tbody>` + rows.map(r =>
    `<tr data-id="${r.index}" class="${picked.has(r.variant) ? "picked" : ""}">` +
    shown.map(([key, , get]) => cell(r, key, get(r))).join("") + "</tr>").join("") + "</tbody>";
  byId("rows").querySelectorAll("th").forEach(h => h.addEventListener("click", () => {
    sortUp = sortKey === h.dataset.key ? !sortUp : true;
    sortKey = h.dataset.key;
    drawRows();
  }));
  byId("rows").querySelectorAll("tbody tr").forEach(t =>
    t.addEventListener("click", () => toggle(report.rows[Number(t.dataset.id)])));
}

function toggle(row) {
  if (picked.has(row.variant)) picked.delete(row.variant); else picked.add(row.variant);
  draw();
}

// One line per preset, per scene FLIP or RMSE, flicker and time; the best of each scene is bold.
function drawSummary() {
  const stage = byId("stage").value;
  const rows = report.rows.filter(r => r.technique === byId("technique").value && isNamed(r) &&
    (r.stage === null || r.stage === stage));
  const names = unique(rows.map(r => r.variant)), scenes = unique(rows.map(r => r.scene));
  byId("summary-section").hidden = !rows.some(r => r.error.flip !== null || r.error.rmse !== null);
  const find = (name, scene) => rows.find(r => r.variant === name && r.scene === scene);
  const chief = rows.some(r => r.error.flip !== null) ? "flip" : "rmse";
  const least = (scene, key) => Math.min(...rows.filter(r => r.scene === scene && r.error[key] !== null)
    .map(r => r.error[key]));
  const value = (name, scene, key) => {
    const row = find(name, scene), v = row ? row.error[key] : null;
    const best = v !== null && v === least(scene, key);
    return `<td class="${best ? "best-value" : ""}">${number(v)}</td>`;
  };
  byId("summary").innerHTML = `<tr><th></th><th>time, ms</th>${scenes.map(s =>
    `<th colspan="2">${escapeHtml(s)}</th>`).join("")}</tr><tr><th></th><th></th>${scenes.map(() =>
    `<th>${measures[chief]}</th><th>flicker</th>`).join("")}</tr>` + names.map(n => {
    const timed = rows.find(r => r.variant === n && r.gpu_ms);
    return `<tr><td>${escapeHtml(n)}</td><td>${timed ? number(timed.gpu_ms.median, 4) : ""}</td>` +
      scenes.map(s => value(n, s, chief) + value(n, s, "flicker")).join("") + "</tr>";
  }).join("");
}

// "scene: hall_slow_pan; stages of the framework, ms: (depth_downsample: 2.02, ...)"
function measuredText(value, separator = "; ") {
  if (value === null) return "";
  if (typeof value === "number") return number(value);
  if (typeof value !== "object") return String(value);
  return Object.entries(value).map(([k, v]) => `${k}: ` +
    (v !== null && typeof v === "object" ? `(${measuredText(v, ", ")})` : measuredText(v))).join(separator);
}

function drawClaims() {
  const holds = c => c.holds === null ?
    `<td>${c.measured && c.measured["not applicable"] ? "not applicable" : "not measured"}</td>` : c.holds ? "<td class='good'>holds</td>" :
    "<td class='bad'>does not hold</td>";
  byId("claims").innerHTML = "<tr><th>id</th><th class='text'>claim</th><th class='text'>published</th>" +
    "<th class='text'>measured</th><th></th></tr>" + report.claims.map(c =>
    `<tr><td>${escapeHtml(c.id)}</td><td class="wrap">${escapeHtml(c.claim)}</td>` +
    `<td class="wrap">${escapeHtml(c.published || "")}</td><td class="wrap">${escapeHtml(measuredText(c.measured))}</td>` +
    `${holds(c)}</tr>`).join("");
}

function drawFloorsAndSettings() {
  const cells = f => [f.gpu_ms.median, f.gpu_ms.min, f.gpu_ms.max, f.ns_per_pixel].map(v =>
    `<td>${number(v, 4)}</td>`).join("");
  byId("floors").innerHTML = "<tr><th>floor</th><th>ms</th><th>min</th><th>max</th><th>ns / pixel</th></tr>" +
    report.floors.map(f => `<tr><td>${escapeHtml(f.name)}</td>${cells(f)}</tr>`).join("");
  const entries = Object.entries(report.settings).map(([k, v]) => [k.replace(/_/g, " "),
    Array.isArray(v) ? v.map(e => typeof e === "object" ? e.name : e).join(", ") : v]);
  byId("settings").innerHTML = entries.map(([k, v]) =>
    `<tr><td>${escapeHtml(k)}</td><td class="wrap">${escapeHtml(v)}</td></tr>`).join("");
}

function drawCompare() {
  const scene = pictures[byId("scene").value];
  byId("compare-section").hidden = !scene;
  if (!scene) return;
  // Pictures of a technique of lighting begin with its name.
  const technique = byId("technique").value + ", ", all = Object.keys(scene.images);
  const own = all.filter(n => n.startsWith(technique)), names = own.length > 0 ? own : all;
  const zoom = Number(byId("zoom").value), chosen = (id, first) => names.includes(byId(id).value) ? byId(id).value : first;
  fill("left", names, chosen("left", own.length > 0 ? technique + "truth" : "none"));
  fill("right", names, chosen("right", own.length > 0 ? technique + "framework" : "best"));
  byId("frame").textContent = `frame ${scene.frame}`;
  for (const side of ["left", "right"]) {
    const image = byId(`image-${side}`);
    image.onload = () => { image.style.width = `${image.naturalWidth * zoom}px`; };
    image.src = scene.images[byId(side).value];
  }
}

function moveHandle(share) {
  const part = Math.min(1, Math.max(0, share)) * 100;
  byId("handle").style.left = `${part}%`;
  byId("image-left").style.clipPath = `inset(0 ${100 - part}% 0 0)`;
}

function draw() {
  const scene = (report.settings.scenes || []).find(s => s.name === byId("scene").value);
  byId("shows").textContent = scene ? scene.shows : "";
  drawSummary();
  drawScatter();
  drawCurves();
  drawRows();
}

function start() {
  const d = report.device;
  byId("device").textContent = `${d.name} · ${d.driver} · ${d.type}`;
  fill("technique", unique(report.rows.map(r => r.technique)), "temporal_aa");
  fillFilters();
  for (const name of ["none"].concat(presetNames)) picked.add(name);
  byId("technique").addEventListener("change", () => { fillFilters(); draw(); drawCompare(); });
  byId("scene").addEventListener("change", () => { draw(); drawCompare(); });
  for (const id of ["stage", "measure"]) byId(id).addEventListener("change", draw);
  for (const id of ["left", "right", "zoom"]) byId(id).addEventListener("change", drawCompare);
  const box = byId("compare");
  const follow = e => { const r = box.getBoundingClientRect(); moveHandle((e.clientX - r.left) / r.width); };
  box.addEventListener("pointermove", follow);
  box.addEventListener("pointerdown", follow);
  draw();
  drawCompare();
  moveHandle(0.5);
  drawClaims();
  drawFloorsAndSettings();
}

start();

// Figures of the data block drawn by plotly; where none is wanted, the SVG in the page stays.

import Plotly from "plotly.js-cartesian-dist-min";

// when the colours come again, points have other marks (and lines other dashes, which the numbers bring)
const MARK = ["circle", "square", "diamond", "triangle-up"];

/** A text that plotly shows as it is: it reads some HTML in names and titles. */
function plain(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

const FONT = "Helvetica, Arial, sans-serif";
const MARGIN = {l: 64, r: 18, t: 12, b: 58}; // below: marks, labels, a gap and the title
const TOOLS = 30; // pixels that the tools are high
const pen = document.createElement("canvas").getContext("2d");

/** A name of the legend; of one that is wider than the figure the beginning and the end, as in the SVG. */
function legendOf(curve, width) {
  const letters = [...curve.name];
  const room = width - 56; // right of the line before it
  pen.font = `${sizeOf(width)}px ${FONT}`;
  let shown = curve.name;
  for (let most = letters.length; most > 8 && pen.measureText(shown).width > room; most--) {
    const head = Math.floor(most / 3);
    shown = [...letters.slice(0, head), "...", ...letters.slice(3 + head - most)].join("");
  }
  return shown;
}

/** Pixels of the letters of a figure. */
function sizeOf(width) {
  return width < 480 ? 12 : 13;
}

function traceOf(figure, curve, width) {
  const times = (list, factor) => list.map(value => value === null ? null : value * factor);
  const dots = curve.style === "dots";
  const marks = dots || ["points", "hollow", "read", "vague"].includes(curve.style);
  const hollow = ["hollow", "vague"].includes(curve.style);
  const edge = curve.style === "read" ? "#000000" : curve.colour; // it lies on a curve of its colour
  const trace = {
    x: times(curve.x, figure.x.factor),
    y: times(curve.y, figure.y.factor),
    name: plain(legendOf(curve, width)),
    hoverlabel: {namelength: -1}, // whole: plotly would cut an entity in two
    showlegend: curve.name !== "",
    mode: marks ? "markers" : "lines",
    hoverinfo: curve.name === "" ? "x+y" : "x+y+name",
    connectgaps: false,
  };
  if (legendOf(curve, width) !== curve.name) {
    trace.hovertemplate = `(%{x}, %{y})<extra>${plain(curve.name)}</extra>`;
  }
  if (dots) {
    trace.marker = {color: curve.colour, size: 4, opacity: 0.7};
  } else if (marks) {
    trace.marker = {symbol: MARK[curve.round], color: hollow ? "#ffffff" : curve.colour, size: figure.equal && width < 480 ? 6 : 9, line: {color: edge, width: 2}};
  } else {
    trace.line = {color: curve.colour, width: curve.style === "thin" ? 1 : 2, dash: curve.dashes === "" ? "solid" : curve.dashes.replaceAll(/(\d+)/g, "$1px").replaceAll(" ", ",")};
  }
  if (curve.error) {
    trace.error_y = {type: "data", array: times(curve.error, figure.y.factor), color: ["read", "vague"].includes(curve.style) ? "#000000" : curve.colour, thickness: 1.5};
  }
  return trace;
}

/** A line on a light edge, to be seen on any colour; two traces. */
function arrowsOf(trace) {
  const edge = {...trace, showlegend: false, hoverinfo: "skip", line: {color: "#ffffff", width: 4}};
  return [edge, {...trace, hoverinfo: "skip", line: {color: trace.line.color, width: 1.2}}];
}

/** Length that a colour bar beside its map has at the least. */
function barLength(figure, width) {
  return equalHeight(figure, width) - MARGIN.t - MARGIN.b;
}

/** Title of a colour bar; of a bar that is shorter, in two lines, broken between words near the middle. */
function barTitle(figure, width) {
  const whole = titleOf(figure.map.value);
  if (widest(whole, width) <= barLength(figure, width)) {
    return whole;
  }
  const middle = whole.length / 2;
  const gaps = [...whole.matchAll(/ /g)].map(({index}) => index).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
  return gaps.length === 0 ? whole : `${whole.slice(0, gaps[0])}<br>${whole.slice(gaps[0] + 1)}`;
}

/** Width of a text's longest line [pixels]. */
function widest(text, width) {
  pen.font = `${sizeOf(width)}px ${FONT}`;
  return Math.max(...text.split("<br>").map(line => pen.measureText(line).width));
}

function mapOf(figure, width) {
  const {map} = figure;
  const at = (a, axis) => [(map.low[a] + map.step[a] / 2) * axis.factor, map.step[a] * axis.factor];
  const [x0, dx] = at(0, figure.x), [y0, dy] = at(1, figure.y);
  const scaled = map.numbers.map(value => value === null ? null : value * map.value.factor);
  const unit = map.value.unit === "" ? "" : ` ${map.value.unit}`;
  return {
    type: "heatmap", x0, dx, y0, dy,
    z: Array.from({length: map.rows}, (_, r) => scaled.slice(r * map.columns, (r + 1) * map.columns)),
    zmin: map.range[0] * map.value.factor, zmax: map.range[1] * map.value.factor,
    colorscale: map.colours.map((colour, k) => [k / (map.colours.length - 1), colour]),
    hoverongaps: false,
    hovertemplate: `${plain(figure.x.text)} %{x:.5g}, ${plain(figure.y.text)} %{y:.5g} ${figure.x.unit}<br>%{z:.5g}${plain(unit)}<extra></extra>`,
    colorbar: {
      title: {text: barTitle(figure, width), side: "right"}, exponentformat: "e", thickness: 14, outlinewidth: 0, ticks: "outside",
      x: 1, len: 1,
    },
  };
}

function titleOf(axis) {
  return plain(axis.unit === "" ? axis.text : `${axis.text} [${axis.unit}]`);
}

/** Height at which a figure of equal scales fills its width; not too high. */
function equalHeight(figure, width) {
  if (figure.map) {
    const long = a => figure.map.step[a] * (a === 0 ? figure.map.columns : figure.map.rows);
    return Math.min(640, Math.max(200, 64 + long(1) / long(0) * (width - 166)));
  }
  const all = (axis, of) => of.flatMap(curve => curve[axis].filter(value => value !== null));
  const x = all("x", figure.curves), y = all("y", figure.curves);
  const ratio = Math.max(...y) / (Math.max(...x) - Math.min(0, ...x));
  return Math.min(640, Math.max(260, 64 + 1.08 * ratio * (width - 76)));
}

/** Axes from edge to edge of a map; room above it for the tools where the bar's title reaches them. */
function layMap(layout, figure, width) {
  const {map} = figure;
  const range = (a, cells, axis) => [map.low[a] * axis.factor, (map.low[a] + cells * map.step[a]) * axis.factor];
  Object.assign(layout.xaxis, {range: range(0, map.columns, figure.x), showgrid: false, zeroline: false, showline: true, mirror: true, linecolor: "#1d2733", constrain: "domain"});
  Object.assign(layout.yaxis, {range: range(1, map.rows, figure.y), showgrid: false, zeroline: false, showline: true, mirror: true, linecolor: "#1d2733", constrain: "domain", scaleanchor: "x", ticks: "outside"});
  if (widest(barTitle(figure, width), width) + 2 * TOOLS > barLength(figure, width)) {
    layout.margin.t += TOOLS;
    layout.height += TOOLS;
  }
}

/** Ticks of a logarithmic axis: 1, 2 and 5 of each decade have labels where these are few. */
function logTicks(figure) {
  const powers = figure.curves.flatMap(curve => curve.x).filter(value => value > 0).map(value => Math.log10(value * figure.x.factor));
  const first = Math.floor(Math.min(...powers)), last = Math.ceil(Math.max(...powers));
  const told = last - first > 2 ? [1] : [1, 2, 5];
  const ticks = Array.from({length: last - first + 1}, (_, k) => [1, 2, 3, 4, 5, 6, 7, 8, 9].map(digit => [digit, first + k])).flat();
  const text = (digit, power) => String(Number(`${digit}e${power}`)).replace("e+", "e");
  return {
    tickmode: "array", tickangle: 0, tickvals: ticks.map(([digit, power]) => Number(`${digit}e${power}`)),
    ticktext: ticks.map(([digit, power]) => told.includes(digit) ? text(digit, power) : ""),
  };
}

function layoutOf(figure, width) {
  const rows = figure.curves.filter(curve => curve.name !== "").length;
  const small = width < 480;
  const layout = {
    margin: {...MARGIN},
    font: {family: FONT, size: sizeOf(width), color: "#1d2733"},
    height: figure.equal ? equalHeight(figure, width) : small ? 330 : 370,
    legend: {orientation: "h", yref: "container", y: 0, yanchor: "bottom", x: 0},
    hovermode: "closest",
    xaxis: {title: {text: titleOf(figure.x), standoff: 8, font: {size: sizeOf(width)}}, automargin: "height", exponentformat: "e", zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea", ticks: "outside", tickcolor: "#b9c0c8"},
    yaxis: {title: {text: titleOf(figure.y), standoff: 8, font: {size: sizeOf(width)}}, automargin: "left", exponentformat: "e", zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea"},
  };
  const longest = Math.max(0, ...figure.curves.map(curve => legendOf(curve, width).length));
  const columns = Math.max(1, Math.floor((width - 76) / (50 + 7.4 * longest)));
  const legend = Math.ceil(rows / columns) * 20;
  layout.height += legend;
  layout.margin.b += legend;
  if (figure.map) {
    layMap(layout, figure, width);
  } else if (figure.equal) {
    layout.yaxis.scaleanchor = "x";
    layout.yaxis.range = [0, 1.06 * figure.y.factor * Math.max(...figure.curves.flatMap(curve => curve.y))];
    layout.xaxis.constrain = layout.yaxis.constrain = "domain";
  }
  if (figure.log_x) {
    layout.xaxis.type = "log";
    Object.assign(layout.xaxis, logTicks(figure));
  }
  if (figure.from_zero) {
    layout.xaxis.rangemode = layout.yaxis.rangemode = "tozero";
  }
  return layout;
}

function draw(figure, place) {
  const traces = figure.curves.flatMap(curve => {
    const trace = traceOf(figure, curve, place.clientWidth);
    return curve.style === "arrows" ? arrowsOf(trace) : [trace];
  });
  if (figure.map) {
    traces.unshift(mapOf(figure, place.clientWidth));
  }
  return Plotly.newPlot(place, traces, layoutOf(figure, place.clientWidth), {
    responsive: true,
    displaylogo: false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
    toImageButtonOptions: {format: "svg", filename: figure.name},
  });
}

/** Draw all figures; those that are folded away when they are first seen. Returns how many it drew. */
export async function drawFigures(figures) {
  let drawn = 0;
  for (const figure of figures) {
    const place = document.querySelector(`#figure-${CSS.escape(figure.name)} .live`);
    const folded = place.closest("details");
    if (folded !== null && !folded.open) {
      folded.addEventListener("toggle", () => draw(figure, place), {once: true});
    } else {
      await draw(figure, place);
      drawn++;
    }
  }
  return drawn;
}

// Figures of the data block drawn by plotly; where none is wanted, the SVG in the page stays.

import Plotly from "plotly.js-basic-dist-min";

// when the colours come again, points have other marks (and lines other dashes, which the numbers bring)
const MARK = ["circle", "square", "diamond", "triangle-up"];

/** A text that plotly shows as it is: it reads some HTML in names and titles. */
function plain(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

function traceOf(figure, curve) {
  const times = (list, factor) => list.map(value => value === null ? null : value * factor);
  const marks = curve.style === "points" || curve.style === "hollow";
  const trace = {
    x: times(curve.x, figure.x.factor),
    y: times(curve.y, figure.y.factor),
    name: plain(curve.name),
    hoverlabel: {namelength: -1}, // whole: plotly would cut an entity in two
    showlegend: curve.name !== "",
    mode: marks ? "markers" : "lines",
    hoverinfo: curve.name === "" ? "x+y" : "x+y+name",
    connectgaps: false,
  };
  if (marks) {
    trace.marker = {symbol: MARK[curve.round], color: curve.style === "hollow" ? "#ffffff" : curve.colour, size: 9, line: {color: curve.colour, width: 2}};
  } else {
    trace.line = {color: curve.colour, width: 2, dash: curve.dashes === "" ? "solid" : curve.dashes.replaceAll(/(\d+)/g, "$1px").replaceAll(" ", ",")};
  }
  if (curve.error) {
    trace.error_y = {type: "data", array: times(curve.error, figure.y.factor), color: curve.colour, thickness: 1.5};
  }
  return trace;
}

function titleOf(axis) {
  return plain(axis.unit === "" ? axis.text : `${axis.text} [${axis.unit}]`);
}

/** Height at which a figure of equal scales fills its width; not too high. */
function equalHeight(figure, width) {
  const all = (axis, of) => of.flatMap(curve => curve[axis].filter(value => value !== null));
  const x = all("x", figure.curves), y = all("y", figure.curves);
  const ratio = Math.max(...y) / (Math.max(...x) - Math.min(0, ...x));
  return Math.min(640, Math.max(260, 64 + 1.08 * ratio * (width - 76)));
}

function layoutOf(figure, width) {
  const rows = figure.curves.filter(curve => curve.name !== "").length;
  const small = width < 480;
  const layout = {
    margin: {l: 64, r: 12, t: 12, b: 52},
    font: {family: "Helvetica, Arial, sans-serif", size: small ? 12 : 13, color: "#1d2733"},
    height: figure.equal ? equalHeight(figure, width) : small ? 330 : 370,
    legend: {orientation: "h", yref: "container", y: 0, yanchor: "bottom", x: 0},
    hovermode: "closest",
    xaxis: {title: {text: titleOf(figure.x)}, zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea", ticks: "outside", tickcolor: "#b9c0c8"},
    yaxis: {title: {text: titleOf(figure.y)}, zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea"},
  };
  const longest = Math.max(0, ...figure.curves.map(curve => curve.name.length));
  const columns = Math.max(1, Math.floor((width - 76) / (50 + 7.4 * longest)));
  const legend = Math.ceil(rows / columns) * 20;
  layout.height += legend;
  layout.margin.b += legend;
  if (figure.equal) {
    layout.yaxis.scaleanchor = "x";
    layout.yaxis.range = [0, 1.06 * figure.y.factor * Math.max(...figure.curves.flatMap(curve => curve.y))];
    layout.xaxis.constrain = layout.yaxis.constrain = "domain";
  }
  if (figure.log_x) {
    layout.xaxis.type = "log";
  }
  if (figure.from_zero) {
    layout.xaxis.rangemode = layout.yaxis.rangemode = "tozero";
  }
  return layout;
}

function draw(figure, place) {
  const traces = figure.curves.map(curve => traceOf(figure, curve));
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

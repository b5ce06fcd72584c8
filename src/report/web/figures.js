// Figures of the data block drawn by plotly; where none is wanted, the SVG in the page stays.

import Plotly from "plotly.js-basic-dist-min";

const DASH = {line: "solid", dashed: "dash", dotted: "dot"};

function traceOf(figure, curve) {
  const times = (list, factor) => list.map(value => value === null ? null : value * factor);
  const marks = curve.style === "points" || curve.style === "hollow";
  const trace = {
    x: times(curve.x, figure.x.factor),
    y: times(curve.y, figure.y.factor),
    name: curve.name,
    showlegend: curve.name !== "",
    mode: marks ? "markers" : "lines",
    hoverinfo: curve.name === "" ? "x+y" : "x+y+name",
    connectgaps: false,
  };
  if (marks) {
    trace.marker = {color: curve.style === "hollow" ? "#ffffff" : curve.colour, size: 9, line: {color: curve.colour, width: 2}};
  } else {
    trace.line = {color: curve.colour, width: 2, dash: DASH[curve.style]};
  }
  if (curve.error) {
    trace.error_y = {type: "data", array: times(curve.error, figure.y.factor), color: curve.colour, thickness: 1.5};
  }
  return trace;
}

function titleOf(axis) {
  return axis.unit === "" ? axis.text : `${axis.text} [${axis.unit}]`;
}

function layoutOf(figure, width) {
  const rows = figure.curves.filter(curve => curve.name !== "").length;
  const small = width < 480;
  const layout = {
    margin: {l: 64, r: 12, t: 12, b: 52},
    font: {family: "Helvetica, Arial, sans-serif", size: small ? 12 : 13, color: "#1d2733"},
    height: figure.equal ? Math.max(360, Math.min(620, width * 0.62)) : small ? 330 : 370,
    legend: {orientation: "h", y: -0.2, yanchor: "top", x: 0},
    hovermode: "closest",
    xaxis: {title: {text: titleOf(figure.x)}, zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea", ticks: "outside", tickcolor: "#b9c0c8"},
    yaxis: {title: {text: titleOf(figure.y)}, zerolinecolor: "#b9c0c8", gridcolor: "#e3e6ea"},
  };
  layout.height += Math.min(8, Math.ceil(rows / (small ? 1 : 3))) * 18;
  if (figure.equal) {
    layout.yaxis.scaleanchor = "x";
    layout.yaxis.rangemode = "tozero";
    layout.xaxis.constrain = layout.yaxis.constrain = "domain";
  }
  if (figure.from_zero) {
    layout.xaxis.rangemode = layout.yaxis.rangemode = "tozero";
  }
  return layout;
}

export async function drawFigures(figures) {
  for (const figure of figures) {
    const place = document.querySelector(`#figure-${CSS.escape(figure.name)} .live`);
    const traces = figure.curves.map(curve => traceOf(figure, curve));
    await Plotly.newPlot(place, traces, layoutOf(figure, place.clientWidth), {
      responsive: true,
      displaylogo: false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
      toImageButtonOptions: {format: "svg", filename: figure.name},
    });
  }
}

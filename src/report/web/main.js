// The page of clod report comes to life: figures that zoom, tables that copy, 3-D views.

import {drawFigures} from "./figures.js";
import {drawViews} from "./view.js";

const errors = [];
window.addEventListener("error", event => errors.push(event.message));

/** A button that copies a table for a spreadsheet. */
function addCopies() {
  for (const table of document.querySelectorAll("table.results, table.copied")) {
    const button = document.createElement("button");
    button.className = "copy";
    button.textContent = "copy table";
    button.onclick = () => {
      const text = [...table.rows].map(row => [...row.cells].map(cell => (cell.querySelector(".is") ?? cell).innerText).join("\t")).join("\n");
      navigator.clipboard.writeText(text).then(() => { button.textContent = "copied"; });
    };
    table.parentElement.after(button);
  }
}

/** Put the name of its column before each cell, to be seen where a table is stacked. */
function nameCells(table) {
  const heads = [...(table.tHead?.rows[0]?.cells ?? [])];
  for (const row of table.tBodies[0]?.rows ?? []) {
    [...row.cells].slice(1).forEach((cell, k) => {
      const is = document.createElement("span");
      is.className = "is";
      is.append(...cell.childNodes);
      const of = document.createElement("span");
      of.className = "of";
      of.innerHTML = heads[k + 1]?.innerHTML ?? "";
      cell.append(of, is);
    });
  }
}

/** A table that is wider than its place is stacked: each row a block, with a line for each of its cells. */
function stackTables() {
  for (const table of document.querySelectorAll(".scroll > table")) {
    table.classList.remove("stacked");
    if (table.parentElement.scrollWidth > table.parentElement.clientWidth) {
      table.classList.add("stacked");
    }
  }
}

function fitTables() {
  document.querySelectorAll(".scroll > table").forEach(nameCells);
  stackTables();
  let width = window.innerWidth;
  window.addEventListener("resize", () => {
    if (window.innerWidth !== width) {
      width = window.innerWidth;
      stackTables();
    }
  });
}

/** The first cells of tables of which something is out of sight. */
function hiddenTables() {
  return [...document.querySelectorAll("table")].filter(table => {
    const place = table.parentElement;
    return place.scrollWidth > place.clientWidth || table.scrollWidth > table.clientWidth;
  }).map(table => table.rows[0].cells[0].textContent);
}

async function start() {
  const data = JSON.parse(document.getElementById("clod-data").textContent);
  document.body.classList.add("scripted");
  fitTables();
  addCopies();
  const drawn = await drawFigures(data.figures);
  const seen = drawViews(data.views);
  // for tests: what was drawn, in the document itself
  document.documentElement.dataset.figures = drawn;
  document.documentElement.dataset.views = JSON.stringify(seen);
  document.documentElement.dataset.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  document.documentElement.dataset.stacked = document.querySelectorAll("table.stacked").length;
  document.documentElement.dataset.hidden = JSON.stringify(hiddenTables());
  document.documentElement.dataset.errors = JSON.stringify(errors);
  document.documentElement.dataset.ready = "yes";
}

start().catch(error => {
  document.body.classList.remove("scripted");
  document.documentElement.dataset.errors = JSON.stringify([String(error)]);
  throw error;
});

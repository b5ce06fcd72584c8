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
      const text = [...table.rows].map(row => [...row.cells].map(cell => cell.innerText).join("\t")).join("\n");
      navigator.clipboard.writeText(text).then(() => { button.textContent = "copied"; });
    };
    table.parentElement.after(button);
  }
}

async function start() {
  const data = JSON.parse(document.getElementById("clod-data").textContent);
  document.body.classList.add("scripted");
  addCopies();
  const drawn = await drawFigures(data.figures);
  const seen = drawViews(data.views);
  // for tests: what was drawn, in the document itself
  document.documentElement.dataset.figures = drawn;
  document.documentElement.dataset.views = JSON.stringify(seen);
  document.documentElement.dataset.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  document.documentElement.dataset.errors = JSON.stringify(errors);
  document.documentElement.dataset.ready = "yes";
}

start().catch(error => {
  document.body.classList.remove("scripted");
  document.documentElement.dataset.errors = JSON.stringify([String(error)]);
  throw error;
});

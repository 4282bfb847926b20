"use strict";
const columns = ["Program", "Status", "Dialect", "Blocks", "Tool changes", "Feed length, mm", "Time, s", "Errors", "Warnings",
                 "First error or warning"];
const firstNumber = 3, lastNumber = 8, atOnce = 1000;
const rows = JSON.parse(document.getElementById("data").textContent);
const texts = rows.map(row => row.join("\n").toLowerCase());
const find = document.getElementById("find"), status = document.getElementById("status");
let sorted = 0, direction = 1, most = atOnce;

const isNumber = column => column >= firstNumber && column <= lastNumber;
const compare = new Intl.Collator("en", { numeric: true }).compare;

function chosen() {
  const wanted = find.value.trim().toLowerCase();
  const all = rows.map((_, index) => index).filter(index =>
    (!wanted || texts[index].includes(wanted)) && (!status.value || rows[index][1] === status.value));
  return all.sort((a, b) => {
    const x = rows[a][sorted], y = rows[b][sorted];
    const order = isNumber(sorted) ? (x ?? -1) - (y ?? -1) : compare(x ?? "", y ?? "");
    return direction * order || a - b;
  });
}

function cell(value, column) {
  const out = document.createElement("td");
  if (column === 0) out.className = "program";
  if (column === 1) out.className = value === "ok" ? "ok" : "bad";
  if (isNumber(column)) out.className = "number";
  if (column === columns.length - 1) out.className = "said";
  out.textContent = value === null ? "" : isNumber(column) ? Math.round(value * 10) / 10 : value;
  return out;
}

function show() {
  const all = chosen(), body = document.createDocumentFragment();
  for (const index of all.slice(0, most)) {
    const line = document.createElement("tr");
    rows[index].forEach((value, column) => line.append(cell(value, column)));
    body.append(line);
  }
  document.getElementById("rows").replaceChildren(body);
  document.getElementById("more").hidden = all.length <= most;
  document.getElementById("shown").textContent =
    all.length === rows.length && all.length <= most ? "" : `${Math.min(all.length, most)} of ${rows.length} shown`;
  document.querySelectorAll("th").forEach((head, column) =>
    head.setAttribute("aria-sort", column !== sorted ? "none" : direction > 0 ? "ascending" : "descending"));
}

columns.forEach((name, column) => {
  const head = document.createElement("th"), button = document.createElement("button");
  button.textContent = name;
  button.addEventListener("click", () => {
    direction = column === sorted ? -direction : isNumber(column) ? -1 : 1;
    sorted = column;
    show();
  });
  head.append(button);
  document.getElementById("heads").append(head);
});
for (const name of [...new Set(rows.map(row => row[1]))].sort()) status.append(new Option(name, name));
find.addEventListener("input", () => { most = atOnce; show(); });
status.addEventListener("change", () => { most = atOnce; show(); });
document.getElementById("more").addEventListener("click", () => { most += atOnce; show(); });
show();

"use strict";
// Thousands of rows stay data: only one page of them is ever in the document.
(() => {
  const PAGE = 50;
  const data = JSON.parse(document.getElementById("data").textContent);
  const width = data.heads.length;
  const all = data.rows.map((row) => ({ row, text: row.slice(0, width).join(" ").toLowerCase() }));
  const byId = (id) => document.getElementById(id);
  let shown = all;
  let first = 0;
  let sorted = { column: -1, down: false };

  const cell = (kind, text) => {
    const made = document.createElement(kind);
    made.textContent = text ?? "";
    return made;
  };

  function draw() {
    const body = byId("table").tBodies[0];
    body.replaceChildren(...shown.slice(first, first + PAGE).map(({ row }) => {
      const line = document.createElement("tr");
      line.append(...row.slice(0, width).map((value) => cell("td", value)));
      line.append(cell("td", row[width] ? "yes" : "no"));
      const key = cell("td", "");
      key.className = "key";
      const link = row[width + 2] ? document.createElement("a") : document.createElement("span");
      link.textContent = row[width + 1].slice(0, 12);
      if (row[width + 2]) link.href = row[width + 2];
      key.append(link);
      line.append(key);
      return line;
    }));
    const last = Math.min(first + PAGE, shown.length);
    byId("count").textContent = shown.length ? `${first + 1} to ${last} of ${shown.length}` : "none";
    byId("before").disabled = first === 0;
    byId("after").disabled = last === shown.length;
  }

  function choose() {
    const words = byId("filter").value.toLowerCase().split(/\s+/).filter(Boolean);
    shown = all.filter(({ text }) => words.every((word) => text.includes(word)));
    const { column, down } = sorted;
    if (column >= 0) {
      const sign = down ? -1 : 1;
      shown.sort(({ row: a }, { row: b }) => {
        const [x, y] = [a[column], b[column]];
        if (x === null || y === null) return (x === null) - (y === null);
        return sign * (typeof x === "number" ? x - y : String(x).localeCompare(String(y)));
      });
    }
    first = 0;
    draw();
  }

  const heads = document.createElement("tr");
  [...data.heads, "said and reached", "key"].forEach((name, column) => {
    const head = document.createElement("th");
    head.scope = "col";
    const button = cell("button", name);
    button.type = "button";
    button.addEventListener("click", () => {
      sorted = { column, down: sorted.column === column && !sorted.down };
      choose();
    });
    head.append(button);
    heads.append(head);
  });
  byId("table").tHead.append(heads);
  byId("filter").addEventListener("input", choose);
  byId("before").addEventListener("click", () => { first -= PAGE; draw(); });
  byId("after").addEventListener("click", () => { first += PAGE; draw(); });
  choose();
})();

// The page around the players: words that lead to moments, scenarios that open, pages of tiles.

const PER_PAGE = 20, LEAD_S = 1.5, REST_S = 1;
const players = [];

let current = null;

function playerOf(article) {
  if (article.player) return article.player;
  const [scene, before] = JSON.parse(article.querySelector("script[type='application/json']").textContent);
  article.player = mount(article.querySelector(".player-here"), scene, { before });
  players.push(article.player);
  current ??= article.player;
  article.addEventListener("pointerdown", () => { current = article.player; });
  article.player.on("claim", (id) => markWords([id]));
  article.player.on("playing", (playing) => {
    // One scenario plays at a time.
    if (playing) for (const other of players) if (other !== article.player) other.pause();
  });
  return article.player;
}

document.addEventListener("keydown", (event) => {
  // Keys that are meant for nothing else are meant for the picture.
  if (event.target === document.body) current?.key(event);
});

const words = [...document.querySelectorAll(".text mark[data-claims]")];
const became = document.querySelector(".became");
const claimsOf = (mark) => JSON.parse(mark.dataset.claims);

function markWords(ids) {
  for (const mark of words) mark.classList.toggle("now", claimsOf(mark).some((id) => ids.includes(id)));
}

for (const mark of words) {
  const tell = () => { became.textContent = mark.title.replaceAll("\n", "  ·  "); };
  const go = () => {
    const ids = claimsOf(mark), first = document.querySelector(".scenario");
    if (!first) return;
    const player = playerOf(first), claim = scenesClaim(player, ids);
    player.claim(claim.id);
    player.panel.mark(ids);
    markWords(ids);
    tell();
    if (claim.shown_s) player.playMoment(claim.shown_s, LEAD_S, REST_S);
    player.element.scrollIntoView({ block: "nearest" });
  };
  mark.addEventListener("click", go);
  mark.addEventListener("pointerenter", tell);
  mark.addEventListener("focus", tell);
  mark.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    go();
  });
}

/** The statement to go to: the words' first, which lies at a moment if any does. */
function scenesClaim(player, ids) {
  return player.recording.data.claims.find((claim) => claim.id === ids[0]);
}

for (const [number, article] of [...document.querySelectorAll(".scenario")].entries()) {
  const fold = article.closest("details");
  if (number === 0 || !fold) playerOf(article);
  else fold.addEventListener("toggle", () => fold.open && playerOf(article));
}

for (const list of document.querySelectorAll(".tiles[data-paged]")) {
  const tiles = [...list.children];
  if (tiles.length <= PER_PAGE) continue;
  const place = h("span", { role: "status" });
  let page = 0;
  const last = Math.ceil(tiles.length / PER_PAGE) - 1;
  const back = h("button", { type: "button", onclick: () => turn(-1) }, "Previous");
  const on = h("button", { type: "button", onclick: () => turn(1) }, "Next");
  const turn = (by) => {
    page = Math.min(Math.max(page + by, 0), last);
    const from = page * PER_PAGE, to = Math.min(from + PER_PAGE, tiles.length);
    for (const [k, tile] of tiles.entries()) tile.hidden = k < from || k >= to;
    place.textContent = `${from + 1} to ${to} of ${tiles.length}`;
    back.disabled = page === 0;
    on.disabled = page === last;
  };
  turn(0);
  list.after(h("div", { class: "pages" }, back, place, on));
}

window.players = players;

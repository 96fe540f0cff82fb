// What the whole page shares: the theme that was chosen, and one tooltip for everything.
(() => {
  const chosen = localStorage.getItem("scegen-theme");
  if (chosen === "light" || chosen === "dark") document.documentElement.dataset.theme = chosen;
  window.scegenTheme = () => {
    const root = document.documentElement;
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = (root.dataset.theme || (dark ? "dark" : "light")) === "dark" ? "light" : "dark";
    localStorage.setItem("scegen-theme", root.dataset.theme);
  };

  let tip = null, timer = null, owner = null;
  const place = (target) => {
    const r = target.getBoundingClientRect();
    const t = tip.getBoundingClientRect();
    const left = Math.min(Math.max(8, r.left + r.width / 2 - t.width / 2), innerWidth - t.width - 8);
    const below = r.bottom + 8 + t.height < innerHeight;
    tip.style.transform = `translate(${left}px, ${below ? r.bottom + 8 : r.top - t.height - 8}px)`;
  };
  window.scegenTip = (target) => {
    if (target === owner) return;
    owner = target;
    clearTimeout(timer);
    if (tip) tip.hidden = true;
    if (!target || !target.dataset.tip) return;
    timer = setTimeout(() => {
      if (!target.isConnected) return;
      if (!tip) {
        tip = document.createElement("div");
        tip.className = "tip";
        tip.setAttribute("role", "tooltip");
        document.body.append(tip);
      }
      tip.textContent = target.dataset.tip;
      tip.hidden = false;
      place(target);
    }, 250);
  };
  const near = (event) => window.scegenTip(event.target.closest?.("[data-tip]") || null);
  addEventListener("mouseover", (event) => event.target.tagName !== "TEXTAREA" && near(event));
  addEventListener("focusin", near);
  addEventListener("focusout", () => window.scegenTip(null));
  addEventListener("scroll", () => window.scegenTip(null), true);
  addEventListener("keydown", (event) => event.key === "Escape" && window.scegenTip(null));
})();

// Added to viser's page. What it does not find there it leaves alone.
(() => {
  const NARROW = 1000; // pixels; below that the senses begin collapsed

  // viser writes where it connects to into the address bar, which has it already.
  history.replaceState = () => {};

  // viser computes all normals anew, out of triangles: round skin would have facets, and seams where its texture has
  // edges. Shapes that bring their own keep them. three.js tells its developer tools of each scene.
  const owner = (thing, name) => {
    while (thing && !Object.hasOwn(thing, name)) thing = Object.getPrototypeOf(thing);
    return thing;
  };
  const keepNormals = (geometry) => {
    const shape = owner(geometry, "computeVertexNormals");
    const compute = shape?.computeVertexNormals;
    if (!compute || compute.keeps) return;
    shape.computeVertexNormals = function () {
      if (!this.attributes.normal) compute.call(this);
    };
    shape.computeVertexNormals.keeps = true;
  };
  const tools = (window.__THREE_DEVTOOLS__ ??= new EventTarget());
  tools.addEventListener("observe", ({ detail }) => {
    const node = detail.isScene && owner(detail, "add");
    if (!node || node.add.keeps) return;
    const add = node.add;
    node.add = function (...parts) {
      for (const part of parts) if (part?.isMesh) keepNormals(part.geometry);
      return add.apply(this, parts);
    };
    node.add.keeps = true;
  });

  // Calls act with an element when there is one, once.
  const once = (find, act) => {
    const tried = () => {
      const found = find();
      if (found) act(found);
      return Boolean(found);
    };
    if (tried()) return;
    const watch = new MutationObserver(() => tried() && watch.disconnect());
    watch.observe(document, { childList: true, subtree: true });
  };

  // On a phone viser puts its panel over the scene. It begins closed, and the scene takes what it leaves.
  const sheet = () =>
    [...document.querySelectorAll(".mantine-Paper-root")].find(
      (paper) => paper.style.position === "fixed" && paper.style.bottom === "0px",
    );
  const scene = () => document.querySelector("[data-dock-root]");
  once(sheet, (panel) => {
    panel.style.width = "100%";
    for (const inner of panel.querySelectorAll("div")) {
      if (inner.style.width === "20em") inner.style.width = "100%";
    }
    const fit = () => {
      const room = scene();
      if (room) room.style.height = panel.isConnected ? `calc(100% - ${panel.offsetHeight}px)` : "100%";
    };
    new ResizeObserver(fit).observe(panel);
    addEventListener("resize", () => setTimeout(fit));
    const handle = [...panel.querySelectorAll("div")].find((part) => part.style.height === "3.5em");
    if (handle) handle.click();
  });

  // In a notebook the panels at both sides would leave a third of the page.
  if (innerWidth < NARROW) {
    once(
      () => document.querySelector('[data-dock-region-handle="left"] [role="button"]'),
      (button) => button.click(),
    );
  }
})();

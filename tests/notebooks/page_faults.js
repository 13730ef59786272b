/* Visual faults of a page that a program can decide, as a list of texts. */
const faults = new Set(), width = innerWidth;
const seen = (element) => {
  const { width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && getComputedStyle(element).visibility !== "hidden";
};
const scrolls = (element) => {
  for (let each = element; each && each !== document.body; each = each.parentElement) {
    if (["auto", "scroll"].includes(getComputedStyle(each).overflowX)) return true;
  }
  return false;
};
const texts = function* (root) {
  const walk = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) yield walk.currentNode;
};

// Nothing is wider than the page, unless it scrolls by itself; pictures are never cut.
const page = document.documentElement.scrollWidth;
if (page > width) faults.add(`the page is ${page} wide`);
for (const element of document.querySelectorAll("article :is(img, svg, canvas, table, pre, math)")) {
  const right = element.getBoundingClientRect().right;
  const drawn = element.matches("img, svg, canvas");
  if (seen(element) && right > width + 1 && (drawn || !scrolls(element))) {
    faults.add(`${element.tagName} ends at ${Math.round(right)}`);
  }
}

// Texts of a picture lie within it, and not over each other.
for (const picture of document.querySelectorAll("article :is(.plotly-picture, svg:not(svg svg))")) {
  const box = picture.getBoundingClientRect();
  const named = [...picture.querySelectorAll("text")].filter((x) => seen(x) && x.textContent.trim());
  const placed = named.map((x) => [x.textContent.slice(0, 40), x.getBoundingClientRect()]);
  placed.forEach(([text, at], k) => {
    const out = Math.max(box.left - at.left, at.right - box.right, box.top - at.top, at.bottom - box.bottom);
    if (out > 2) faults.add(`"${text}" leaves its picture by ${Math.round(out)}`);
    for (const [other, its] of placed.slice(0, k)) {
      const wide = Math.min(at.right, its.right) - Math.max(at.left, its.left);
      const high = Math.min(at.bottom, its.bottom) - Math.max(at.top, its.top);
      if (wide > 2 && high > 3) faults.add(`"${text}" lies over "${other}"`);
    }
  });
}

// No LaTeX is left over, and no name is broken inside a word.
for (const node of texts(document.querySelector("article, [role=main]"))) {
  const parent = node.parentElement;
  if (!parent.closest("pre, code, script, math") && /\\[([]|\\[a-zA-Z]{2,}|\$[^$\s]+\$/.test(node.data)) {
    faults.add(`LaTeX: ${node.data.trim().slice(0, 60)}`);
  }
  if (parent.closest("code") && !parent.closest("pre") && /^[\w.]+$/.test(node.data)) {
    const range = document.createRange();
    range.selectNodeContents(node);
    const lines = new Set([...range.getClientRects()].map((line) => Math.round(line.top)));
    if (lines.size > 1) faults.add(`broken: ${parent.textContent}`);
  }
}
return [...faults];

/* Draws a picture of plotly at any width: its title above the names of its curves, both above the
   axes.  On a phone, scenes beside each other come to stand one below the other. */
function drawPicture(name, figure) {
  const box = document.getElementById(name), width = box.offsetWidth, phone = width < 560;
  const layout = structuredClone(figure.layout), margin = layout.margin ?? {};
  const scenes = Object.keys(layout).filter((key) => /^scene\d*$/.test(key)).sort();
  const below = margin.b ?? 80;
  let body = (layout.height ?? 480) - (margin.t ?? 100) - below;
  if (phone && scenes.length) {
    body = scenes.length * Math.round(0.95 * width);
    scenes.forEach((scene, k) => {
      const y = [scenes.length - 1 - k, scenes.length - k].map((part) => part / scenes.length);
      layout[scene].domain = { x: [0, 1], y };
    });
  }
  // The names of axes need a place beside a scene that is narrow.
  for (const scene of scenes) {
    const { x, y } = layout[scene].domain, eye = layout[scene].camera?.eye;
    const narrow = (body * (y[1] - y[0])) / (width * (x[1] - x[0]));
    const reach = Math.min(1.4, Math.max(1, 1.2 * narrow));
    for (const axis in eye) eye[axis] *= reach;
  }
  const size = layout.title?.font?.size ?? 17;
  const lines = [""], pen = document.createElement("canvas").getContext("2d");
  pen.font = `${size}px ${layout.font?.family ?? '"Open Sans", verdana, arial, sans-serif'}`;
  for (const word of (layout.title?.text ?? "").split(" ")) {
    const longer = `${lines.at(-1)} ${word}`.trim();
    if (pen.measureText(longer).width > 0.97 * width && lines.at(-1)) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  const titled = 14 + 1.35 * size * lines.length;
  delete layout.width;
  const placed = (head) => ({
    height: body + head + below,
    margin: { ...margin, t: head },
    title: {
      ...layout.title, text: lines.join("<br>"), yref: "container", yanchor: "top",
      y: 1 - (8 + 0.75 * size * (lines.length - 1)) / (body + head + below),
    },
  });
  const draw = (head) => {
    box.style.height = `${body + head + below}px`;
    const how = { responsive: true, displaylogo: false, displayModeBar: phone ? false : "hover" };
    const shown = { ...layout, ...placed(head), autosize: true, modebar: { orientation: "v" } };
    return Plotly.react(box, figure.data, shown, how);
  };
  const named = () => box.querySelector("g.legend .bg")?.getBoundingClientRect().height ?? 0;
  draw(titled + 90)
    .then(() => draw(titled + named()))
    .then(() => figure.frames && Plotly.addFrames(box, figure.frames));
}

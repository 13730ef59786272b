// The live page: sliders, two pictures, and the numbers of the state.
const POINTS = 1600, PERIODS = 8, STEPS = 48;
const WORDS = {
    [NONPHYSICAL]: "No body has a principal moment larger than the sum of the other two.",
    [TIME]: "At this time the angle is lost in doubles.",
    [SEPARATRIX]: "This motion is nearer to the separatrix than doubles can follow so long.",
};
const form = document.getElementById("live");
const part = (name) => document.getElementById(`live-${name}`);
const value = (name) => Number(part(name).value);
const three = (name) => [1, 2, 3].map((k) => value(`${name}${k}`));
const dot = (x, y) => x.reduce((sum, each, k) => sum + each * y[k], 0);
const energyOf = (c, omega) => dot(c.map((x, k) => x * omega[k]), omega) / 2;
const range = (count) => Array.from({ length: count + 1 }, (_, k) => k / count);

/** The columns of the matrix from body to space. */
function axes([w, x, y, z]) {
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    ];
}

/** A vector as the viewer has it: right, up, and towards the eye. */
function seen(v) {
    const turn = (value("turn") * Math.PI) / 180, lean = 0.42;
    const [right, away] = [
        Math.cos(turn) * v[0] + Math.sin(turn) * v[1], Math.cos(turn) * v[1] - Math.sin(turn) * v[0],
    ];
    return [right, Math.cos(lean) * v[2] + Math.sin(lean) * away, Math.sin(lean) * v[2] - Math.cos(lean) * away];
}

const place = ([x, y]) => `${x.toFixed(4)} ${(-y).toFixed(4)}`;
const line = (points) => `M${points.map(place).join("L")}`;

/** Paths of a curve: what is before the ellipsoid's outline, and what is behind. */
function curve(name, points) {
    const parts = { true: [], false: [] };
    let last = null;
    for (const point of points) {
        const before = point.front;
        if (last?.front !== before) parts[before].push(last ? [last.at] : []);
        parts[before].at(-1).push(point.at);
        last = point;
    }
    const drawn = (every, more) =>
        `<path class="${name}${more}" d="${every.filter((x) => x.length > 1).map(line).join("")}"/>`;
    return drawn(parts.false, " behind") + drawn(parts.true, "");
}

/** Half the edges of a box that has these moments, the longest 1. */
function box(c) {
    const squares = [0, 1, 2].map((k) => Math.max(c[(k + 1) % 3] + c[(k + 2) % 3] - c[k], 0));
    const longest = Math.sqrt(Math.max(...squares));
    return squares.map((x) => Math.max(Math.sqrt(x) / longest, 0.03));
}

function drawBody(c, state, momentum) {
    const to = axes(state.q), half = box(c);
    const corner = (signs) =>
        seen([0, 1, 2].map((k) => 0.8 * signs.reduce((sum, s, j) => sum + s * half[j] * to[j][k], 0)));
    const faces = [0, 1, 2].flatMap((k) => [-1, 1].map((side) => {
        const corners = [[-1, -1], [-1, 1], [1, 1], [1, -1]].map(([one, other]) => {
            const signs = [0, 0, 0];
            [signs[k], signs[(k + 1) % 3], signs[(k + 2) % 3]] = [side, one, other];
            return corner(signs);
        });
        return { corners, depth: side * seen(to[k])[2] };
    })).filter((face) => face.depth > 0);
    const arrow = momentum.map((x) => x / (Math.hypot(...momentum) || 1));
    const tips = to.map((axis, k) => seen(axis.map((x) => x * (0.8 * half[k] + 0.35))));
    const drawn = faces.map(({ corners, depth }) =>
        `<path class="face" style="fill-opacity:${(0.25 + 0.6 * depth).toFixed(2)}" d="${line(corners)}Z"/>`);
    const named = tips.map((tip, k) =>
        `<path class="axis" d="${line([[0, 0], tip])}"/><text x="${tip[0]}" y="${-tip[1]}">${k + 1}</text>`);
    const still = `<path class="momentum" d="${line([arrow.map((x) => -1.5 * x), arrow.map((x) => 1.5 * x)].map(seen))}"/>`;
    redraw("body", [still, ...named, ...drawn]);
}

/** Replace a picture, but not its title. */
function redraw(name, parts) {
    const picture = part(name), title = picture.querySelector("title");
    picture.innerHTML = parts.join("");
    picture.prepend(title);
}

/** Points of the ellipsoid of energy, whose longest half axis is 1. */
function onEllipsoid(size) {
    const largest = Math.max(...size);
    // The normal decides what is before the outline.
    return (L) => ({
        at: seen(L.map((x) => x / largest)),
        front: seen(L.map((x, k) => x / size[k] ** 2))[2] >= 0,
    });
}

/** The separatrix: where K^2 is 2 H times the middle moment. */
function separatrix(c, size) {
    const [d, b, a] = [0, 1, 2].sort((j, k) => c[j] - c[k]);
    if (!(c[d] < c[b] && c[b] < c[a])) return [];
    const slope = Math.atan(Math.sqrt((1 / c[d] - 1 / c[b]) / (1 / c[b] - 1 / c[a])));
    return [slope, -slope].map((angle) => range(STEPS).map((share) => {
        const L = [0, 0, 0], turn = 2 * Math.PI * share;
        L[b] = size[b] * Math.cos(turn);
        L[a] = size[b] * Math.sin(turn) * Math.sin(angle);
        L[d] = size[b] * Math.sin(turn) * Math.cos(angle);
        return L;
    }));
}

function drawPolhode(motion, c, omega0, size) {
    const on = onEllipsoid(size);
    const circle = (k, height) => range(STEPS).map((share) => {
        const L = [0, 0, 0], radius = Math.sqrt(1 - height * height);
        L[k] = size[k] * height;
        L[(k + 1) % 3] = size[(k + 1) % 3] * radius * Math.cos(2 * Math.PI * share);
        L[(k + 2) % 3] = size[(k + 2) % 3] * radius * Math.sin(2 * Math.PI * share);
        return on(L);
    });
    const meshes = [0, 1, 2].flatMap((k) => [-0.7, 0, 0.7].map((height) => curve("mesh", circle(k, height))));
    const apart = (Math.max(...c) - Math.min(...c)) / Math.max(...c);
    const speed = Math.hypot(...omega0) * (apart || 1);
    const end = Math.min(speed > 0 ? (2 * Math.PI * PERIODS) / speed : 1, motion.lastTime);
    const { omega } = motion.states(range(POINTS).map((share) => share * end));
    const path = range(POINTS).map((_, i) => on(c.map((x, k) => x * omega[3 * i + k])));
    const lines = separatrix(c, size).map((points) => curve("separatrix", points.map(on)));
    return [...meshes, ...lines, curve("curve", path)];
}

/** Where the momentum is now, on the ellipsoid. */
function drawNow(c, size, omega) {
    const now = onEllipsoid(size)(c.map((x, k) => x * omega[k])), [x, y] = now.at;
    return `<circle class="now${now.front ? "" : " behind"}" cx="${x}" cy="${-y}" r="0.06"/>`;
}

// The motion of the sliders, and the picture of its polhode from the side that is seen.
let kept = {};

function show() {
    const [c, omega0, t] = [three("c"), three("omega"), value("t")];
    for (const input of form.querySelectorAll("input")) {
        document.querySelector(`output[for="${input.id}"]`).textContent = input.value;
    }
    try {
        const key = [...c, ...omega0].join(" ");
        if (kept.key !== key) kept = { key, motion: new TorqueFreeMotion(c, omega0) };
        const { motion } = kept, state = motion.at(t), energy = energyOf(c, omega0);
        const size = c.map((x) => Math.sqrt(2 * energy * x) || 1);
        if (kept.turn !== value("turn")) {
            kept.turn = value("turn");
            kept.polhode = drawPolhode(motion, c, omega0, size);
        }
        const momentum = axes(state.q).reduce(
            (sum, axis, k) => sum.map((x, j) => x + c[k] * state.omega[k] * axis[j]), [0, 0, 0],
        );
        drawBody(c, state, momentum);
        redraw("polhode", [...kept.polhode, drawNow(c, size, state.omega)]);
        part("q").textContent = [...state.q].join("  ");
        part("omega").textContent = [...state.omega].join("  ");
        part("energy").textContent = energyOf(c, state.omega);
        part("momentum").textContent = Math.hypot(...momentum);
        part("length").textContent = (Math.hypot(...state.q) - 1).toExponential(1);
        part("body-title").textContent = `The body in space at ${t} s`;
        part("refused").textContent = "";
        form.classList.remove("refused");
    } catch (error) {
        if (!(error instanceof RefusedError)) throw error;
        const words = WORDS[error.code] ?? `${error.message}.`;
        if (part("refused").textContent !== words) part("refused").textContent = words;
        for (const name of ["q", "omega", "energy", "momentum", "length"]) part(name).textContent = "";
        form.classList.add("refused");
    }
}

let before = null;

function run(now) {
    if (part("run").getAttribute("aria-pressed") !== "true") {
        before = null;
        return;
    }
    const t = value("t") + (before === null ? 0 : ((now - before) / 1000) * value("pace"));
    before = now;
    part("t").value = t >= Number(part("t").max) ? 0 : t;
    show();
    requestAnimationFrame(run);
}

form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener("input", (event) => {
    if (event.target.id === "live-example" && event.target.value) {
        const names = ["c1", "c2", "c3", "omega1", "omega2", "omega3"];
        event.target.value.split(" ").forEach((each, k) => (part(names[k]).value = each));
    } else if (/^live-(c|omega)\d$/.test(event.target.id)) {
        part("example").value = "";
    }
    show();
});
part("run").addEventListener("click", () => {
    const runs = part("run").getAttribute("aria-pressed") !== "true";
    part("run").setAttribute("aria-pressed", String(runs));
    part("run").textContent = runs ? "Stop" : "Run";
    if (runs) requestAnimationFrame(run);
});
show();

// Answers the questions of `rigidsym._engines.piped`, by the module that the first argument names.
import { readSync, writeSync } from "node:fs";
import { pathToFileURL } from "node:url";

const own = await import(pathToFileURL(process.argv[2]));
// Python has checked the moments.
own.settings.ALLOW_NONPHYSICAL = true;

function read(count) {
    const bytes = new Uint8Array(8 * count);
    for (let at = 0; at < bytes.length; ) {
        const more = readSync(0, bytes, at, bytes.length - at, null);
        if (more === 0) process.exit();
        at += more;
    }
    return new Float64Array(bytes.buffer);
}

function write(bytes) {
    for (let at = 0; at < bytes.length; ) at += writeSync(1, bytes, at);
}

const ANSWERS = [
    // Motions from doubles, and their states.
    (bodies, n, stride, lenient) => {
        const [inertia, omega0, attitude0] = [read(3 * bodies), read(3 * bodies), read(4 * bodies)];
        const t = read(stride === 0 ? n : n * bodies);
        const [q, omega] = [new Float64Array(4 * n * bodies), new Float64Array(3 * n * bodies)];
        const codes = lenient ? new Int32Array(bodies) : null;
        const one = own.new_motion();
        const [code, failed] = own.propagate(
            bodies, inertia, omega0, attitude0, n, t, stride, q, omega, codes,
        );
        if (bodies === 1) own.motion_init(one, inertia, omega0, attitude0);
        return [[code, failed, own.last_time(one)], q, omega];
    },
    // One motion from pairs of doubles, and its states.
    (_, n) => {
        const pairs = (count) => Array.from({ length: count }, () => read(2));
        const [c, apart, rates, attitude] = [pairs(3), pairs(3), pairs(3), pairs(4)];
        const [known, [unit], t] = [read(2), read(1), read(n)];
        const [q, omega] = [new Float64Array(4 * n), new Float64Array(3 * n)];
        const one = own.new_motion();
        let code = own.motion_init_double_doubles(one, c, apart, rates, attitude, known, unit);
        if (code === own.OK) code = own.states_at(one, n, t, q, omega);
        return [[code, 0, own.last_time(one)], q, omega];
    },
    // A step of each body.
    (bodies) => {
        const [inertia, q, omega] = [read(3 * bodies), read(4 * bodies), read(3 * bodies)];
        const dt = read(bodies);
        return [[...own.steps(bodies, inertia, 3, q, omega, dt, 1, q, omega), 0], q, omega];
    },
];

const words = [];
for (let code = 0; own.rule(code) !== own.rule(-1); code++) {
    words.push([own.field(code), own.rule(code)]);
}
write(Buffer.from(`${JSON.stringify(words)}\n`));
for (;;) {
    const [kind, bodies, n, stride, lenient] = read(5);
    for (const part of ANSWERS[kind](bodies, n, stride, lenient !== 0)) {
        write(new Uint8Array(Float64Array.from(part).buffer));
    }
}

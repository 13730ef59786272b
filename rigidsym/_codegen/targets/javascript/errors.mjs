/** A refused input: `code`, the `field` that it is about, and the `rule` that it breaks. */
export class RefusedError extends RangeError {
    constructor(code) {
        super(message(code));
        this.name = "RefusedError";
        this.code = code;
        this.field = field(code);
        this.rule = rule(code);
    }
}

function accept(code) {
    if (code !== OK) throw new RefusedError(code);
}

/** Return an array of doubles, after a check that it is one of `count` numbers. */
function numbers(name, x, count = x?.length) {
    const found = Float64Array.from(x ?? [], (each) => (typeof each === "number" ? each : NaN));
    if (count === undefined || found.length !== count) {
        throw new TypeError(`${name}: expected ${count ?? "an array of"} numbers`);
    }
    return found;
}

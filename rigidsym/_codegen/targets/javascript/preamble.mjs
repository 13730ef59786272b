/** What the module takes for granted, to be set before it is used. */
export const settings = {
    /** Accept moments of inertia that no body can have. */
    ALLOW_NONPHYSICAL: false,
};

const real = new Float64Array(1);
const whole = new BigUint64Array(real.buffer);
const words = new Uint32Array(real.buffer);
// Where the half of a double with the exponent is among `words`.
const HIGH = new Uint8Array(new Uint16Array([1]).buffer)[0];
const ZERO = pair(0, 0);

function bits_of(x) {
    real[0] = x;
    return whole[0];
}

function from_bits(bits) {
    whole[0] = bits;
    return real[0];
}

function cut(bits) {
    return BigInt.asUintN(64, bits);
}

/** 2^n for a whole number n between -1022 and 1023. */
function power_of_two(n) {
    words[1 - HIGH] = 0;
    words[HIGH] = (n + 1023) * 0x100000;
    return real[0];
}

/** (-1)^n for a whole number n. */
function alternating(n) {
    return n % 2 === 0 ? 1 : -1;
}

/** The e for which |x| is between 2^(e - 1) and 2^e, 0 for zero. */
function exponent(x) {
    if (x === 0) return 0;
    real[0] = x;
    const e = (words[HIGH] >>> 20) & 0x7ff;
    return e === 0 ? exponent(x * 18446744073709552000) - 64 : e - 1022;
}

/** x 2^n, rounded once: only the last factor may leave a subnormal number that is not zero. */
function ldexp(x, n) {
    for (; n > 1023; n -= 1023) x *= 8.98846567431158e307;
    for (; n < -1022; n += 969) x *= 2.004168360008973e-292;
    return x * power_of_two(n);
}

function is_negative(x) {
    return x < 0 || Object.is(x, -0);
}

function copysign(x, y) {
    return is_negative(x) === is_negative(y) ? x : -x;
}

function exp2(x) {
    return 2 ** x;
}

function fused(a, b, c) {
    return a * b + c;
}

function pair(hi, lo) {
    return { hi, lo };
}

function copy(to, from, count) {
    for (let k = 0; k < count; k++) to[k] = from[k];
}

/** Copy all of a struct. */
function assign(to, from) {
    for (const name in from) {
        if (typeof to[name] === "object" && !("hi" in from[name])) assign(to[name], from[name]);
        else to[name] = from[name];
    }
    return to;
}

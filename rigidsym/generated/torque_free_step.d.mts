// Types of torque_free_step.mjs, by `rigidsym codegen javascript --form step`.

/** A double-double, the sum hi + lo. */
export interface Pair {
    readonly hi: number;
    readonly lo: number;
}

/** What the module takes for granted, to be set before it is used. */
export const settings: {
    /** Accept moments of inertia that no body can have. */
    ALLOW_NONPHYSICAL: boolean;
};

/** A state: q, unit, scalar first, body to inertial, and omega, body rates in rad/s. */
export interface State {
    q: Float64Array;
    omega: Float64Array;
}

/** A refused input: `code`, the `field` that it is about, and the `rule` that it breaks. */
export class RefusedError extends RangeError {
    readonly code: number;
    readonly field: string;
    readonly rule: string;
    constructor(code: number);
}

/** A torque-free rigid body; invalid inputs throw a RefusedError or a TypeError. */
export class TorqueFreeBody {
    /** inertia: principal moments, kg m^2. */
    constructor(inertia: ArrayLike<number>);

    /** The state after dt (s), of a quaternion q of any length but zero and rates omega (rad/s). */
    step(q: ArrayLike<number>, omega: ArrayLike<number>, dt: number): State;
}

export const OK: number;
export const NOT_FINITE: number;
export const INERTIA: number;
export const THIN: number;
export const ATTITUDE: number;
export const ANGLE: number;
export const ARITHMETIC: number;
export const NONPHYSICAL: number;
export const UNPREPARED: number;

/* The constants of a body; written by body_init, read by step. */
export interface body {
    /** by moments of inertia, the largest first */
    axis: number[];
    /** a mark that body_init has written the struct */
    prepared: number;
    /** 1, or -1 where the axes in this order are left-handed */
    epsilon: number;
    /** in this order, in inner units */
    moments: number[];
    /** the coefficients of Euler's equations */
    alphas: Pair[];
    /** their products */
    squares: Pair[];
}
export function new_body(): body;

/**
 * Compute the constants of a body; return a code.
 *
 * inertia: principal moments about the body axes, kg m^2, positive. A call that fails writes
 * nothing.
 */
export function body_init(body: body, inertia: ArrayLike<number>): number;

/**
 * Compute the free motion after dt (s), in place; return a code.
 *
 * q, scalar first, body to inertial, of any length but zero, becomes a unit quaternion, continuous
 * in the double cover; omega: body rates in rad/s. A call that fails writes nothing.
 */
export function step(body: body, q: Float64Array, omega: Float64Array, dt: number): number;

/**
 * Compute one step of each of n bodies; return a code and a body.
 *
 * q[n][4] and omega[n][3] go to q_after[n][4] and omega_after[n][3], which may be q and omega
 * themselves, and overlap nothing else. Body k has the moments at inertia + k inertia_stride and
 * the time dt[k dt_stride]: strides are 3 and 1, or 0 where all have the same. The first body that
 * is refused ends the call: its code and its number are returned, and the bodies before it are
 * done.
 */
export function steps(n: number, inertia: Float64Array, inertia_stride: number, q: Float64Array,
    omega: Float64Array, dt: Float64Array, dt_stride: number, q_after: Float64Array,
    omega_after: Float64Array): [number, number];

/**
 * The message of a code, in one line: the field and its rule.
 */
export function message(code: number): string;

/**
 * The field of the input that a code is about, "" for none.
 */
export function field(code: number): string;

/**
 * The rule of the input that a code says is broken.
 */
export function rule(code: number): string;

/**
 * The digest of the header and the source, for callers of a shared library.
 */
export function digest(): string;

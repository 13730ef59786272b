// Types of torque_free.mjs, by `rigidsym codegen javascript`.

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

/** The motion of a torque-free rigid body; invalid inputs throw a RefusedError or a TypeError. */
export class TorqueFreeMotion {
    /** The largest |t| (s) with a state. */
    readonly lastTime: number;

    /** inertia: principal moments (kg m^2); omega0: rad/s; attitude0: 1, 0, 0, 0 by default. */
    constructor(
        inertia: ArrayLike<number>,
        omega0: ArrayLike<number>,
        attitude0?: ArrayLike<number>,
    );

    /** The state at t (s). */
    at(t: number): State;

    /** The states at times (s): q has four and omega three numbers for each. */
    states(times: ArrayLike<number>): State;
}

export const OK: number;
export const NOT_FINITE: number;
export const INERTIA: number;
export const THIN: number;
export const ATTITUDE: number;
export const SEPARATRIX: number;
export const TIME: number;
export const RATES: number;
export const ARITHMETIC: number;
export const GROWTH: number;
export const NONPHYSICAL: number;
export const UNPREPARED: number;

export interface circular {
    v_rate_hi: number;
    v_rate_lo: number;
    v_hi: number;
    v_lo: number;
    Lambda_rate_hi: number;
    Lambda_rate_lo: number;
    T4_re_0: number;
    T4_re_1: number;
    T4_re_2: number;
    T4_re_3: number;
    T4_im_0: number;
    T4_im_1: number;
    T4_im_2: number;
    T1_re_0: number;
    T1_re_1: number;
    T1_re_2: number;
    T1_re_3: number;
    T1_im_0: number;
    T1_im_1: number;
    T1_im_2: number;
    T1_im_3: number;
    even_0: number;
    even_1: number;
    even_2: number;
    odd_0: number;
    odd_1: number;
    sine_even_0: number;
    sine_even_1: number;
    sine_even_2: number;
    sine_odd_0: number;
    sine_odd_1: number;
    row_0_P4_re: number;
    row_0_P4_im: number;
    row_0_P1_re: number;
    row_0_P1_im: number;
    row_a_P4_re: number;
    row_a_P4_im: number;
    row_a_P1_re: number;
    row_a_P1_im: number;
    row_b_P4_re: number;
    row_b_P4_im: number;
    row_b_P1_re: number;
    row_b_P1_im: number;
    row_d_P4_re: number;
    row_d_P4_im: number;
    row_d_P1_re: number;
    row_d_P1_im: number;
    gain_a: number;
    gain_b: number;
    gain_d: number;
}
export function new_circular(): circular;

export interface hyperbolic {
    y_rate_hi: number;
    y_rate_lo: number;
    y0_hi: number;
    y0_lo: number;
    period_hi: number;
    period_lo: number;
    Lambda_rate_hi: number;
    Lambda_rate_lo: number;
    jump_hi: number;
    jump_lo: number;
    period_far: number;
    period_inverse: number;
    re_0: number;
    re_1: number;
    re_2: number;
    re_3: number;
    im_0: number;
    im_1: number;
    im_2: number;
    im_3: number;
    nome: number;
    nome2: number;
    nome4: number;
    nome8: number;
    nome12: number;
    row_0_P4_re: number;
    row_0_P4_im: number;
    row_0_P1_re: number;
    row_0_P1_im: number;
    row_a_P4_re: number;
    row_a_P4_im: number;
    row_a_P1_re: number;
    row_a_P1_im: number;
    row_b_P4_re: number;
    row_b_P4_im: number;
    row_b_P1_re: number;
    row_b_P1_im: number;
    row_d_P4_re: number;
    row_d_P4_im: number;
    row_d_P1_re: number;
    row_d_P1_im: number;
    gain_a: number;
    gain_b: number;
    gain_d: number;
}
export function new_hyperbolic(): hyperbolic;

export interface steady {
    Lambda_rate_hi: number;
    Lambda_rate_lo: number;
    axis1: number;
    axis2: number;
    axis3: number;
    p0: number;
    p1: number;
    p2: number;
    p3: number;
}
export function new_steady(): steady;

/* The constants of one motion; written by motion_init, read by all others. */
export interface motion {
    /** 0 steady, 1 circular, 2 hyperbolic */
    branch: number;
    /** the body axes a, b, d */
    axis: number[];
    /** later times are refused as SEPARATRIX */
    is_blurred: boolean;
    /** a mark that motion_init has written the struct */
    prepared: number;
    /** a power of two, 1/s: inner times are unit t; 0 at rest */
    unit: number;
    /** the largest inner time */
    max_angle: number;
    /** attitude at t = 0 */
    q0: number[];
    /** body rates at t = 0, rad/s */
    omega0: number[];
    of: { circular: circular; hyperbolic: hyperbolic; steady: steady };
}
export function new_motion(): motion;

/**
 * Compute the constants of a motion; return a code.
 *
 * inertia: principal moments about the body axes, kg m^2, positive; omega0: body rates at t = 0,
 * rad/s; attitude0: quaternion at t = 0, scalar first, body to inertial, of any length but zero. A
 * call that fails writes nothing.
 */
export function motion_init(motion: motion, inertia: ArrayLike<number>, omega0: ArrayLike<number>,
    attitude0: ArrayLike<number>): number;

/**
 * Compute the constants of a motion from numbers known beyond binary64; return a code.
 *
 * Each number is the sum of two doubles {hi, lo}. The largest moment and the largest rate should be
 * between 1/2 and 4. Numbers that pairs would lose by subtraction are arguments, right to all
 * digits of a pair: differences, moments 0 less 1, 1 less 2 and 2 less 0, and discriminant, K^2 - 2
 * H c_b, b the middle axis, whose sign decides the regime. Rates are times `unit` rad/s, a power of
 * two. A call that fails writes nothing.
 */
export function motion_init_double_doubles(motion: motion, inertia: ArrayLike<ArrayLike<number>>,
    differences: ArrayLike<ArrayLike<number>>, omega0: ArrayLike<ArrayLike<number>>,
    attitude0: ArrayLike<ArrayLike<number>>, discriminant: ArrayLike<number>, unit: number): number;

/**
 * Compute the state at the time t + t_lo (s); return a code as state_at does.
 *
 * The time is the exact sum of two numbers, and t_lo is at most half a unit in the last place of t:
 * so times far from 0 are as near to each other as times about 0.
 */
export function state_at_sum(motion: motion, t: number, t_lo: number, q: Float64Array,
    omega: Float64Array): number;

/**
 * Compute the state at time t (s); return a code.
 *
 * q: a unit quaternion, body to inertial, continuous in the double cover from attitude0 on; omega:
 * body rates in rad/s. The code is OK, NOT_FINITE, TIME, SEPARATRIX or, as in all functions below,
 * UNPREPARED.
 */
export function state_at(motion: motion, t: number, q: Float64Array, omega: Float64Array): number;

/**
 * Compute the states at n times t[n] (s), in any order; return a code as state_at does.
 *
 * q[n][4] and omega[n][3] are written row by row, and overlap neither each other nor t.
 */
export function states_at(motion: motion, n: number, t: Float64Array, q: Float64Array,
    omega: Float64Array): number;

/**
 * Compute a motion and n states for each of many bodies; return a code and a body.
 *
 * inertia[bodies][3], omega0[bodies][3], attitude0[bodies][4] and t[n] go to q[bodies][n][4] and
 * omega[bodies][n][3], none of which overlap. Times of body k are t[k stride], t[k stride + 1],
 * ...: stride is 0 where all have the same, n where t is t[bodies][n]. codes[bodies]: the code of
 * each body; refused bodies and times have states of NaN, and OK is returned. Without codes, the
 * first body that is refused ends the call: its code and its number are returned, and the states of
 * the bodies before it are written.
 */
export function propagate(bodies: number, inertia: Float64Array, omega0: Float64Array,
    attitude0: Float64Array, n: number, t: Float64Array, stride: number, q: Float64Array,
    omega: Float64Array, codes: Int32Array | null): [number, number];

/**
 * Return the largest |t| (s) that a motion has states for; NaN where it was not prepared.
 */
export function last_time(motion: motion): number;

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

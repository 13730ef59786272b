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

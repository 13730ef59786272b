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

/** A torque-free rigid body; invalid inputs throw a RefusedError or a TypeError. */
export class TorqueFreeBody {
    /** inertia: principal moments, kg m^2. */
    constructor(inertia: ArrayLike<number>);

    /** The state after dt (s), of a quaternion q of any length but zero and rates omega (rad/s). */
    step(q: ArrayLike<number>, omega: ArrayLike<number>, dt: number): State;
}

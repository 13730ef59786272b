/** A torque-free rigid body, whose states are advanced by steps of any length. */
export class TorqueFreeBody {
    #body = new_body();

    constructor(inertia) {
        accept(body_init(this.#body, numbers("inertia", inertia, 3)));
    }

    /** The state after dt (s): q, unit, scalar first, body to inertial, and omega in rad/s. */
    step(q, omega, dt) {
        const after = { q: numbers("q", q, 4), omega: numbers("omega", omega, 3) };
        accept(step(this.#body, after.q, after.omega, numbers("dt", [dt], 1)[0]));
        return after;
    }
}

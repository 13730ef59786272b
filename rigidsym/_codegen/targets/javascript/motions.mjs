/** The motion of a torque-free rigid body. */
export class TorqueFreeMotion {
    #motion = new_motion();

    constructor(inertia, omega0, attitude0 = [1, 0, 0, 0]) {
        const given = [numbers("inertia", inertia, 3), numbers("omega0", omega0, 3)];
        accept(motion_init(this.#motion, ...given, numbers("attitude0", attitude0, 4)));
    }

    /** The largest |t| (s) with a state. */
    get lastTime() {
        return last_time(this.#motion);
    }

    /** The state at t (s): q, unit, scalar first, body to inertial, and omega, body rates in rad/s. */
    at(t) {
        return this.states([t]);
    }

    /** The states at times (s): q with four and omega with three numbers for each. */
    states(times) {
        const t = numbers("times", times);
        const [q, omega] = [new Float64Array(4 * t.length), new Float64Array(3 * t.length)];
        accept(states_at(this.#motion, t.length, t, q, omega));
        return { q, omega };
    }
}

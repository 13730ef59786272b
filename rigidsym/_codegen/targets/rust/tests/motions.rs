//! Motions in all regimes: their states have the bits of other targets, and keep what is constant.

use NAME::{motion_init, state_at, states_at};

/// Moments, rates, attitude, the time of a step, and times, as bits; `= hash` begins a stratum.
const MOTIONS: &str = include_str!("motions.txt");

#[test]
fn states_have_their_bits_and_keep_the_momentum() {
    let (mut wanted, mut hash) = ("-", 0);
    for line in MOTIONS.lines().chain(["= -"]) {
        if let Some(next) = line.strip_prefix("= ") {
            assert!(wanted == "-" || format!("{hash:016x}") == wanted);
            (wanted, hash) = (next, 0);
            continue;
        }
        let bits = line.split(' ').map(|x| u64::from_str_radix(x, 16).unwrap());
        let x: Vec<f64> = bits.map(f64::from_bits).collect();
        let (c, omega0, q0) = (first(&x), first(&x[3..]), first(&x[6..]));
        let (t, n) = (&x[11..], x.len() - 11);
        let motion = motion_init(&c, &omega0, &q0).unwrap();
        let (mut q, mut omega) = (vec![0.0; 4 * n], vec![0.0; 3 * n]);
        states_at(&motion, n, t, &mut q, &mut omega).unwrap();
        let begun = momentum(&c, &omega0, &q0, &omega0);
        for k in 0..n {
            let (turn, rates) = (first(&q[4 * k..]), first(&omega[3 * k..]));
            let now = momentum(&c, &rates, &turn, &omega0);
            let far = (0..3).fold(0.0, |most: f64, j| most.max((now[j] - begun[j]).abs()));
            assert!(far <= 1e-13, "{far} in {line}");
        }
        for number in q.iter().chain(&omega) {
            let next = (hash ^ number.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            hash = next ^ next >> 32;
        }
    }
}

#[test]
fn bad_input_is_refused_by_name() {
    let refusal = motion_init(&[1.0, 0.0, 1.0], &[0.0; 3], &[1.0, 0.0, 0.0, 0.0]).unwrap_err();
    assert_eq!(refusal, NAME::Refusal::Inertia);
    assert_eq!(refusal.field(), "inertia");
    let motion = motion_init(&[1.0, 2.0, 2.5], &[1.0; 3], &[1.0, 0.0, 0.0, 0.0]).unwrap();
    let found = state_at(&motion, 1e300, &mut [0.0; 4], &mut [0.0; 3]);
    assert_eq!(found, Err(NAME::Refusal::Time));
}

fn first<const N: usize>(given: &[f64]) -> [f64; N] {
    given[..N].try_into().unwrap()
}

/// The angular momentum in inertial axes, as a share of its size at the rates `omega0`.
fn momentum(c: &[f64; 3], omega: &[f64; 3], q: &[f64; 4], omega0: &[f64; 3]) -> [f64; 3] {
    let largest = |x: &[f64]| x.iter().fold(0.0, |most: f64, y| most.max(y.abs()));
    let (most, fast, long) = (largest(c), largest(omega0).max(f64::MIN_POSITIVE), largest(q));
    let at = |rates: &[f64; 3], k: usize| c[k] / most * (rates[k] / fast);
    let size = (0..3).map(|k| at(omega0, k).powi(2)).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    let (l, u) = ([0, 1, 2].map(|k| at(omega, k) / size), q.map(|x| x / long));
    let square: f64 = u.iter().map(|x| x * x).sum();
    let cross = |x: [f64; 3]| [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        u[1 + i] * x[j] - u[1 + j] * x[i]
    });
    let (one, two) = (cross(l), cross(cross(l)));
    [0, 1, 2].map(|k| l[k] + 2.0 * (u[0] * one[k] + two[k]) / square)
}

//! Steps of bodies in all regimes have the bits of other targets.

use NAME::{body_init, step};

/// Moments, rates, attitude, the time of a step, and times, as bits; `= hash` begins a stratum.
const MOTIONS: &str = include_str!("motions.txt");

#[test]
fn steps_have_their_bits() {
    let (mut wanted, mut hash) = ("0000000000000000", 0);
    for line in MOTIONS.lines().chain(["= -"]) {
        if let Some(next) = line.strip_prefix("= ") {
            assert_eq!(format!("{hash:016x}"), wanted);
            (wanted, hash) = (next, 0);
            continue;
        }
        let bits = line.split(' ').map(|x| u64::from_str_radix(x, 16).unwrap());
        let x: Vec<f64> = bits.map(f64::from_bits).collect();
        let body = body_init(&x[..3].try_into().unwrap()).unwrap();
        let mut omega: [f64; 3] = x[3..6].try_into().unwrap();
        let mut q: [f64; 4] = x[6..10].try_into().unwrap();
        step(&body, &mut q, &mut omega, x[10]).unwrap();
        for number in q.iter().chain(&omega) {
            let next = (hash ^ number.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            hash = next ^ next >> 32;
        }
    }
}

#[test]
fn bad_input_is_refused_by_name() {
    let refusal = body_init(&[1.0, 0.0, 1.0]).unwrap_err();
    assert_eq!(refusal, NAME::Refusal::Inertia);
    assert_eq!(refusal.field(), "inertia");
    let body = body_init(&[1.0, 2.0, 2.5]).unwrap();
    let found = step(&body, &mut [1.0, 0.0, 0.0, 0.0], &mut [9.0; 3], 1.0);
    assert_eq!(found, Err(NAME::Refusal::Angle));
}

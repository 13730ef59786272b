// Answers the questions of `rigidsym._engines.piped` by a crate of torque-free motion.
use std::io::{stdin, stdout, Read, Write};
use torque_free::{refused, Refusal};

fn read(count: usize) -> Vec<f64> {
    let mut bytes = vec![0; 8 * count];
    if stdin().read_exact(&mut bytes).is_err() {
        std::process::exit(0);
    }
    let numbers = bytes.chunks_exact(8).map(|x| f64::from_ne_bytes(x.try_into().unwrap()));
    numbers.collect()
}

fn write(parts: &[Vec<f64>]) {
    let bytes: Vec<u8> = parts.iter().flatten().flat_map(|x| x.to_ne_bytes()).collect();
    let done = stdout().write_all(&bytes).and_then(|_| stdout().flush());
    done.expect("nobody reads the answer");
}

/// Return code, body, last time, q and omega.
#[cfg(not(steps))]
fn answer(kind: usize, bodies: usize, n: usize, stride: usize, lenient: bool) -> [Vec<f64>; 3] {
    use torque_free::*;
    let (mut q, mut omega) = (vec![0.0; 4 * n * bodies], vec![0.0; 3 * n * bodies]);
    let (found, motion) = if kind == 0 {
        let (c, rates, turn) = (read(3 * bodies), read(3 * bodies), read(4 * bodies));
        let t = read(if stride == 0 { n } else { n * bodies });
        let mut codes = vec![0; if lenient { bodies } else { 0 }];
        let found = propagate(
            bodies, &c, &rates, &turn, n, &t, stride, &mut q, &mut omega, &mut codes,
        );
        (found, motion_init(&first(&c), &first(&rates), &first(&turn)))
    } else {
        let (c, apart, rates, turn) = (pairs(), pairs(), pairs(), pairs());
        let (known, unit, t) = (first(&read(2)), read(1)[0], read(n));
        let motion = motion_init_double_doubles(&c, &apart, &rates, &turn, &known, unit);
        let found = motion.and_then(|one| states_at(&one, n, &t, &mut q, &mut omega));
        (found.map_err(|refusal| (refusal, 0)), motion)
    };
    let (code, body) = found.err().map_or((0, 0), |(refusal, k)| (refusal as i32, k));
    let last = motion.map_or(f64::NAN, |one| last_time(&one));
    [vec![code.into(), body as f64, last], q, omega]
}

#[cfg(not(steps))]
fn first<const N: usize>(given: &[f64]) -> [f64; N] {
    given[..N].try_into().unwrap()
}

#[cfg(not(steps))]
fn pairs<const N: usize>() -> [[f64; 2]; N] {
    [(); N].map(|_| first(&read(2)))
}

#[cfg(steps)]
fn answer(_kind: usize, bodies: usize, _n: usize, _stride: usize, _lenient: bool) -> [Vec<f64>; 3] {
    let (c, q, omega) = (read(3 * bodies), read(4 * bodies), read(3 * bodies));
    let (dt, mut turns, mut rates) = (read(bodies), q.clone(), omega.clone());
    let found =
        torque_free::steps(bodies, &c, 3, &q, &omega, &dt, 1, &mut turns, &mut rates);
    let (code, body) = found.err().map_or((0, 0), |(refusal, k)| (refusal as i32, k));
    [vec![code.into(), body as f64, 0.0], turns, rates]
}

fn main() {
    let words = |x: Refusal| format!("[{:?}, {:?}]", x.field(), x.rule());
    let known = (1..).map_while(|code| refused(code).err()).map(words);
    let all: Vec<String> = [r#"["", ""]"#.to_string()].into_iter().chain(known).collect();
    println!("[{}]", all.join(", "));
    loop {
        let asked: Vec<usize> = read(5).into_iter().map(|x| x as usize).collect();
        write(&answer(asked[0], asked[1], asked[2], asked[3], asked[4] != 0));
    }
}

/// A double-double, the sum hi + lo.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl Pair {
    const ZERO: Self = pair(0.0, 0.0);
}

#[inline]
pub(crate) const fn pair(hi: f64, lo: f64) -> Pair {
    Pair { hi, lo }
}

/// The first elements of a slice.
fn fixed<const N: usize>(slice: &[f64]) -> &[f64; N] {
    slice[..N].try_into().unwrap()
}

fn fixed_mut<const N: usize>(slice: &mut [f64]) -> &mut [f64; N] {
    (&mut slice[..N]).try_into().unwrap()
}

/// Accept moments of inertia that no body can have.
const ALLOW_NONPHYSICAL: bool = cfg!(feature = "allow-nonphysical");

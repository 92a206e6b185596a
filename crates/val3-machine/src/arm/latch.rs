//! Position latch of a fast input (9.2.3).

/// Latch that `setLatch` arms and that stores the position at the input's next rising edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Latch {
    input: u32,
    /// Whether the input was low since the latch was armed.
    was_low: bool,
    joint: Option<[f64; 6]>,
}

impl Latch {
    /// Arms a latch for an input, by link number.
    #[must_use]
    pub const fn armed(input: u32) -> Self {
        Self { input, was_low: false, joint: None }
    }

    /// Link number of the input.
    #[must_use]
    pub const fn input(&self) -> u32 {
        self.input
    }

    /// Position at the edge; `None` before the edge.
    #[must_use]
    pub const fn joint(&self) -> Option<[f64; 6]> {
        self.joint
    }

    /// Processes the input's state while the arm is at `joint`.
    pub fn see(&mut self, is_high: bool, joint: [f64; 6]) {
        if is_high && self.was_low && self.joint.is_none() {
            self.joint = Some(joint);
        }
        self.was_low |= !is_high;
    }
}

#[cfg(test)]
mod tests {
    use super::Latch;

    #[test]
    fn the_first_rising_edge_counts() {
        let mut latch = Latch::armed(7);
        for (is_high, j1, expected) in [
            (true, 1.0, None),
            (false, 2.0, None),
            (true, 3.0, Some(3.0)),
            (false, 4.0, Some(3.0)),
            (true, 5.0, Some(3.0)),
        ] {
            latch.see(is_high, [j1; 6]);
            assert_eq!(latch.joint(), expected.map(|j1| [j1; 6]));
        }
    }
}

//! Selection of tests for a shard, and the order of execution.

use std::str::FromStr;

/// One of several parts of all tests (`--shard`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Shard {
    /// Number of the part, from 0.
    part: usize,
    parts: usize,
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(part, parts)| Some((part.parse().ok()?, parts.parse().ok()?)));
        match numbers {
            Some((part @ 1.., parts)) if part <= parts => Ok(Self { part: part - 1, parts }),
            _ => Err("write the part and the number of parts, such as 2/3".to_owned()),
        }
    }
}

impl Shard {
    /// Returns for each test whether it belongs to the part. If the durations of the tests are known, each test,
    /// slowest first, is assigned to the part with the shortest total time so far.
    pub(super) fn part(self, seconds: &[Option<f64>]) -> Vec<bool> {
        let known: Option<Vec<f64>> = seconds.iter().copied().collect();
        let Some(known) = known.filter(|known| !known.is_empty()) else {
            return (0..seconds.len()).map(|number| number % self.parts == self.part).collect();
        };
        let mut order: Vec<usize> = (0..known.len()).collect();
        let of = |number: &usize| known.get(*number).copied().unwrap_or_default();
        // A stable sort has the same result on every machine.
        order.sort_by(|one, other| of(other).total_cmp(&of(one)));
        let mut sums = vec![0.0; self.parts];
        let mut is_here = vec![false; known.len()];
        for number in order {
            let least = (0..self.parts).min_by(|one, other| sum(&sums, *one).total_cmp(&sum(&sums, *other)));
            let Some(part) = least else { continue };
            if let Some(sum) = sums.get_mut(part) {
                *sum += of(&number);
            }
            if let Some(is_here) = is_here.get_mut(number) {
                *is_here = part == self.part;
            }
        }
        is_here
    }
}

fn sum(sums: &[f64], part: usize) -> f64 {
    sums.get(part).copied().unwrap_or_default()
}

/// Numbers from 0 to `count - 1` in an order that depends on the seed.
pub(super) fn shuffled(count: usize, seed: u64) -> Vec<usize> {
    let key = |number: usize| mixed(seed.wrapping_add(mixed(number as u64)));
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|number| (key(*number), *number));
    order
}

/// Hash in which each bit of the result depends on each bit of `number` (splitmix64).
fn mixed(number: u64) -> u64 {
    let number = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let number = (number ^ (number >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let number = (number ^ (number >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    number ^ (number >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_test_belongs_to_one_shard() {
        let shards: Vec<Shard> = ["1/3", "2/3", "3/3"].map(|text| text.parse().unwrap()).into();
        for seconds in [vec![None; 10], (0..10).map(|number| Some(f64::from(number % 4))).collect()] {
            let parts: Vec<Vec<bool>> = shards.iter().map(|shard| shard.part(&seconds)).collect();
            for number in 0..10 {
                assert_eq!(parts.iter().filter(|part| part[number]).count(), 1);
            }
        }
        for wrong in ["0/3", "4/3", "1", "a/b", "1/0", ""] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn parts_take_the_same_time() {
        let seconds = [1.0, 9.0, 1.0, 3.0, 3.0, 1.0].map(Some);
        let part = |text: &str| text.parse::<Shard>().unwrap().part(&seconds);
        assert_eq!(part("1/2"), [false, true, false, false, false, false]);
        assert_eq!(part("2/2"), [true, false, true, true, true, true]);
    }

    #[test]
    fn a_seed_decides_the_order() {
        let (one, other) = (shuffled(50, 1), shuffled(50, 2));
        assert_eq!(one, shuffled(50, 1));
        assert_ne!(one, other);
        let mut sorted = one;
        sorted.sort_unstable();
        assert_eq!(sorted, (0..50).collect::<Vec<_>>());
    }
}

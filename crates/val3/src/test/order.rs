//! The tests that are executed, and their order.

use std::str::FromStr;

/// One of several parts of all tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Shard {
    /// From 0.
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
    /// Whether the test with this number belongs to the part.
    pub(super) fn has(self, number: usize) -> bool {
        number % self.parts == self.part
    }
}

/// The numbers from 0 in the order that a seed decides.
pub(super) fn shuffled(count: usize, seed: u64) -> Vec<usize> {
    let key = |number: usize| mixed(seed.wrapping_add(mixed(number as u64)));
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|number| (key(*number), *number));
    order
}

/// Each bit of the result depends on each bit of `number` (splitmix64).
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
        for number in 0..10 {
            assert_eq!(shards.iter().filter(|shard| shard.has(number)).count(), 1);
        }
        for wrong in ["0/3", "4/3", "1", "a/b", "1/0", ""] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
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

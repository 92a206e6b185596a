//! The name a person probably meant.

use smol_str::SmolStr;

/// The candidate most similar to `name`, if one is similar enough to be proposed.
pub fn nearest<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<SmolStr> {
    let lower = name.to_lowercase();
    let limit = (name.chars().count() / 3).clamp(1, 3);
    let letters = letters(&lower);
    candidates
        .filter(|candidate| *candidate != name && !candidate.is_empty())
        // Two names this near each other differ in at most twice as many letters; far faster than the distance.
        .filter(|candidate| candidate.len().abs_diff(name.len()) <= 4 * limit)
        .filter(|candidate| (letters ^ self::letters(candidate)).count_ones() as usize <= 2 * limit)
        .filter_map(|candidate| {
            let distance = strsim::osa_distance(&lower, &candidate.to_lowercase());
            (distance <= limit).then_some((distance, candidate))
        })
        .min_by(|a, b| a.cmp(b))
        .map(|(_, candidate)| candidate.into())
}

/// Which letters occur, as a set of bits, whatever their case.
fn letters(name: &str) -> u64 {
    name.bytes().fold(0, |set, byte| set | 1 << (byte.to_ascii_lowercase() % 64))
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_misspelt_name_is_found() {
        let names = ["nCount", "nCounter", "pPick", "sName"];
        let near = |name: &str| nearest(name, names.into_iter()).map(String::from);
        assert_eq!(near("nCuont").as_deref(), Some("nCount"));
        assert_eq!(near("ncount").as_deref(), Some("nCount"));
        assert_eq!(near("pPic").as_deref(), Some("pPick"));
        assert_eq!(near("fTray"), None);
    }
}

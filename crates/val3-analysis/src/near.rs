//! The name a person probably meant.

use smol_str::SmolStr;

/// The candidate most similar to `name`, if one is similar enough to be proposed.
pub fn nearest<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<SmolStr> {
    let lower = name.to_lowercase();
    let limit = (name.chars().count() / 3).clamp(1, 3);
    candidates
        .filter(|candidate| *candidate != name && !candidate.is_empty())
        .filter_map(|candidate| {
            let distance = strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
            (distance <= limit).then_some((distance, candidate))
        })
        .min_by(|a, b| a.cmp(b))
        .map(|(_, candidate)| candidate.into())
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn slips_are_found() {
        let names = ["nCount", "nCounter", "pPick", "sName"];
        let near = |name: &str| nearest(name, names.into_iter()).map(String::from);
        assert_eq!(near("nCuont").as_deref(), Some("nCount"));
        assert_eq!(near("ncount").as_deref(), Some("nCount"));
        assert_eq!(near("pPic").as_deref(), Some("pPick"));
        assert_eq!(near("fTray"), None);
    }
}

//! Suggestions for misspelled names in programs, configurations, settings and command lines.

/// Returns the candidate that is most similar to `name`, if it is similar enough. Among equally similar candidates, the
/// first in alphabetical order is returned.
pub fn nearest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    similar(name, candidates).min().map(|(_, candidate)| candidate)
}

/// Returns the candidates for a word that the user has mistyped: the most similar ones. A candidate with the prefix
/// `word` counts as one edit. At most three, in alphabetical order.
pub fn proposals<'c>(word: &str, candidates: impl IntoIterator<Item = &'c str>) -> Vec<&'c str> {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let begun = candidates.iter().copied().filter(|candidate| is_beginning(word, candidate));
    let mut found: Vec<(usize, &str)> = begun.map(|candidate| (1, candidate)).collect();
    found.extend(similar(word, candidates));
    found.sort_unstable();
    found.dedup();
    let least = found.first().map(|(distance, _)| *distance);
    found.into_iter().take_while(|(distance, _)| Some(*distance) == least).map(|(_, found)| found).take(3).collect()
}

/// Formats the question that suggests names; `None` without names.
pub fn question<'c>(names: impl IntoIterator<Item = &'c str>) -> Option<String> {
    let quoted: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    (!quoted.is_empty()).then(|| format!("did you mean {}?", quoted.join(", ")))
}

/// Candidates that are similar enough, with the edit distance: missing, added, changed or swapped letters. The limit is
/// a third of the letters, at least one and at most three. Upper and lower case, and `_` and `-`, count as equal.
fn similar<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> impl Iterator<Item = (usize, &'c str)> {
    let (own, limit) = (name.to_owned(), (name.chars().count() / 3).clamp(1, 3));
    let folded = folded(name);
    let letters = letters(&folded);
    let named = candidates.into_iter().filter(move |candidate| !candidate.is_empty() && *candidate != own);
    named.filter_map(move |candidate| {
        let candidate_folded = self::folded(candidate);
        // Cheap test before the distance: similar names differ in at most twice as many letters.
        let may_be_similar = candidate_folded.len().abs_diff(folded.len()) <= 4 * limit
            && (letters ^ self::letters(&candidate_folded)).count_ones() as usize <= 2 * limit;
        let distance = may_be_similar.then(|| strsim::osa_distance(&folded, &candidate_folded))?;
        (distance <= limit).then_some((distance, candidate))
    })
}

fn is_beginning(word: &str, candidate: &str) -> bool {
    word.len() >= 3 && candidate.len() > word.len() && folded(candidate).starts_with(&folded(word))
}

fn folded(name: &str) -> String {
    name.to_lowercase().replace('_', "-")
}

/// Set of the letters in a name, as bits.
fn letters(name: &str) -> u64 {
    name.bytes().fold(0, |set, byte| set | 1 << (byte % 64))
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 4] = ["nCount", "nCounter", "pPick", "sName"];

    fn near(name: &str) -> Option<&'static str> {
        nearest(name, NAMES)
    }

    #[test]
    fn slips_are_found() {
        assert_eq!(near("nCuont"), Some("nCount"));
        assert_eq!(near("pPic"), Some("pPick"));
        assert_eq!(near("fTray"), None);
        assert_eq!(near("nCount"), Some("nCounter"), "never the name itself");
        assert_eq!(nearest("é", ["è"]), Some("è"));
    }

    #[test]
    fn a_third_of_the_letters_may_be_slips() {
        assert_eq!(nearest("abcde", ["abcxx"]), None);
        assert_eq!(nearest("abcdef", ["abcdxx"]), Some("abcdxx"));
        assert_eq!(nearest("abcdefghijkl", ["abcdefghixxx"]), Some("abcdefghixxx"));
        assert_eq!(nearest("abcdefghijkl", ["abcdefghxxxx"]), None);
        assert_eq!(nearest("n", ["m", "nn", "mm"]), Some("m"));
    }

    #[test]
    fn letter_case_and_underscores_do_not_count() {
        assert_eq!(near("NCOUNT"), Some("nCount"));
        assert_eq!(nearest("line_length", ["line-length"]), Some("line-length"));
    }

    #[test]
    fn only_the_most_similar_words_are_proposed() {
        let words = ["movej", "movel", "movec", "open"];
        assert_eq!(proposals("moveji", words), ["movej"]);
        assert_eq!(proposals("OPEN", words), ["open"]);
        assert_eq!(proposals("movek", words), ["movec", "movej", "movel"]);
        assert!(proposals("taskCreate", words).is_empty());
    }

    #[test]
    fn a_beginning_is_enough() {
        assert_eq!(proposals("task", ["taskCreateSync", "taskKill"]), ["taskCreateSync", "taskKill"]);
        assert!(proposals("ta", ["taskKill"]).is_empty());
    }

    #[test]
    fn the_question_quotes() {
        assert_eq!(question(["a", "b"]).as_deref(), Some("did you mean `a`, `b`?"));
        assert_eq!(question(Some("a")).as_deref(), Some("did you mean `a`?"));
        assert_eq!(question(None), None);
    }
}

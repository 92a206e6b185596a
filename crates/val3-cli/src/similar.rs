//! Proposals for unknown words.

/// The candidates nearest to `word`, if they are similar enough; at most three, in alphabetical order.
pub(crate) fn similar<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let word = word.to_lowercase();
    let mut near: Vec<(usize, &str)> = candidates
        .into_iter()
        .map(|candidate| (distance(&word, &candidate.to_lowercase()), candidate))
        .filter(|(distance, _)| *distance <= tolerance(&word))
        .collect();
    near.sort_unstable();
    near.dedup();
    let nearest = near.first().map(|(distance, _)| *distance);
    near.retain(|(distance, _)| Some(*distance) == nearest);
    near.into_iter().map(|(_, candidate)| candidate).take(3).collect()
}

/// The question that proposes words; `None` without words.
pub(crate) fn question(words: &[&str]) -> Option<String> {
    let quoted: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
    (!quoted.is_empty()).then(|| format!("did you mean {}?", quoted.join(", ")))
}

fn distance(word: &str, candidate: &str) -> usize {
    // A candidate that begins with the word is the best guess for an incomplete word.
    let begun = word.len() >= 3 && candidate.starts_with(word);
    if begun { 1 } else { strsim::damerau_levenshtein(word, candidate) }
}

/// How many slips are likely in a word of this length.
fn tolerance(word: &str) -> usize {
    match word.chars().count() {
        0..=3 => 1,
        4..=8 => 2,
        _ => 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_most_similar_words_are_proposed() {
        let words = ["movej", "movel", "movec", "open"];
        assert_eq!(similar("moveji", words), ["movej"]);
        assert_eq!(similar("OPEN", words), ["open"]);
        assert!(similar("taskCreate", words).is_empty());
    }

    #[test]
    fn the_beginning_of_a_word_is_enough() {
        assert_eq!(similar("task", ["taskCreateSync", "taskKill"]), ["taskCreateSync", "taskKill"]);
    }

    #[test]
    fn the_question_quotes_the_words() {
        assert_eq!(question(&["a", "b"]).as_deref(), Some("did you mean `a`, `b`?"));
        assert_eq!(question(&[]), None);
    }
}

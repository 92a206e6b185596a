//! Fuzzy matching of typed letters with a name.

/// Score of a match, higher for a better match; `None` if the name does not contain the letters in this order. Either
/// the first letter must begin a word of the name, or at least three letters must match consecutively. Letter case only
/// affects the score.
pub(crate) fn score(query: &str, name: &str) -> Option<i32> {
    let letters: Vec<char> = query.chars().filter(|letter| !letter.is_whitespace()).collect();
    let Some(first) = letters.first() else { return Some(0) };
    let name: Vec<char> = name.chars().collect();
    let starts = (0..name.len()).filter(|&at| name.get(at).is_some_and(|found| found.eq_ignore_ascii_case(first)));
    starts.filter_map(|start| score_from(&letters, &name, start)).max()
}

/// Score if the first letter matches at `start`.
fn score_from(letters: &[char], name: &[char], start: usize) -> Option<i32> {
    let mut wanted = letters.iter().copied().peekable();
    let (mut score, mut run, mut in_a_row) = (0, false, true);
    for (at, found) in name.iter().copied().enumerate().skip(start) {
        let Some(letter) = wanted.peek().copied() else { break };
        let fits = letter.eq_ignore_ascii_case(&found);
        if fits {
            score += letter_score(letter, found, before(name, at), run);
            wanted.next();
        }
        in_a_row &= fits;
        run = fits;
    }
    let begins = name.get(start).is_some_and(|found| starts_word(before(name, start), *found));
    // If several names match equally well, the shortest is best.
    let length = i32::try_from(name.len()).unwrap_or(i32::MAX);
    (wanted.peek().is_none() && (begins || in_a_row && letters.len() > 2)).then_some(4 * score - length)
}

fn before(name: &[char], at: usize) -> Option<char> {
    at.checked_sub(1).and_then(|before| name.get(before)).copied()
}

fn starts_word(before: Option<char>, found: char) -> bool {
    before.is_none_or(|before| !before.is_alphanumeric() || !before.is_uppercase() && found.is_uppercase())
}

/// Score of a letter: higher at the start of the name or of a word, directly after the previous match, and in the same
/// case.
fn letter_score(wanted: char, found: char, before: Option<char>, run: bool) -> i32 {
    let mut score = 1;
    score += if before.is_none() { 8 } else { 0 };
    score += if starts_word(before, found) { 6 } else { 0 };
    score += if run { 8 } else { 0 };
    score + i32::from(wanted == found)
}

#[cfg(test)]
mod tests {
    use super::score;

    #[test]
    fn letters_must_appear_in_order() {
        assert!(score("ncnt", "nCount").is_some());
        assert!(score("", "nCount").is_some());
        assert!(score("tn", "nCount").is_none());
        assert!(score("unt", "nCount").is_some() && score("ut", "nCount").is_none());
        assert!(score("na", "toBinary").is_none() && score("ex", "$exec").is_some());
    }

    #[test]
    fn beginnings_and_consecutive_letters_score_higher() {
        let best = |query: &str, names: &[&'static str]| *names.iter().max_by_key(|name| score(query, name)).unwrap();
        assert_eq!(best("pick", &["nPickUp", "pick", "picker", "epsilonickp"]), "pick");
        assert_eq!(best("mj", &["momentj", "moveJ"]), "moveJ");
        assert_eq!(best("co", &["nCount", "accord"]), "nCount");
    }
}

//! How well a few typed letters fit a name.

/// A score, higher for a better fit; `None` where the letters do not stand in the name in this order. Letter case
/// makes no difference but for the score.
pub(crate) fn score(query: &str, name: &str) -> Option<i32> {
    if query.is_empty() {
        return Some(0);
    }
    let mut score = 0;
    let mut letters = query.chars().filter(|letter| !letter.is_whitespace()).peekable();
    let mut before: Option<char> = None;
    let mut run = false;
    for found in name.chars() {
        let Some(wanted) = letters.peek().copied() else { break };
        let fits = wanted.eq_ignore_ascii_case(&found);
        if fits {
            score += letter_score(wanted, found, before, run);
            letters.next();
        }
        run = fits;
        before = Some(found);
    }
    // Of names that fit alike the shortest is meant.
    let length = i32::try_from(name.len()).unwrap_or(i32::MAX);
    letters.peek().is_none().then_some(4 * score - length)
}

/// A letter counts more at the start of the name or of a word in it, behind the letter before, and in its own case.
fn letter_score(wanted: char, found: char, before: Option<char>, run: bool) -> i32 {
    let starts_word = before.is_none_or(|before| before == '_' || before.is_lowercase() && found.is_uppercase());
    let mut score = 1;
    score += if before.is_none() { 8 } else { 0 };
    score += if starts_word { 6 } else { 0 };
    score += if run { 5 } else { 0 };
    score + i32::from(wanted == found)
}

#[cfg(test)]
mod tests {
    use super::score;

    #[test]
    fn letters_in_order() {
        assert!(score("ncnt", "nCount").is_some());
        assert!(score("", "nCount").is_some());
        assert!(score("tn", "nCount").is_none());
    }

    #[test]
    fn starts_and_runs_come_first() {
        let best = |query: &str, names: &[&'static str]| *names.iter().max_by_key(|name| score(query, name)).unwrap();
        assert_eq!(best("pick", &["nPickUp", "pick", "picker", "epsilonickp"]), "pick");
        assert_eq!(best("mj", &["momentj", "moveJ"]), "moveJ");
        assert_eq!(best("co", &["nCount", "accord"]), "nCount");
    }
}

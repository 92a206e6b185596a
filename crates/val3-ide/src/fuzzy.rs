//! How well a few typed letters fit a name.

/// A score, higher for a better fit; `None` where the letters do not stand in the name in this order. The first letter
/// begins a word of the name, or three letters and more stand there in a row. Letter case makes no difference but for the score.
pub(crate) fn score(query: &str, name: &str) -> Option<i32> {
    let letters: Vec<char> = query.chars().filter(|letter| !letter.is_whitespace()).collect();
    let Some(first) = letters.first() else { return Some(0) };
    let name: Vec<char> = name.chars().collect();
    let starts = (0..name.len()).filter(|&at| name.get(at).is_some_and(|found| found.eq_ignore_ascii_case(first)));
    starts.filter_map(|start| score_from(&letters, &name, start)).max()
}

/// The score where the first letter is the one at `start`.
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
    // Of names that fit alike the shortest is meant.
    let length = i32::try_from(name.len()).unwrap_or(i32::MAX);
    (wanted.peek().is_none() && (begins || in_a_row && letters.len() > 2)).then_some(4 * score - length)
}

fn before(name: &[char], at: usize) -> Option<char> {
    at.checked_sub(1).and_then(|before| name.get(before)).copied()
}

fn starts_word(before: Option<char>, found: char) -> bool {
    before.is_none_or(|before| !before.is_alphanumeric() || !before.is_uppercase() && found.is_uppercase())
}

/// A letter scores more at the start of the name or of a word, directly after the previous letter, and in its own case.
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

//! Shortening of texts to a size limit.

/// Shortens the text to at most `limit` bytes of whole lines. If lines are omitted, the last line contains their number
/// and the hint.
pub(crate) fn cut(text: &str, limit: usize, hint: &str) -> String {
    if text.len() <= limit {
        return text.to_owned();
    }
    // Size without the last line.
    let room = limit.saturating_sub(hint.len() + 60);
    let fits = text.floor_char_boundary(room);
    let head = text.get(..fits).unwrap_or_default();
    let head = head.rfind('\n').and_then(|end| head.get(..end)).unwrap_or(head);
    let omitted = text.lines().count().saturating_sub(head.lines().count());
    // An open fence would include the last line and all following text.
    let fence = if head.lines().filter(|line| line.starts_with("```")).count() % 2 == 1 { "\n```" } else { "" };
    format!("{head}{fence}\n… {omitted} more lines: {hint}")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::cut;

    #[test]
    fn omitted_lines_are_counted_and_fences_closed() {
        assert_eq!(cut("a\nb", 10, "hint"), "a\nb");
        let text = format!("```\n{}", "line\n".repeat(100));
        let shown = cut(&text, 100, "more");
        assert!(shown.len() <= 100, "{shown}");
        assert!(shown.ends_with("line\n```\n… 94 more lines: more"), "{shown}");
    }

    proptest! {
        #[test]
        fn a_cut_text_is_never_longer_than_its_limit(text in "(?s).{0,400}", limit in 120_usize..300) {
            prop_assert!(cut(&text, limit, "a hint").len() <= limit);
        }
    }
}

//! V0714: a mark for unfinished work.

use val3_analysis::items::layout::comments;
use val3_syntax::{TextRange, TextSize, text_size};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A comment contains a word such as `todo` or `fixme`.
    ///
    /// ## Why
    /// Unfinished work should be completed before the cell is handed over. The option `task-words` lists the words;
    /// they are found as separate words in any letter case. The rule is off by default, because it enforces a
    /// convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// // todo: check the pressure
    /// putln("ready")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// // The pressure is checked by the safety controller
    /// putln("ready")
    /// ```
    V0714 "unfinished-mark" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for comment in comments(program.db, program.file) {
        let text = program.slice(comment);
        let marks = program.options.task_words.iter().filter_map(|mark| Some((find_word(text, mark)?, mark)));
        if let Some((at, mark)) = marks.min_by_key(|(at, _)| *at) {
            let start = comment.start() + text_size(at);
            let range = TextRange::at(start, TextSize::of(mark.as_str()));
            found.report(&RULE, range, word(program.slice(range)));
        }
    }
}

fn is_word_letter(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Position of `wanted` as a separate word, in upper or lower case.
fn find_word(text: &str, wanted: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let rest = text.get(from..)?;
        let start = from + rest.find(is_word_letter)?;
        let word = text.get(start..)?;
        let end = start + word.find(|letter| !is_word_letter(letter)).unwrap_or(word.len());
        if text.get(start..end).is_some_and(|word| word.eq_ignore_ascii_case(wanted)) {
            return Some(start);
        }
        from = end;
    }
}

fn word(mark: &str) -> Wording {
    Wording::new(format!("`{mark}`: something is still to be done here"), "still to be done", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn whole_words_are_reported() {
        expect![[r#"
            start.pgx:6 `Todo` `Todo`: something is still to be done here
              | still to be done
        "#]]
        .assert_eq(&check(&RULE, "// first\n//!Todo: speed, fixme\ncls()"));
    }

    #[test]
    fn parts_of_words_and_strings_are_not_reported() {
        assert_eq!(check(&RULE, "// todos, nTodo\nputln(\"todo\")"), "");
    }
}

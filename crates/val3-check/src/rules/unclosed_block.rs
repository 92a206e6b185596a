//! V0014: a block that is not closed.

use val3_syntax::{SyntaxKind, TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A block (`if`, `while`, `do`, `for`, `switch`) is not closed.
    ///
    /// ## Why
    /// Every block has its own closing keyword: `endIf`, `endWhile`, `until`, `endFor`, `endSwitch`. An `elseIf` opens
    /// no block of its own, so a chain of conditions needs one `endIf`. A `do` block is repeated until its condition is
    /// true: there is no `do … while`. The controller rejects a program with an open block. The finding is at the place
    /// where the end is missing according to the indentation.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// while nCount<10
    ///   nCount=nCount+1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// while nCount<10
    ///   nCount=nCount+1
    /// endWhile
    /// ```
    V0014 "unclosed-block" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(block: &str, missing: &str) -> Wording {
    let label = match missing {
        "until" => "`until` and a condition belong here".to_owned(),
        _ => format!("`{missing}` belongs here"),
    };
    Wording::new(format!("`{block}` has no `{missing}`"), label, "")
}

/// Returns the wording for a `do` block that ends with `while`, as in other languages.
pub(crate) fn do_while() -> Wording {
    Wording::new(
        "a `do` block ends with `until`, not with `while`",
        "`until` and the opposite condition belong here",
        "write `until !(…)`: the block is repeated until the condition is true",
    )
}

/// Replaces `while` by `until` with the opposite condition.
pub(crate) fn end_with_until(site: &Site<'_>) -> Option<Fix> {
    let condition = site.after().trim();
    if condition.is_empty() || condition.contains("//") || condition.contains("]]>") || condition.contains("</") {
        return None;
    }
    let start = TextSize::of(site.after()) - TextSize::of(site.after().trim_start());
    let keyword = TextRange::new(site.range.start(), site.range.end() + start);
    let end = TextRange::empty(keyword.end() + TextSize::of(condition));
    Some(Fix::guess("write `until !(…)`", vec![site.replace(keyword, "until !("), site.replace(end, ")")]))
}

/// Returns the wording for a block that ends before its `inner` block.
pub(crate) fn crossed(inner: &str, early: &str, late: &str) -> Wording {
    Wording::new(
        format!("`{early}` is before the `{late}` of the `{inner}` inside its block"),
        format!("the `{inner}` is still open here"),
        format!("close the inner block first: `{late}`, then `{early}`"),
    )
}

/// Swaps the ends of two blocks, except `until`, whose condition would have to move as well.
pub(crate) fn swap(site: &Site<'_>, early: &str, late: &str) -> Option<Fix> {
    let other = site.related.filter(|_| ![early, late].contains(&"until"))?;
    let edits = vec![site.replace(site.range, late), site.replace(other, early)];
    Some(Fix::guess(format!("swap `{early}` and `{late}`"), edits))
}

/// Closes the block where its indentation ends, or corrects a mistaken end. There is no fix for `until`, because its
/// condition is unknown.
pub(crate) fn fix(site: &Site<'_>, missing: &str) -> Option<Fix> {
    let opener = site.related.filter(|_| missing != "until")?;
    let indentation = site.indentation(opener);
    let title = format!("write `{missing}`");
    if is_end(site.text()) && site.indentation(site.range) == indentation {
        return Some(Fix::guess(title, vec![site.replace(site.range, missing)]));
    }
    let edit = site.insert_line(&format!("{indentation}{missing}"))?;
    Some(Fix::guess(title, vec![edit]))
}

/// Whether the keyword ends a block.
fn is_end(word: &str) -> bool {
    use SyntaxKind::{END_FOR_KW, END_IF_KW, END_SWITCH_KW, END_WHILE_KW};
    matches!(SyntaxKind::from_keyword(word), Some(END_FOR_KW | END_IF_KW | END_SWITCH_KW | END_WHILE_KW))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_if_without_end_is_reported() {
        expect![[r#"
            `if` has no `endIf`
            | `endIf` belongs here
        "#]]
        .assert_eq(&word("if", "endIf").to_string());
    }

    #[test]
    fn crossed_blocks_are_reported() {
        expect![[r#"
            `endWhile` is before the `endIf` of the `if` inside its block
            | the `if` is still open here
            ? close the inner block first: `endIf`, then `endWhile`
        "#]]
        .assert_eq(&crossed("if", "endWhile", "endIf").to_string());
    }

    #[test]
    fn a_do_without_until_is_reported() {
        expect![[r#"
            `do` has no `until`
            | `until` and a condition belong here
        "#]]
        .assert_eq(&word("do", "until").to_string());
    }
}

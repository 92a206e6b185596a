//! V0204: too many or too few arguments.

use smol_str::SmolStr;
use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    english::{count, or},
    fix::Site,
    rule::rule,
};

rule! {
    /// A call has too many or too few arguments.
    ///
    /// ## Why
    /// Every parameter of a program or instruction needs its argument; none can be left out. Where an instruction has
    /// several forms, the number of arguments must match a form. The controller does not load an application with any
    /// other call.
    ///
    /// ## Bad
    /// ```val3
    /// point pPick
    /// mdesc mFast
    ///
    /// movel(pPick,mFast)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    /// mdesc mFast
    ///
    /// movel(pPick,flange,mFast)
    /// ```
    V0204 "argument-count" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(callee: &str, expected: &[usize], found: usize, forms: &[SmolStr]) -> Wording {
    let given = match found {
        0 => "none is given".to_owned(),
        1 => "1 is given".to_owned(),
        _ => format!("{found} are given"),
    };
    Wording::new(
        format!("`{callee}` takes {}; {given}", possible(expected)),
        difference(expected, found),
        syntax(forms),
    )
}

/// Possible numbers of arguments: "no arguments", "2 or 3 arguments".
fn possible(expected: &[usize]) -> String {
    match expected {
        [] | [0] => "no arguments".to_owned(),
        [only] => count(*only, "argument"),
        several => {
            let numbers: Vec<_> = several.iter().map(ToString::to_string).collect();
            format!("{} arguments", or(&numbers))
        }
    }
}

/// Number of missing or superfluous arguments; empty if `found` is between two possible numbers.
fn difference(expected: &[usize], found: usize) -> String {
    let (least, most) = (expected.first().copied().unwrap_or(0), expected.last().copied().unwrap_or(0));
    if found < least {
        format!("{} missing", count(least - found, "argument"))
    } else if found > most {
        format!("{} too many", count(found - most, "argument"))
    } else {
        String::new()
    }
}

/// Forms of the callee, one per line if there are several.
fn syntax(forms: &[SmolStr]) -> String {
    let quoted: Vec<_> = forms.iter().map(|form| format!("`{form}`")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [only] => format!("the form is {only}"),
        several => format!("the forms are\n{}", several.join("\n")),
    }
}

/// Removes superfluous arguments at the end of a call, or adds values for missing arguments.
pub(crate) fn fix(site: &Site<'_>, expected: &[usize], found: usize, forms: &[SmolStr]) -> Option<Fix> {
    let most = *expected.last()?;
    if found > most { remove(site, most) } else { add(site, found, forms) }
}

/// Removes all arguments after the first `count`.
fn remove(site: &Site<'_>, count: usize) -> Option<Fix> {
    let arguments = site.arguments()?;
    let surplus = arguments.get(count..)?;
    let (first, last) = (surplus.first()?, surplus.last()?);
    let start = count.checked_sub(1).and_then(|kept| arguments.get(kept)).map_or(first.start(), |kept| kept.end());
    let title = if surplus.len() == 1 { "remove the last argument" } else { "remove the last arguments" };
    Some(Fix::guess(title, vec![site.write(TextRange::new(start, last.end()), "")]))
}

/// Adds a value for each missing parameter of the only form, if all of them can have one.
fn add(site: &Site<'_>, found: usize, forms: &[SmolStr]) -> Option<Fix> {
    let [form] = forms else { return None };
    let parameters = form.split_once('(')?.1.strip_suffix(')')?;
    let values: Option<Vec<&str>> = parameters.split(", ").skip(found).map(value).collect();
    let values = values?.join(",");
    let end = site.range.end() - TextSize::of(site.text().strip_suffix(')').map(|_| ")")?);
    let separator = if found == 0 { "" } else { "," };
    let edit = site.replace(TextRange::empty(end), &format!("{separator}{values}"));
    Some(Fix::guess(format!("add `{values}`"), vec![edit]))
}

/// Value for a parameter, which the user completes. `None` if it requires a variable, or if its type has no short
/// literal.
fn value(parameter: &str) -> Option<&'static str> {
    match parameter.split_once(' ')? {
        (_, name) if name.contains('[') => None,
        ("num", _) => Some("0"),
        ("bool", _) => Some("false"),
        ("string", _) => Some("\"\""),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_gives_the_only_form() {
        let form = ["num movel(point pPosition, tool tTool, mdesc mDesc)".into()];
        expect![[r#"
            `movel` takes 3 arguments; 2 are given
            | 1 argument missing
            ? the form is `num movel(point pPosition, tool tTool, mdesc mDesc)`
        "#]]
        .assert_eq(&word("movel", &[3], 2, &form).to_string());
        expect![[r#"
            `waitEndMove` takes no arguments; 1 is given
            | 1 argument too many
            ? the form is `void waitEndMove()`
        "#]]
        .assert_eq(&word("waitEndMove", &[0], 1, &["void waitEndMove()".into()]).to_string());
    }

    #[test]
    fn the_message_gives_the_possible_counts() {
        let forms = ["void cls()".into(), "void cls(screen scPage)".into()];
        expect![[r#"
            `cls` takes 0 or 1 arguments; 3 are given
            | 2 arguments too many
            ? the forms are
            `void cls()`
            `void cls(screen scPage)`
        "#]]
        .assert_eq(&word("cls", &[0, 1], 3, &forms).to_string());
    }

    #[test]
    fn a_count_between_two_forms_is_reported() {
        assert_eq!(difference(&[1, 3], 2), "");
    }
}

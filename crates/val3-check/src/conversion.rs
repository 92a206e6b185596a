//! Advice for a value that has the wrong type.

use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::built_in;
use crate::diagnostic::Fix;
use crate::fix::Site;

/// Describes how to convert a value of type `found` to type `wanted`; empty if there is no usual way.
///
/// The types are in the notation of the analysis. An arm suffix has no influence.
pub(crate) fn advice(found: &str, wanted: &str) -> String {
    let base = |ty| built_in::parse(ty).map(|(ty, _)| ty);
    match (built_in::values(wanted), base(found), base(wanted)) {
        (Some(values), ..) => format!("write {values}"),
        (None, Some(found), Some(wanted)) => between(found, wanted).to_owned(),
        _ => String::new(),
    }
}

/// Converts the marked value from type `found` to type `wanted`, if a short text around it is sufficient.
pub(crate) fn fix(site: &Site<'_>, found: &str, wanted: &str) -> Option<Fix> {
    let base = |ty| built_in::parse(ty).map(|(ty, _)| ty);
    let (before, after) = around(base(found)?, base(wanted)?)?;
    let is_operand = before.is_empty() && !is_simple(site.text());
    let (before, after) = if is_operand { ("(", format!("){after}")) } else { (before, after.to_owned()) };
    let (start, end) = (TextRange::empty(site.range.start()), TextRange::empty(site.range.end()));
    let edits = vec![site.replace(start, before), site.replace(end, &after)];
    Some(Fix::guess(format!("write `{before}…{after}`"), edits))
}

/// Whether the value is a name with its indexes and fields, or a call, which needs no parentheses before an operator or
/// a field.
fn is_simple(value: &str) -> bool {
    let mut depth = 0_i32;
    value.chars().all(|letter| {
        depth += match letter {
            '(' | '[' => 1,
            ')' | ']' => -1,
            _ => 0,
        };
        depth > 0 || letter.is_alphanumeric() || matches!(letter, '_' | '.' | ':' | '$' | ')' | ']')
    })
}

/// Text before and after a value that converts it.
fn around(found: BaseType, wanted: BaseType) -> Option<(&'static str, &'static str)> {
    use BaseType as T;
    Some(match (found, wanted) {
        (T::Num, T::String) => ("toString(\"\",", ")"),
        (T::Num, T::Bool) => ("", "!=0"),
        (T::Bool, T::Num) => ("sel(", ",1,0)"),
        (T::Dio, T::Dio) => ("(", "==true)"),
        (T::Dio, T::Num) => ("dioGet(", ")"),
        (T::Aio, T::Num) => ("aioGet(", ")"),
        (T::Point | T::Frame | T::Tool, T::Trsf) => ("", ".trsf"),
        (T::Joint, T::Config) => ("config(", ")"),
        (T::Point, T::Config) => ("", ".config"),
        _ => return None,
    })
}

fn between(found: BaseType, wanted: BaseType) -> &'static str {
    use BaseType as T;
    match (found, wanted) {
        (T::Num, T::String) => "`toString(\"\", …)` turns a number into text",
        (T::String, T::Num) => "`toNum(…)` reads a number from a text",
        (T::Num, T::Bool) => "a comparison such as `…!=0` converts a number to a `bool`",
        (T::Bool, T::Num) => "`sel(…, 1, 0)` converts a `bool` to a number",
        (T::Dio, T::Dio) => "a `dio` takes a `bool`: compare the input, `(…==true)`",
        (T::Num, T::Trsf) => "a transformation has six numbers: `{0,0,-100,0,0,0}` is 100 mm against z",
        (T::Num, T::Dio) => "a `dio` takes a `bool`; `dioSet(…)` writes a number to several outputs",
        (T::Dio, T::Num) => "`dioGet(…)` reads digital inputs as a number",
        (T::Aio, T::Num) => "`aioGet(…)` reads a numerical input",
        (T::Num, T::Aio) => "`aioSet(…)` writes a numerical output",
        (T::Point | T::Frame | T::Tool, T::Trsf) => "append `.trsf` to get its transformation",
        (T::Trsf, T::Frame | T::Tool) => "the field `.trsf` of the variable takes a transformation",
        (T::Trsf, T::Point) => "assign it to the field `.trsf` of a point; `compose(…)` returns a point with it",
        (T::Point, T::Joint) => "`pointToJoint(…)` computes the joint position of a point",
        (T::Joint, T::Point) => "`jointToPoint(…)` computes the point of a joint position",
        (T::Point, T::Frame) => "`setFrame(…)` computes a frame from three points",
        (T::Joint, T::Config) => "`config(…)` yields the configuration of a joint position",
        (T::Point, T::Config) => "append `.config` to get its configuration",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::{advice, is_simple};

    #[test]
    fn the_advice_does_not_depend_on_the_arm() {
        assert_eq!(advice("pointRs", "trsf"), advice("point", "trsf"));
        assert!(!advice("point", "trsf").is_empty());
    }

    #[test]
    fn an_enumeration_lists_its_values() {
        assert_eq!(advice("string", "blend"), "write `joint`, `off` or `Cartesian`");
    }

    #[test]
    fn operators_need_parentheses() {
        assert!(["nA", "l_n[nA+1].x", "part:pA", "abs(nA-1)", "(nA+1)"].into_iter().all(is_simple));
        assert!(!["nA+1", "-nA", "abs(nA)-1", "f(a) b"].into_iter().any(is_simple));
    }

    #[test]
    fn containers_and_user_types_have_no_advice() {
        assert_eq!(advice("num[]", "string"), "");
        assert_eq!(advice("num", "Slot"), "");
    }
}

//! Lines in the syntax of other languages, and their VAL 3 form.

use val3_lang::foreign_names::remedy;
use val3_lang::keywords::is_task_creation;
use val3_syntax::TextSlice;

/// Advice for a line with a syntax error that is a known construct in a different language.
pub(crate) fn advice(line: &str) -> Option<&'static str> {
    let line = line.trim();
    let code = line.split("//").next().unwrap_or(line).trim();
    let first = code.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
    let second = code.part(first.len()..).trim_start();
    if line.starts_with("/*") || line.starts_with('*') || line.starts_with('#') || line.starts_with("--") {
        return Some("a comment begins with `//`, and each line of it has its own");
    }
    if code.ends_with("++") {
        return Some("`n=n+1` adds 1");
    }
    if code.ends_with("--") {
        return Some("`n=n-1` subtracts 1");
    }
    if ["+=", "-=", "*=", "/="].iter().any(|operator| code.contains(operator)) {
        return Some("write the variable on both sides: `n=n+2`");
    }
    if is_task_creation(first) && holds_all_arguments(second) {
        return Some("the arguments have no brackets: `taskCreate \"name\",10,work()`");
    }
    if ["case", "default"].iter().any(|word| first.eq_ignore_ascii_case(word)) && code.ends_with(':') {
        return Some("`case 1` and `default` have no colon");
    }
    if has_decimal_comma(code) {
        return Some("the decimal sign is a point: `n=1.5`");
    }
    if has_adjacent_strings(code) {
        return Some("a quote inside a string is written `\"…\"+chr(34)+\"…\"`");
    }
    if TYPES.contains(&first) && second.starts_with(|c: char| c.is_alphabetic()) {
        return Some("variables are declared in the head of the program or in the data file, not in the code");
    }
    if code.ends_with('{') || code.starts_with('}') {
        return Some("blocks have no braces: a keyword such as `endIf` or `endWhile` ends them");
    }
    if words(code).skip(1).any(|word| word.eq_ignore_ascii_case("mod")) {
        return remedy("mod");
    }
    if code.contains('^') || code.contains("**") {
        return Some("`power(nBase,nExponent)` raises a number to a power");
    }
    HEADS.contains(&first.to_lowercase().as_str()).then(|| remedy(first)).flatten()
}

/// Whether the text begins with a bracket that contains a comma outside of inner brackets and strings.
fn holds_all_arguments(text: &str) -> bool {
    let mut depth = 0_u32;
    for character in text.split('"').step_by(2).flat_map(str::chars) {
        match character {
            '(' => depth += 1,
            ')' if depth <= 1 => return false,
            ')' => depth -= 1,
            ',' if depth == 1 => return true,
            _ if depth == 0 => return false,
            _ => {}
        }
    }
    false
}

/// Whether the line assigns a number such as `1,5`.
fn has_decimal_comma(code: &str) -> bool {
    let is_whole = |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let number = code.split_once('=').map(|(_, value)| value.trim().trim_start_matches('-'));
    number.and_then(|number| number.split_once(',')).is_some_and(|(whole, part)| is_whole(whole) && is_whole(part))
}

/// Whether a string directly follows another one, as in `"a""b"`.
fn has_adjacent_strings(code: &str) -> bool {
    let parts: Vec<&str> = code.split('"').collect();
    let between = parts.get(2..parts.len().saturating_sub(2)).unwrap_or_default();
    between.iter().step_by(2).any(|part| part.is_empty())
}

/// Words of a line, without its strings.
fn words(code: &str) -> impl Iterator<Item = &str> {
    let outside = code.split('"').step_by(2);
    outside.flat_map(|part| part.split(|c: char| !c.is_alphanumeric() && c != '_')).filter(|word| !word.is_empty())
}

/// Words that begin a declaration in other languages.
const TYPES: [&str; 19] = [
    "num", "bool", "string", "point", "joint", "frame", "tool", "trsf", "mdesc", "dio", "aio", "sio", "int", "float",
    "double", "var", "let", "const", "char",
];

/// Words that begin a statement in other languages.
const HEADS: [&str; 12] =
    ["goto", "try", "catch", "throw", "raise", "finally", "function", "def", "void", "continue", "print", "sleep"];

#[cfg(test)]
mod tests {
    use super::advice;

    #[test]
    fn habits_of_other_languages_have_advice() {
        for (line, expected) in [
            ("nCount++", "`n=n+1`"),
            ("  nCount--", "`n=n-1`"),
            ("nCount += 2", "both sides"),
            ("num nCount", "head of the program"),
            ("int i = 0;", "head of the program"),
            ("if nCount==1 {", "no braces"),
            ("} else {", "no braces"),
            ("/* pick */", "`//`"),
            ("n=2^3", "power("),
            ("n=nA mod 2", "nA%nB"),
            ("if nA MOD 2==0", "nA%nB"),
            ("goto loop", "no `goto`"),
            ("try", "exceptions"),
            ("taskCreate(\"a\",10,work())", "no brackets"),
            ("taskCreateSync (sName(1)+\"(\",0.004,bLate,work())", "no brackets"),
            ("case 1:", "no colon"),
            ("default:", "no colon"),
            ("n=1,5", "`n=1.5`"),
            ("n= -1,25", "`n=1.5`"),
            ("s=\"a\"\"b\"", "chr(34)"),
            ("put(\"say \"\"yes\"\"\")", "chr(34)"),
        ] {
            assert!(advice(line).is_some_and(|advice| advice.contains(expected)), "{line}: {:?}", advice(line));
        }
    }

    #[test]
    fn other_lines_have_none() {
        for line in [
            "nCount=",
            "call pick(",
            "if nCount=1",
            "// nCount++",
            "movej(pA,,mB)",
            "tool=3",
            "numbers x",
            "s=\"a mod b\" c",
            "taskCreate (sName),10,work(",
            "taskCreate \"a\",10,work(1,2",
            "n={1,5}",
            "s=\"\"",
            "s=\"\"+\"a\" b",
            "call log(\"a\",\"\"",
        ] {
            assert_eq!(advice(line), None, "{line}");
        }
    }
}

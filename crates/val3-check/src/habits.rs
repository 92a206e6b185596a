//! Lines in the syntax of other languages, and their VAL 3 form.

use val3_lang::foreign_names::remedy;
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
        ] {
            assert_eq!(advice(line), None, "{line}");
        }
    }
}

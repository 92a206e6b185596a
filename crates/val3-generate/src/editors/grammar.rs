//! TextMate grammar of VAL 3 code.
//!
//! The code view contains only code; a program file contains code in CDATA or as escaped text. The three forms differ
//! in the quotes of strings and the end of comments.

use serde_json::{Value, json};

use super::words;

/// Form of code in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CodeForm {
    /// Only code.
    Plain,
    /// Code in a CDATA section.
    Cdata,
    /// Code as XML text, with entities.
    Escaped,
}

impl CodeForm {
    /// Returns the quote of strings.
    fn quote(self) -> &'static str {
        if self == Self::Escaped { "(?:\"|&quot;)" } else { "\"" }
    }

    /// Returns the end of the code within a line.
    fn end(self) -> &'static str {
        match self {
            Self::Plain => "$",
            Self::Cdata => "$|(?=\\]\\]>)",
            Self::Escaped => "$|(?=<)",
        }
    }

    fn comparisons(self) -> &'static str {
        if self == Self::Escaped { "==|!=|&[lg]t;=?|<=?|>=?" } else { "==|!=|<=|>=|<|>" }
    }
}

/// Returns the grammar of the code view.
pub(crate) fn code() -> Value {
    json!({
        "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
        "name": "VAL 3 code",
        "scopeName": "source.val3",
        "patterns": patterns(CodeForm::Plain),
    })
}

/// Returns the patterns that colour code. Strings precede comments, because a string may contain `//`.
pub(crate) fn patterns(form: CodeForm) -> Vec<Value> {
    let mut patterns = vec![string(form), comment(form), number(), call()];
    patterns.extend([
        rule("keyword.control", &words::control()),
        rule("keyword.operator.word", &words::word_operators()),
        rule("constant.language", &words::truth_values()),
        member(),
    ]);
    patterns.extend(words::instruction_families().iter().map(|(family, words)| instruction(family, words)));
    patterns.extend([
        rule("support.function.addon", "\\$[A-Za-z_]\\w*"),
        namespace(),
        program_name(),
        rule("constant.language.enumerator", &words::enumerators()),
        rule("variable.language", &words::built_in_variables()),
        rule("keyword.operator.comparison", form.comparisons()),
        rule("keyword.operator.assignment", "="),
        rule("keyword.operator.arithmetic", "[-+*/%!]"),
        rule("keyword.other.print", "\\?"),
        rule("punctuation.separator", "[,;]"),
        rule("variable.other", "[A-Za-z_]\\w*"),
    ]);
    patterns
}

fn rule(scope: &str, regex: &str) -> Value {
    json!({ "name": format!("{scope}.val3"), "match": regex })
}

/// A string contains no escapes and ends with its line at the latest.
fn string(form: CodeForm) -> Value {
    json!({
        "name": "string.quoted.double.val3",
        "begin": form.quote(),
        "end": format!("{}|{}", form.quote(), form.end()),
        "beginCaptures": { "0": { "name": "punctuation.definition.string.begin.val3" } },
        "endCaptures": { "0": { "name": "punctuation.definition.string.end.val3" } },
    })
}

fn comment(form: CodeForm) -> Value {
    json!({
        "name": "comment.line.double-slash.val3",
        "begin": "//",
        "end": form.end(),
        "beginCaptures": { "0": { "name": "punctuation.definition.comment.val3" } },
        "patterns": [{ "name": "storage.type.class.val3", "match": "(?<=//)(?:\\\\\\w+|!\\w+|val3:)" }],
    })
}

fn number() -> Value {
    rule("constant.numeric", "(?<![\\w.])(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?")
}

/// Matches `call part:grip(…)`.
fn call() -> Value {
    json!({
        "match": "(?i)\\b(call)\\s+(?:([a-z_]\\w*)(:))?([a-z_]\\w*)",
        "captures": {
            "1": { "name": "keyword.control.call.val3" },
            "2": { "name": "entity.name.namespace.val3" },
            "3": { "name": "punctuation.separator.namespace.val3" },
            "4": { "name": "entity.name.function.val3" },
        },
    })
}

/// Matches `run(…)` if it is not an instruction: a program, after `call` or in `taskCreate`.
fn program_name() -> Value {
    rule("entity.name.function", "[A-Za-z_]\\w*(?=\\()")
}

/// Matches a name after a dot, which is a field even if it has another meaning elsewhere.
fn member() -> Value {
    json!({
        "match": "(\\.)([A-Za-z_]\\w*)",
        "captures": {
            "1": { "name": "punctuation.accessor.val3" },
            "2": { "name": "variable.other.member.val3" },
        },
    })
}

/// Matches an instruction with its parenthesis, because `first` without one may be a variable.
fn instruction(family: &str, words: &str) -> Value {
    rule(&format!("support.function.{family}"), &format!("{words}(?=\\s*\\()"))
}

/// Matches `io:doConveyor`.
fn namespace() -> Value {
    json!({
        "match": "\\b([A-Za-z_]\\w*)(:)(?=[A-Za-z_])",
        "captures": {
            "1": { "name": "entity.name.namespace.val3" },
            "2": { "name": "punctuation.separator.namespace.val3" },
        },
    })
}

//! TextMate grammars of the three kinds of files: XML, with code in programs.

use serde_json::{Value, json};

use super::grammar::{self, CodeForm};

/// Returns the grammar of `.pgx`.
pub(crate) fn program() -> Value {
    json!({
        "name": "VAL 3 program",
        "scopeName": "text.xml.val3",
        "patterns": [{ "include": "#code" }, { "include": "text.xml" }],
        "repository": {
            "code": code(),
            "cdata": cdata(),
            "code-in-cdata": { "patterns": grammar::patterns(CodeForm::Cdata) },
            "escaped-code": { "patterns": grammar::patterns(CodeForm::Escaped) },
        },
    })
}

/// Returns the grammar of `.dtx`.
pub(crate) fn data() -> Value {
    plain("VAL 3 data", "text.xml.val3-data")
}

/// Returns the grammar of `.pjx`.
pub(crate) fn project() -> Value {
    plain("VAL 3 project", "text.xml.val3-project")
}

fn plain(name: &str, scope: &str) -> Value {
    json!({ "name": name, "scopeName": scope, "patterns": [{ "include": "text.xml" }] })
}

/// Matches `<Code>…</Code>` of s7 and s8, `<code>…</code>` of s5 and s6. Entities are coloured inside and outside of
/// strings, so entities that are neither operator nor quote come last.
fn code() -> Value {
    let tag = json!({
        "1": { "name": "punctuation.definition.tag.xml" },
        "2": { "name": "entity.name.tag.xml" },
        "3": { "name": "punctuation.definition.tag.xml" },
    });
    json!({
        "begin": "(<)(Code|code)(?:\\s[^>]*)?(?<!/)(>)",
        "end": "(</)(Code|code)\\s*(>)",
        "beginCaptures": tag,
        "endCaptures": tag,
        "contentName": "source.val3.embedded",
        "patterns": [{ "include": "#cdata" }, { "include": "#escaped-code" }],
    })
}

fn cdata() -> Value {
    json!({
        "begin": "<!\\[CDATA\\[",
        "end": "\\]\\]>",
        "beginCaptures": { "0": { "name": "punctuation.definition.string.begin.xml" } },
        "endCaptures": { "0": { "name": "punctuation.definition.string.end.xml" } },
        "patterns": [{ "include": "#code-in-cdata" }],
    })
}

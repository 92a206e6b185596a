//! Settings of the VS Code extension.
//!
//! Names and titles of findings come from the rules, so the editor offers exactly the existing ones.

use serde_json::{Value, json};
use val3_check::rules;
use val3_lang::page;

/// Returns the sections of the settings, in the order in which VS Code shows them.
pub(crate) fn all() -> Value {
    json!(
        [section("VAL 3: server", &server()), section("VAL 3: editor", &editor()), section("VAL 3: check", &check()),]
    )
}

fn section(title: &str, properties: &Value) -> Value {
    json!({ "title": title, "properties": properties })
}

fn server() -> Value {
    json!({
        "val3.server.path": {
            "type": "string",
            "default": "",
            "scope": "machine-overridable",
            "markdownDescription": "The command `val3` to use. If empty, the one inside the extension, or else \
                the one on the `PATH`.",
        },
        "val3.server.arguments": {
            "type": "array",
            "items": { "type": "string" },
            "default": [],
            "scope": "machine-overridable",
            "markdownDescription": "Further arguments of `val3 lsp`, such as `--log FILE`.",
        },
        "val3.trace.server": {
            "type": "string",
            "enum": ["off", "messages", "verbose"],
            "default": "off",
            "description": "Shows the messages between the editor and the server in the output channel \"VAL 3\".",
        },
    })
}

fn editor() -> Value {
    json!({
        "val3.codeView.openByDefault": {
            "type": "boolean",
            "default": false,
            "description": "Opens programs from the view VAL 3 as code without XML instead of as files.",
        },
        "val3.codeView.follow": {
            "type": "boolean",
            "default": true,
            "description": "*Go to Definition* in a code view opens the code view of the target program instead of \
                its file.",
        },
        "val3.dataEditor.openByDefault": {
            "type": "boolean",
            "default": false,
            "description": "Opens data from the view VAL 3 as tables instead of as files.",
        },
        "val3.codeLens.programReferences": lens(true, "The number of references above the name of a program."),
        "val3.codeLens.dataReferences": lens(false, "The number of references above each element of a data file."),
        "val3.inlayHints.parameterNames": switch("The names of parameters before literal arguments, and of fields before the values of braces."),
        "val3.inlayHints.literalTypes": switch("The types of literals in braces, such as `trsf`."),
        "val3.inlayHints.pointFrames": switch("The frame of the target of a move, after the point."),
        "val3.inlayHints.blends": switch("The blend of a move, after its motion descriptor."),
    })
}

/// Returns a setting for a kind of code lens. VS Code's settings determine whether lenses are shown.
fn lens(default: bool, description: &str) -> Value {
    json!({
        "type": "boolean",
        "default": default,
        "markdownDescription": format!("{description} All lenses: `#editor.codeLens#`."),
    })
}

/// Returns a setting for a kind of inlay hint. VS Code's settings determine the appearance of hints, and whether they
/// are shown.
fn switch(description: &str) -> Value {
    json!({
        "type": "boolean",
        "default": true,
        "markdownDescription": format!("{description} All hints: `#editor.inlayHints.enabled#`."),
    })
}

/// Returns the settings of the check. Settings of programs, for example for formatting, belong in a `val3.toml`.
fn check() -> Value {
    json!({
        "val3.check.select": findings("The rules whose findings are shown; if empty, all."),
        "val3.check.ignore": findings("The rules whose findings are not shown."),
        "val3.check.delivery": {
            "type": "string",
            "enum": ["auto", "push", "pull"],
            "default": "auto",
            "description": "Whether the server sends findings or the editor requests them. `auto` chooses what the editor supports.",
        },
    })
}

/// Returns a setting with a list of rules: names are suggested, and codes and beginnings of codes are accepted too.
fn findings(description: &str) -> Value {
    let rules = rules::all();
    let names: Vec<&str> = rules.iter().map(|rule| rule.name).collect();
    let titles: Vec<String> = rules.iter().map(|rule| format!("{}: {}", rule.code, page::summary(rule.page))).collect();
    json!({
        "type": "array",
        "default": [],
        "items": {
            "anyOf": [{ "enum": names, "enumDescriptions": titles }, { "type": "string", "pattern": "^V\\d{0,4}$" }],
        },
        "markdownDescription": format!(
            "{description} Names (`argument-type`), codes (`V0203`) or prefixes of codes (`V02`). Levels and the layout \
             of code belong in a `val3.toml`, which CI and other editors read too."
        ),
    })
}

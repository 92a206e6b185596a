//! The settings of the VS Code extension.
//!
//! Names and titles of findings come from the rules, so that the editor offers those that exist.

use serde_json::{Value, json};
use val3_check::rules;
use val3_lang::page;

/// The sections of the settings, in the order in which VS Code shows them.
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
            "markdownDescription": "The command `val3` to use. When empty, the one that comes with the extension, \
                else the one on the `PATH`.",
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
            "description": "Shows what the editor and the server say to each other in the output channel \"VAL 3\".",
        },
    })
}

fn editor() -> Value {
    json!({
        "val3.codeView.openByDefault": {
            "type": "boolean",
            "default": false,
            "description": "Opens a program of the view VAL 3 as code without its XML instead of as its file.",
        },
        "val3.codeView.follow": {
            "type": "boolean",
            "default": true,
            "description": "A definition that is asked for in a code view opens the code view of the program it leads \
                to, instead of its file.",
        },
        "val3.inlayHints.parameterNames": switch("The names of parameters before literal arguments, and of fields before the values of braces."),
        "val3.inlayHints.literalTypes": switch("The types of literals in braces, such as `trsf`."),
        "val3.inlayHints.pointFrames": switch("The frame behind the point that a move leads to."),
        "val3.inlayHints.blends": switch("How a move blends into the next, behind its motion descriptor."),
    })
}

/// A kind of inlay hints. What hints look like, and whether there are any, VS Code itself has settings for.
fn switch(description: &str) -> Value {
    json!({
        "type": "boolean",
        "default": true,
        "markdownDescription": format!("{description} All hints: `#editor.inlayHints.enabled#`."),
    })
}

/// What belongs to the programs themselves, such as their layout, stands in a `val3.toml`.
fn check() -> Value {
    json!({
        "val3.check.select": findings("The only findings that are shown; all when empty."),
        "val3.check.ignore": findings("Findings that are not shown."),
        "val3.check.delivery": {
            "type": "string",
            "enum": ["auto", "push", "pull"],
            "default": "auto",
            "description": "Who begins: the server sends findings, the editor asks for them, or what suits the editor.",
        },
    })
}

/// A list of rules: names are offered, codes and beginnings of codes are taken as well.
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
            "{description} Names (`argument-type`), codes (`V0203`) or beginnings of codes (`V02`). Levels belong \
             into a `val3.toml`, and the layout of code as well: CI and other editors read it too."
        ),
    })
}

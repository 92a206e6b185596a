//! The grammar file: the rules as `ungrammar` reads them, and for each its comment and its text.

use std::collections::BTreeMap;

use anyhow::Context;
use ungrammar::Grammar;

/// A grammar file.
pub(super) struct Source {
    /// The rules.
    pub(super) grammar: Grammar,
    texts: BTreeMap<String, RuleText>,
}

/// What a reader of the grammar file sees of one rule.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub(super) struct RuleText {
    /// The comment lines directly above, without `//`.
    pub(super) comment: Vec<String>,
    /// The rule itself.
    pub(super) lines: Vec<String>,
}

impl Source {
    /// Reads a grammar file.
    pub(super) fn parse(text: &str) -> anyhow::Result<Self> {
        let grammar = text.parse().context("the grammar is wrong")?;
        Ok(Self { grammar, texts: rule_texts(text) })
    }

    /// Comment and text of the rule `name`.
    pub(super) fn text(&self, name: &str) -> RuleText {
        self.texts.get(name).cloned().unwrap_or_default()
    }
}

fn rule_texts(text: &str) -> BTreeMap<String, RuleText> {
    let mut texts = BTreeMap::new();
    let mut comment = Vec::new();
    let mut current: Option<String> = None;
    for line in text.lines() {
        if let Some(words) = line.strip_prefix("//") {
            current = None;
            comment.push(words.trim().to_owned());
        } else if line.trim().is_empty() {
            current = None;
            comment.clear();
        } else {
            let name = rule_name(line).or(current);
            if let Some(name) = &name {
                let rule: &mut RuleText = texts.entry(name.clone()).or_default();
                rule.comment.append(&mut comment);
                rule.lines.push(line.trim_end().to_owned());
            }
            current = name;
        }
    }
    texts
}

/// The name at the start of the line `Name =` that opens a rule.
fn rule_name(line: &str) -> Option<String> {
    let end = line.find(|letter: char| !letter.is_ascii_alphanumeric())?;
    let (name, rest) = line.split_at(end);
    let opens = !name.is_empty() && (rest.trim().is_empty() || rest.trim_start().starts_with('='));
    opens.then(|| name.to_owned())
}

//! The parts of a rule in the order in which they stand.

use anyhow::bail;
use ungrammar::{Grammar, Rule};

use super::super::tokens::{Language, Token};

/// What an accessor can reach.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// One of these tokens.
    Token { label: Option<String>, tokens: Vec<Token> },
    /// A node, or several.
    Node { label: Option<String>, ty: String, many: bool },
}

/// The parts of `rule`. A node that occurs twice under one name is one part with several nodes; repeated tokens
/// (the commas of a list) are no part.
pub(super) fn of(grammar: &Grammar, rule: &Rule) -> anyhow::Result<Vec<Part>> {
    let mut collector = Collector { grammar, language: language(grammar, rule), parts: Vec::new() };
    collector.collect(rule, None, false)?;
    Ok(collector.parts)
}

/// A rule with a token `#xml_…`, `</` or `/>` describes XML.
fn language(grammar: &Grammar, rule: &Rule) -> Language {
    if mentions_xml(grammar, rule) { Language::Xml } else { Language::Code }
}

fn mentions_xml(grammar: &Grammar, rule: &Rule) -> bool {
    match rule {
        Rule::Token(token) => grammar[*token].name.starts_with("#xml_"),
        Rule::Node(_) => false,
        Rule::Labeled { rule, .. } | Rule::Opt(rule) | Rule::Rep(rule) => mentions_xml(grammar, rule),
        Rule::Seq(rules) | Rule::Alt(rules) => rules.iter().any(|rule| mentions_xml(grammar, rule)),
    }
}

struct Collector<'a> {
    grammar: &'a Grammar,
    language: Language,
    parts: Vec<Part>,
}

impl Collector<'_> {
    fn collect(&mut self, rule: &Rule, label: Option<&str>, many: bool) -> anyhow::Result<()> {
        match rule {
            Rule::Labeled { label, rule } => self.collect(rule, Some(label), many),
            Rule::Opt(rule) => self.collect(rule, label, many),
            Rule::Rep(rule) => self.collect(rule, label, true),
            Rule::Node(node) => self.node(&self.grammar[*node].name, label, many),
            Rule::Token(_) => self.tokens(std::slice::from_ref(rule), label, many),
            Rule::Alt(rules) if rules.iter().all(|rule| matches!(rule, Rule::Token(_))) => {
                self.tokens(rules, label, many)
            }
            Rule::Seq(rules) | Rule::Alt(rules) => rules.iter().try_for_each(|rule| self.collect(rule, label, many)),
        }
    }

    fn node(&mut self, name: &str, label: Option<&str>, repeated: bool) -> anyhow::Result<()> {
        for part in &mut self.parts {
            if let Part::Node { label: l, ty, many } = part
                && l.as_deref() == label
            {
                if ty == name {
                    *many = true;
                    return Ok(());
                }
                if let Some(label) = label {
                    bail!("label `{label}` names both {ty} and {name}");
                }
            }
        }
        self.parts.push(Part::Node { label: label.map(str::to_owned), ty: name.to_owned(), many: repeated });
        Ok(())
    }

    fn tokens(&mut self, rules: &[Rule], label: Option<&str>, repeated: bool) -> anyhow::Result<()> {
        if repeated {
            return Ok(());
        }
        let mut tokens = Vec::new();
        for rule in rules {
            if let Rule::Token(token) = rule {
                tokens.push(Token::of(&self.grammar[*token].name, self.language)?);
            }
        }
        self.parts.push(Part::Token { label: label.map(str::to_owned), tokens });
        Ok(())
    }
}

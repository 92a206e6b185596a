//! What is generated for each rule of the grammar.
//!
//! A rule that is a choice of rules becomes an enum; any other becomes a struct, with an accessor for each of its
//! [`parts`]. Two parts whose nodes could be taken for each other (`lhs:Expr op:'+' rhs:Expr`) are told apart by
//! the tokens around them, so that an accessor finds its node even where another part is missing.

mod parts;

use std::collections::{BTreeMap, BTreeSet};

use anyhow::bail;
use ungrammar::{Grammar, Rule};

use self::parts::Part;
use super::grammar::Source;
use super::names;
use super::tokens::Token;

/// Everything that is generated.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Model {
    pub(super) structs: Vec<Struct>,
    pub(super) enums: Vec<Enum>,
}

/// A node of the tree.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Struct {
    pub(super) name: String,
    pub(super) fields: Vec<Field>,
}

/// A choice of nodes.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Enum {
    pub(super) name: String,
    /// The choices, as the grammar lists them.
    pub(super) variants: Vec<Variant>,
}

/// One choice.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Variant {
    pub(super) name: String,
    /// The structs behind it: itself, or those of the enum it names.
    pub(super) leaves: BTreeSet<String>,
}

/// One accessor.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Field {
    /// A token: the first of one of these kinds.
    Token { accessor: String, tokens: Vec<Token> },
    /// A child node.
    Node {
        accessor: String,
        ty: String,
        many: bool,
        /// Where it stands, when a sibling could be taken for it.
        between: Option<Between>,
    },
}

/// The tokens around a child; an empty list is the start or the end of the node.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Between {
    pub(super) after: Vec<Token>,
    pub(super) before: Vec<Token>,
}

impl Model {
    /// The model of a grammar.
    pub(super) fn of(source: &Source) -> anyhow::Result<Self> {
        let grammar = &source.grammar;
        let choices = choices(grammar);
        let mut model = Self { structs: Vec::new(), enums: Vec::new() };
        for node in grammar.iter() {
            let data = &grammar[node];
            match choices.get(&data.name) {
                Some(variants) => model.enums.push(lower_enum(&data.name, variants, &choices)),
                None => model.structs.push(lower_struct(grammar, &data.name, &data.rule, &choices)?),
            }
        }
        Ok(model)
    }
}

type Choices = BTreeMap<String, Vec<String>>;

/// The rules that are choices of rules, with what they offer.
fn choices(grammar: &Grammar) -> Choices {
    grammar
        .iter()
        .filter_map(|node| {
            let data = &grammar[node];
            Some((data.name.clone(), variants(grammar, &data.rule)?))
        })
        .collect()
}

fn variants(grammar: &Grammar, rule: &Rule) -> Option<Vec<String>> {
    let Rule::Alt(rules) = rule else { return None };
    rules
        .iter()
        .map(|rule| match rule {
            Rule::Node(node) => Some(grammar[*node].name.clone()),
            _ => None,
        })
        .collect()
}

fn lower_enum(name: &str, variants: &[String], choices: &Choices) -> Enum {
    let variants = variants.iter().map(|name| Variant { name: name.clone(), leaves: leaves(name, choices) });
    Enum { name: name.to_owned(), variants: variants.collect() }
}

/// The structs a name stands for.
fn leaves(name: &str, choices: &Choices) -> BTreeSet<String> {
    match choices.get(name) {
        Some(variants) => variants.iter().flat_map(|name| leaves(name, choices)).collect(),
        None => BTreeSet::from([name.to_owned()]),
    }
}

fn lower_struct(grammar: &Grammar, name: &str, rule: &Rule, choices: &Choices) -> anyhow::Result<Struct> {
    let parts = parts::of(grammar, rule)?;
    let mut fields = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        match part {
            Part::Token { label, tokens } => fields.extend(token_fields(label.as_deref(), tokens)),
            Part::Node { label, ty, many } => {
                let accessor = accessor(label.as_deref(), ty, *many);
                let between = ambiguous(index, &parts, choices).then(|| around(index, &parts));
                let (ty, many) = (ty.clone(), *many);
                fields.push(Field::Node { accessor, ty, many, between });
            }
        }
    }
    refuse_confusion(name, &fields)?;
    Ok(Struct { name: name.to_owned(), fields })
}

/// A label makes one accessor for all its tokens; without one each token has its own.
fn token_fields(label: Option<&str>, tokens: &[Token]) -> Vec<Field> {
    let field = |accessor: String, tokens: &[Token]| Field::Token { accessor, tokens: tokens.to_vec() };
    match label {
        Some(label) => vec![field(format!("{label}_token"), tokens)],
        None => tokens.iter().map(|token| field(token.accessor.clone(), std::slice::from_ref(token))).collect(),
    }
}

fn accessor(label: Option<&str>, ty: &str, many: bool) -> String {
    match label {
        Some(label) => label.to_owned(),
        None if many => names::plural(&names::snake(ty)),
        None => names::snake(ty),
    }
}

/// Another part holds nodes of the same kind.
fn ambiguous(index: usize, parts: &[Part], choices: &Choices) -> bool {
    let kinds = |part: &Part| match part {
        Part::Node { ty, .. } => leaves(ty, choices),
        Part::Token { .. } => BTreeSet::new(),
    };
    let Some(own) = parts.get(index).map(kinds) else {
        return false;
    };
    let others = parts.iter().enumerate().filter(|(other, _)| *other != index);
    others.map(|(_, part)| kinds(part)).any(|kinds| !kinds.is_disjoint(&own))
}

fn around(index: usize, parts: &[Part]) -> Between {
    let (left, right) = parts.split_at(index);
    let tokens = |part: &Part| match part {
        Part::Token { tokens, .. } => Some(tokens.clone()),
        Part::Node { .. } => None,
    };
    Between {
        after: left.iter().rev().find_map(tokens).unwrap_or_default(),
        before: right.iter().find_map(tokens).unwrap_or_default(),
    }
}

/// Two accessors that would yield the same node are a fault of the grammar.
fn refuse_confusion(name: &str, fields: &[Field]) -> anyhow::Result<()> {
    let places = fields.iter().filter_map(|field| match field {
        Field::Node { between, .. } => between.as_ref(),
        Field::Token { .. } => None,
    });
    let places: Vec<_> = places.collect();
    for (index, place) in places.iter().enumerate() {
        if places.iter().skip(index + 1).any(|other| other == place) {
            bail!("rule {name}: two parts of the same kind need a token between them");
        }
    }
    Ok(())
}

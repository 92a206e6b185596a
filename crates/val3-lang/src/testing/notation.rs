//! Declarations and calls as text.

use std::collections::BTreeMap;

use crate::memory::{Kind, PartInit, Shape, SlotAt};
use crate::types::BaseType;
use crate::values::Text;

/// A declaration: `num nGrid[4,6]`.
pub(super) struct Variable<'t> {
    pub(super) name: &'t str,
    pub(super) base: BaseType,
    pub(super) shape: Shape,
}

/// A call, or an assignment of one: `pNear=appro(pPick,{0,0,-100,0,0,0})`.
pub(super) struct Line<'t> {
    pub(super) target: Option<Spoken<'t>>,
    pub(super) name: &'t str,
    pub(super) arguments: Vec<Spoken<'t>>,
}

/// An argument as it is written.
pub(super) enum Spoken<'t> {
    Num(f64),
    Text(&'t str),
    Bool(bool),
    /// Numbers in braces.
    Structure(Vec<f64>),
    /// A variable, with the index or key behind it.
    Name(&'t str, SlotAt),
}

impl<'t> Variable<'t> {
    pub(super) fn parse(text: &'t str) -> Self {
        let (base, name) = text.split_once(' ').unwrap();
        let base = BaseType::DECLARABLE.into_iter().find(|found| found.name() == base).unwrap();
        let (name, at) = indexed(name);
        let shape = match at {
            SlotAt::Whole => Shape::ELEMENT,
            SlotAt::Key(_) => Shape::Collection(BTreeMap::new()),
            SlotAt::Index(indexes, dims) => {
                let mut sizes = indexes.map(|index| index as u32);
                sizes.iter_mut().skip(usize::from(dims)).for_each(|size| *size = 1);
                Shape::Array { dims, sizes }
            }
        };
        Self { name, base, shape }
    }

    pub(super) fn init(&self) -> PartInit {
        PartInit { kind: Kind::builtin(self.base, None).into(), shape: self.shape.clone(), values: Vec::new() }
    }
}

impl<'t> Line<'t> {
    pub(super) fn parse(text: &'t str) -> Self {
        let (head, arguments) = text.strip_suffix(')').and_then(|text| text.split_once('(')).unwrap();
        let (target, name) = match head.split_once('=') {
            Some((target, name)) => (Some(Spoken::parse(target)), name),
            None => (None, head),
        };
        Self { target, name, arguments: parts(arguments).into_iter().map(Spoken::parse).collect() }
    }
}

impl<'t> Spoken<'t> {
    fn parse(text: &'t str) -> Self {
        let text = text.trim();
        let within = |open, close| text.strip_prefix(open).and_then(|text| text.strip_suffix(close));
        if let Some(text) = within('"', '"') {
            return Self::Text(text);
        }
        if let Some(numbers) = within('{', '}') {
            return Self::Structure(numbers.split(',').map(|number| number.parse().unwrap()).collect());
        }
        match (text, text.parse()) {
            ("true" | "false", _) => Self::Bool(text == "true"),
            (_, Ok(number)) => Self::Num(number),
            (_, Err(_)) => {
                let (name, at) = indexed(text);
                Self::Name(name, at)
            }
        }
    }
}

fn indexed(text: &str) -> (&str, SlotAt) {
    let Some((name, at)) = text.strip_suffix(']').and_then(|text| text.split_once('[')) else {
        return (text, SlotAt::Whole);
    };
    if let Some(key) = at.strip_prefix('"').and_then(|at| at.strip_suffix('"')) {
        return (name, SlotAt::Key(Text::from(key)));
    }
    let mut indexes = [0.0; 3];
    let count = at.split(',').zip(&mut indexes).map(|(text, index)| *index = text.parse().unwrap()).count();
    (name, SlotAt::Index(indexes, u8::try_from(count).unwrap()))
}

/// What stands between commas that are in no quotes, braces or brackets.
fn parts(text: &str) -> Vec<&str> {
    let (mut depth, mut quoted) = (0, false);
    let split = text.split(|character| {
        match character {
            '"' => quoted = !quoted,
            '{' | '[' if !quoted => depth += 1,
            '}' | ']' if !quoted => depth -= 1,
            _ => {}
        }
        character == ',' && depth == 0 && !quoted
    });
    if text.is_empty() { Vec::new() } else { split.collect() }
}

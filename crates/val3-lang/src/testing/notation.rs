//! Parser for declarations and calls in tests.

use std::collections::BTreeMap;

use crate::memory::{ContainerShape, PartInit, Subscript, ValueType};
use crate::types::BaseType;
use crate::values::Text;

/// A declaration: `num nGrid[4,6]`.
pub(super) struct VariableNotation<'t> {
    pub(super) name: &'t str,
    pub(super) base: BaseType,
    pub(super) shape: ContainerShape,
}

/// A call, or the assignment of a call: `pNear=appro(pPick,{0,0,-100,0,0,0})`.
pub(super) struct WrittenCall<'t> {
    pub(super) target: Option<WrittenArgument<'t>>,
    pub(super) name: &'t str,
    pub(super) arguments: Vec<WrittenArgument<'t>>,
}

/// An argument as written in code.
pub(super) enum WrittenArgument<'t> {
    Num(f64),
    Text(&'t str),
    Bool(bool),
    /// Numbers in braces.
    Structure(Vec<f64>),
    /// A variable with its index or key.
    Name(&'t str, WrittenSubscript),
}

impl<'t> VariableNotation<'t> {
    pub(super) fn parse(text: &'t str) -> Self {
        let (base, name) = text.split_once(' ').unwrap();
        let base = BaseType::DECLARABLE.into_iter().find(|found| found.name() == base).unwrap();
        let (name, at) = indexed(name);
        let shape = match at {
            Subscript::Whole => ContainerShape::ELEMENT,
            Subscript::Key(_) => ContainerShape::Collection(BTreeMap::new()),
            Subscript::One(size) => ContainerShape::array(size as u32),
            Subscript::Two([x, y]) => ContainerShape::Array { dims: 2, sizes: [x as u32, y as u32, 1] },
            Subscript::Three(sizes) => ContainerShape::Array { dims: 3, sizes: sizes.map(|size| size as u32) },
        };
        Self { name, base, shape }
    }

    pub(super) fn init(&self) -> PartInit {
        PartInit { kind: ValueType::builtin(self.base, None).into(), shape: self.shape.clone(), values: Vec::new() }
    }
}

impl<'t> WrittenCall<'t> {
    pub(super) fn parse(text: &'t str) -> Self {
        let (head, arguments) = text.strip_suffix(')').and_then(|text| text.split_once('(')).unwrap();
        let (target, name) = match head.split_once('=') {
            Some((target, name)) => (Some(WrittenArgument::parse(target)), name),
            None => (None, head),
        };
        Self { target, name, arguments: parts(arguments).into_iter().map(WrittenArgument::parse).collect() }
    }
}

impl<'t> WrittenArgument<'t> {
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

/// An index or key as written in a line.
pub(super) type WrittenSubscript = Subscript<f64, Text>;

fn indexed(text: &str) -> (&str, WrittenSubscript) {
    let Some((name, at)) = text.strip_suffix(']').and_then(|text| text.split_once('[')) else {
        return (text, Subscript::Whole);
    };
    if let Some(key) = at.strip_prefix('"').and_then(|at| at.strip_suffix('"')) {
        return (name, Subscript::Key(Text::from(key)));
    }
    let indexes: Vec<f64> = at.split(',').map(|text| text.parse().unwrap()).collect();
    let at = match *indexes {
        [index] => Subscript::One(index),
        [i, j] => Subscript::Two([i, j]),
        [i, j, k] => Subscript::Three([i, j, k]),
        _ => panic!("{text} has too many indexes"),
    };
    (name, at)
}

/// Splits a text at commas outside of quotes, braces and brackets.
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

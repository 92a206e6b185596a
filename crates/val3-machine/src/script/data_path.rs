//! Data paths in scripts and expectations: `nCount`, `nCounts[2]`, `part:sNames["a"]`, `tState.nDone[1]`,
//! `pPick[3].trsf.x`.

use val3_lang::memory::{KindBase, Lanes, Place, StoreId, ValueType, field_offset};
use val3_lang::types::{self, BaseType};

use crate::controller::Controller;

/// Resolved data path.
pub(super) struct Located<'p> {
    /// Container of the value.
    pub(super) store: StoreId,
    /// The path of the container.
    pub(super) container: &'p str,
    /// The index or key in the container, without quotes.
    pub(super) index: Option<&'p str>,
    /// Lanes before the field of a built-in type.
    offset: Lanes,
    /// Type of the value; `None` for a user type.
    pub(super) base: Option<BaseType>,
}

/// Unresolved part of a path.
pub(super) enum Lost<'p> {
    /// The variable at the beginning does not exist.
    Variable(&'p str),
    /// The value has no field with this name. Contains the names of the existing fields.
    Field(&'p str, Vec<String>),
    /// The container with this path has no value with this index or key.
    Index(&'p str, Option<&'p str>),
}

impl Controller {
    /// Resolves a path.
    pub(super) fn locate<'p>(&self, path: &'p str) -> Result<Located<'p>, Lost<'p>> {
        let (first, mut rest) = split_field(path);
        let (name, mut index) = split_index(first);
        let mut container = name;
        let mut store = self.data(name).ok_or(Lost::Variable(name))?;
        loop {
            let found = self.vm.space.memory.store(store).map_err(|_| Lost::Variable(name))?;
            let Some(next) = rest else {
                return Ok(Located { store, container, index, offset: Lanes::default(), base: found.kind.base_type() });
            };
            if let KindBase::Builtin(..) = found.kind.base {
                let (base, offset) = built_in_field(&found.kind, next)?;
                return Ok(Located { store, container, index, offset, base: Some(base) });
            }
            let number = found.number_of_text(index.unwrap_or("0")).ok_or(Lost::Index(container, index))?;
            let (field, after) = split_field(next);
            let (name, at) = split_index(field);
            let fields = &found.kind.fields;
            let position = fields.iter().position(|known| known.name == name);
            let unknown = || Lost::Field(name, fields.iter().map(|field| field.name.clone()).collect());
            let position = position.ok_or_else(unknown)?;
            store = *found.parts.get((number * found.kind.size.part) as usize + position).ok_or_else(unknown)?;
            container = up_to(path, name);
            (index, rest) = (at, after);
        }
    }

    /// Returns the place and type of the value at a path.
    pub(crate) fn variable(&self, path: &str) -> Option<(Place, BaseType)> {
        let Located { store, index, offset, base, .. } = self.locate(path).ok()?;
        let found = self.vm.space.memory.store(store).ok()?;
        let number = found.number_of_text(index.unwrap_or("0"))?;
        Some((found.place(store, number).after(offset), base?))
    }
}

/// Returns the type of a built-in type's field, and the lanes before it.
fn built_in_field<'p>(kind: &ValueType, path: &'p str) -> Result<(BaseType, Lanes), Lost<'p>> {
    let KindBase::Builtin(mut base, arm) = kind.base else { return Err(Lost::Field(path, Vec::new())) };
    let mut offset = Lanes::default();
    for name in path.split('.') {
        let Some((field, before)) = types::field(base, arm, name).zip(field_offset(base, arm, name)) else {
            let known = types::fields(base, arm).iter().map(|field| field.name.to_owned()).collect();
            return Err(Lost::Field(name, known));
        };
        (base, offset) = (field.ty, offset + before);
    }
    Ok((base, offset))
}

/// Splits a path after its first part. Dots in keys are no separators.
fn split_field(path: &str) -> (&str, Option<&str>) {
    let (mut is_key, mut depth) = (false, 0);
    let dot = path.find(|c| {
        match c {
            '"' => is_key = !is_key,
            '[' if !is_key => depth += 1,
            ']' if !is_key => depth -= 1,
            _ => {}
        }
        c == '.' && !is_key && depth == 0
    });
    dot.map_or((path, None), |dot| (path.get(..dot).unwrap_or(path), path.get(dot + 1..)))
}

/// Returns the variable at the beginning of a path.
pub(super) fn root(path: &str) -> &str {
    split_index(split_field(path).0).0
}

/// Splits a part into the name of the variable or field, and the index or key without quotes.
fn split_index(name: &str) -> (&str, Option<&str>) {
    match name.strip_suffix(']').and_then(|name| name.split_once('[')) {
        Some((name, at)) => (name, Some(at.trim_matches('"'))),
        None => (name, None),
    }
}

/// Returns the beginning of a path up to the end of `part`, which must be a slice of the path.
fn up_to<'p>(path: &'p str, part: &'p str) -> &'p str {
    let end = part.as_ptr().addr() - path.as_ptr().addr() + part.len();
    path.get(..end).unwrap_or(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_in_keys_separate_nothing() {
        assert_eq!(split_field("nA"), ("nA", None));
        assert_eq!(split_field("tA[1].sB[\"x.y\"].nC"), ("tA[1]", Some("sB[\"x.y\"].nC")));
        assert_eq!(split_field("sB[\"x.y\"].nC"), ("sB[\"x.y\"]", Some("nC")));
        assert_eq!(split_index("sB[\"x.y\"]"), ("sB", Some("x.y")));
        let path = "tA[1].sB[2]";
        assert_eq!(up_to(path, split_index(split_field(path).1.unwrap()).0), "tA[1].sB");
    }
}

//! Placement of positions in a tree: their chains of fathers.

use std::collections::BTreeSet;
use std::rc::Rc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::placement::shown;
use val3_geometry::Trsf;
use val3_lang::builtins;
use val3_syntax::TextSlice;

use crate::read::data::DataVersion;
use crate::read::value::FileValue;

/// Maximum number of fathers in a chain. Real chains have up to five.
const LONGEST: usize = 100;

/// Frames, tools and points of both trees.
#[derive(Debug)]
pub(super) struct Places<'a> {
    pub(super) old: TreePositions<'a>,
    pub(super) new: TreePositions<'a>,
    /// Old paths of array elements whose index differs, by new path; `None` for an inserted element.
    origins: FxHashMap<SmolStr, Option<SmolStr>>,
}

impl<'a> Places<'a> {
    /// Creates the positions of both trees, with equal paths.
    pub(super) fn new(old: TreePositions<'a>, new: TreePositions<'a>) -> Self {
        Self { old, new, origins: FxHashMap::default() }
    }

    /// Sets the old path if the index of an element differs; `None` for an inserted element.
    pub(super) fn set_origin(&mut self, path: SmolStr, old: Option<SmolStr>) {
        self.origins.insert(path, old);
    }

    /// Returns the old path of the position at a new path; `None` if the position does not exist in the old tree.
    pub(super) fn origin(&self, path: &SmolStr) -> Option<SmolStr> {
        let old = self.origins.get(path).map_or_else(|| Some(path.clone()), Clone::clone)?;
        self.old.value(&old).map(|_| old)
    }
}

/// Frames, tools and points of a tree.
#[derive(Debug)]
pub(super) struct TreePositions<'a> {
    values: FxHashMap<&'a str, &'a FileValue>,
    /// Length unit in mm.
    unit: f64,
    /// Known chains of fathers; `None` if a chain does not end at `world` or the flange.
    chains: FxHashMap<SmolStr, Option<Rc<Chain>>>,
    loops: BTreeSet<String>,
}

/// Chain from a position through its fathers to `world` or the flange.
#[derive(Debug, Default)]
pub(super) struct Chain {
    /// Transformations from the position outwards, in mm.
    pub(super) links: Vec<Trsf>,
    /// Data paths of the values.
    pub(super) names: Vec<SmolStr>,
}

impl<'a> TreePositions<'a> {
    /// Collects the positions in `data`.
    pub(super) fn new(data: &'a [DataVersion], unit: f64) -> Self {
        let values = data.iter().flat_map(|data| &data.values).filter(|(_, value)| value.ty.has_father());
        let values = values.map(|(path, value)| (path.as_str(), value)).collect();
        Self { values, unit, chains: FxHashMap::default(), loops: BTreeSet::new() }
    }

    /// Returns the position at a path.
    pub(super) fn value(&self, path: &str) -> Option<&'a FileValue> {
        self.values.get(path).copied()
    }

    /// Returns the length unit in mm.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// Returns the transformation of a value in mm.
    pub(super) fn transformation(&self, value: &FileValue) -> Option<Trsf> {
        value.transformation().map(|found| found.scaled(self.unit))
    }

    /// Returns the chain of a position; `None` if it does not end at `world` or the flange.
    pub(super) fn chain(&mut self, path: &str) -> Option<Chain> {
        let value = self.value(path)?;
        let fathers = self.fathers(value.father()?)?;
        let mut chain = Chain { links: vec![self.transformation(value)?], names: vec![path.into()] };
        chain.links.extend_from_slice(&fathers.links);
        chain.names.extend_from_slice(&fathers.names);
        Some(chain)
    }

    /// Returns the chain from the father at `path` on. It is cached, because many positions share it.
    pub(super) fn fathers(&mut self, path: &SmolStr) -> Option<Rc<Chain>> {
        let (mut open, mut next): (Vec<SmolStr>, SmolStr) = (Vec::new(), path.clone());
        let mut found = loop {
            if is_built_in(&next) {
                break Some(Rc::default());
            }
            if let Some(known) = self.chains.get(&next) {
                break known.clone();
            }
            if let Some(start) = open.iter().position(|name| *name == next) {
                self.add_loop(open.part(start..));
                break None;
            }
            let father = self.value(&next).and_then(FileValue::father).filter(|_| open.len() < LONGEST).cloned();
            open.push(next);
            match father {
                Some(father) => next = father,
                None => break None,
            }
        };
        for name in open.into_iter().rev() {
            let link = self.value(&name).and_then(|value| self.transformation(value));
            found = found.zip(link).map(|(outer, link)| Rc::new(outer.with(name.clone(), link)));
            self.chains.insert(name, found.clone());
        }
        found
    }

    fn add_loop(&mut self, names: &[SmolStr]) {
        // The loop starts at its smallest name, so that it is reported only once.
        let start = (0..names.len()).min_by_key(|index| names.get(*index)).unwrap_or(0);
        let names = names.iter().cycle().skip(start).take(names.len() + 1);
        self.loops.insert(names.map(|name| shown(name)).collect::<Vec<_>>().join(" → "));
    }

    /// Returns a message for each detected loop of fathers.
    pub(super) fn loops(self) -> impl Iterator<Item = String> + 'a {
        const HELP: &str = "link one of them to another frame";
        let loops = self.loops.into_iter();
        loops.map(|names| format!("the fathers {names} form a loop, so movements in `world` are unknown; {HELP}"))
    }
}

impl Chain {
    /// Returns the chain of a position whose father starts this chain.
    fn with(&self, name: SmolStr, link: Trsf) -> Self {
        let links = std::iter::once(link).chain(self.links.iter().copied()).collect();
        Self { links, names: std::iter::once(name).chain(self.names.iter().cloned()).collect() }
    }
}

/// Whether the data path is `world` or `flange`, where every chain ends.
fn is_built_in(path: &str) -> bool {
    let name = path.strip_suffix("[0]").unwrap_or(path);
    builtins::find(name).is_some_and(|builtin| builtin.is_variable)
}

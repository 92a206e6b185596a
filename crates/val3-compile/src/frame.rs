//! Stack frame of a program: locations of variables, constants, and registers for temporary values.
//!
//! A parameter or local that is a single value of a built-in type is stored in lanes; local arrays and values of user
//! types are containers. Temporaries of a statement are released when the statement ends.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_bytecode::{ContainerKind, ContainerRef, FrameSize, Register, Storage};
use val3_lang::memory::{ContainerShape, Lanes, PartInit, ValueType};

use crate::error::{CompileLimit, Result};
use crate::layout::{FrameLayout, LayoutKeeper};
use crate::pool::Pool;

/// Frame under construction.
#[derive(Debug, Default)]
pub(crate) struct Frame {
    scope: FxHashMap<SmolStr, Storage>,
    registers: Registers,
    nums: Vec<f64>,
    /// Layout that is recorded; `None` if no line will be replaced.
    keeper: Option<Box<LayoutKeeper>>,
    /// Whether the frame belongs to a fragment, which uses the variables of a program.
    pub(crate) is_fragment: bool,
    /// Initial containers.
    pub(crate) parts: Vec<PartInit>,
}

/// Registers in use at a statement.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Registers {
    pub(crate) pools: [Pool; 5],
    taken: Vec<(Sort, u32, u32)>,
    constants: FxHashMap<u64, Register>,
    pairs: FxHashMap<[u64; 2], Register>,
}

/// A complete frame.
pub(crate) struct Finished {
    pub(crate) size: FrameSize,
    /// Initial numbers.
    pub(crate) nums: Vec<f64>,
    /// Initial containers.
    pub(crate) parts: Vec<PartInit>,
    /// Recorded layout.
    pub(crate) layout: Option<FrameLayout>,
}

/// Kind of register.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sort {
    Num,
    Text,
    Link,
    Place,
    View,
}

/// Number of temporaries at the beginning of a statement.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TemporaryMark(usize);

impl Frame {
    /// Returns the location of a parameter or local.
    pub(crate) fn find(&self, name: &str) -> Option<Storage> {
        self.scope.get(name).copied()
    }

    /// Declares a parameter or local. If a name is declared twice, the last declaration counts.
    pub(crate) fn declare(&mut self, name: SmolStr, storage: Storage) {
        self.scope.insert(name, storage);
    }

    fn pool(&mut self, sort: Sort) -> &mut Pool {
        let [num, text, link, place, view] = &mut self.registers.pools;
        match sort {
            Sort::Num => num,
            Sort::Text => text,
            Sort::Link => link,
            Sort::Place => place,
            Sort::View => view,
        }
    }

    /// Reserves permanent lanes with a default value, for a variable or for a value whose links stay empty.
    pub(crate) fn lasting(&mut self, kind: &ValueType) -> Result<Lanes> {
        let num = self.pool(Sort::Num).grow(kind.size.num)?;
        for (at, value) in (num..).zip(&kind.default.nums) {
            self.preset(at, *value);
        }
        let text = self.pool(Sort::Text).grow(kind.size.text)?;
        let link = self.pool(Sort::Link).grow(kind.size.link)?;
        Ok(Lanes { num, text, link, part: 0 })
    }

    /// Reserves a permanent place: a parameter by reference.
    pub(crate) fn lasting_place(&mut self) -> Result<Register> {
        self.pool(Sort::Place).grow(1).map(narrow)
    }

    /// Reserves a permanent view: a container by reference.
    pub(crate) fn lasting_view(&mut self) -> Result<Register> {
        self.pool(Sort::View).grow(1).map(narrow)
    }

    /// Adds a container to the frame.
    pub(crate) fn part(&mut self, kind: Arc<ValueType>, shape: ContainerShape) -> Result<u16> {
        let number = u16::try_from(self.parts.len()).map_err(|_| CompileLimit::Containers)?;
        ContainerRef::new(ContainerKind::Part(number)).ok_or(CompileLimit::Containers)?;
        self.parts.push(PartInit { kind, shape, values: Vec::new() });
        Ok(number)
    }

    /// Returns the register with a constant number.
    pub(crate) fn constant(&mut self, value: f64) -> Result<Register> {
        if let Some(known) = self.registers.constants.get(&value.to_bits()) {
            return Ok(*known);
        }
        let at = self.pool(Sort::Num).grow(1)?;
        self.preset(at, value);
        self.registers.constants.insert(value.to_bits(), narrow(at));
        Ok(narrow(at))
    }

    /// Returns the first of the two consecutive registers with these constant numbers.
    pub(crate) fn constant_pair(&mut self, values: [f64; 2]) -> Result<Register> {
        let key = values.map(f64::to_bits);
        if let Some(known) = self.registers.pairs.get(&key) {
            return Ok(*known);
        }
        let at = self.pool(Sort::Num).grow(2)?;
        (at..).zip(values).for_each(|(at, value)| self.preset(at, value));
        self.registers.pairs.insert(key, narrow(at));
        Ok(narrow(at))
    }

    /// Returns the size of a call on the stack that a project declares, in bytes. Valid only while the frame contains
    /// nothing but parameters and locals. The manual does not specify the size of a value. Assumed are 8 bytes for a
    /// number, 132 for a string, and 16 for a reference, a container or the return address.
    pub(crate) fn bytes(&self) -> u32 {
        let [num, text, link, place, view] = &self.registers.pools;
        let references = link.size() + place.size() + view.size();
        let parts = self.parts.iter().map(part_bytes).fold(0u32, u32::saturating_add);
        let own = Lanes { num: num.size(), text: text.size(), link: references, part: 0 };
        REFERENCE_BYTES.saturating_add(lane_bytes(own)).saturating_add(parts)
    }

    fn preset(&mut self, at: u32, value: f64) {
        let least = at as usize + 1;
        if self.nums.len() < least {
            self.nums.resize(least, 0.0);
        }
        if let Some(slot) = self.nums.get_mut(at as usize) {
            *slot = value;
        }
    }

    fn take(&mut self, sort: Sort, count: u32) -> Result<u32> {
        let start = self.pool(sort).take(count)?;
        self.registers.taken.push((sort, start, count));
        Ok(start)
    }

    /// Reserves a temporary number.
    pub(crate) fn num(&mut self) -> Result<Register> {
        self.nums(1)
    }

    /// Reserves consecutive temporary numbers.
    pub(crate) fn nums(&mut self, count: u32) -> Result<Register> {
        self.take(Sort::Num, count).map(narrow)
    }

    /// Reserves a temporary string.
    pub(crate) fn text(&mut self) -> Result<Register> {
        self.take(Sort::Text, 1).map(narrow)
    }

    /// Reserves a temporary place.
    pub(crate) fn place(&mut self) -> Result<Register> {
        self.take(Sort::Place, 1).map(narrow)
    }

    /// Reserves a temporary view.
    pub(crate) fn view(&mut self) -> Result<Register> {
        self.take(Sort::View, 1).map(narrow)
    }

    /// Reserves a temporary value of a built-in type, with undefined content.
    pub(crate) fn value(&mut self, size: Lanes) -> Result<Lanes> {
        let num = self.take(Sort::Num, size.num)?;
        let text = self.take(Sort::Text, size.text)?;
        let link = self.take(Sort::Link, size.link)?;
        Ok(Lanes { num, text, link, part: 0 })
    }

    /// Returns the present number of temporaries, for [`release`](Self::release).
    pub(crate) fn mark(&self) -> TemporaryMark {
        TemporaryMark(self.registers.taken.len())
    }

    /// Releases the temporaries after `mark`.
    pub(crate) fn release(&mut self, mark: TemporaryMark) {
        for (sort, start, count) in self.registers.taken.split_off(mark.0.min(self.registers.taken.len())) {
            self.pool(sort).give(start, count);
        }
    }

    /// Records the layout of the frame, or keeps the layout of another frame with these initial numbers.
    pub(crate) fn keep_layout(&mut self, keeper: LayoutKeeper, nums: Vec<f64>) {
        (self.keeper, self.nums) = (Some(Box::new(keeper)), nums);
    }

    /// Whether the layout is recorded.
    pub(crate) const fn keeps_layout(&self) -> bool {
        self.keeper.is_some()
    }

    /// Begins a part of the code at a row of the file. `has_lasting_values`: whether it uses temporaries of its own
    /// after other lines.
    pub(crate) fn begin_step(&mut self, row: u32, has_lasting_values: bool) {
        if let Some(keeper) = &mut self.keeper {
            keeper.begin_step(row, has_lasting_values, &mut self.registers);
        }
    }

    /// Returns the frame's size and initial values.
    pub(crate) fn finish(mut self) -> Finished {
        let pools = self.registers.pools.map(|pool| pool.size());
        let least = self.keeper.as_ref().map_or([0; 5], |keeper| keeper.least_sizes());
        let [num, text, link, place, view] = std::array::from_fn(|sort| largest(&[pools, least], sort));
        let part = u32::try_from(self.parts.len()).unwrap_or(u32::MAX);
        self.nums.resize(num as usize, 0.0);
        let size = FrameSize { lanes: Lanes { num, text, link, part }, places: place, views: view };
        let layout = self.keeper.map(|keeper| keeper.finish());
        Finished { size, nums: self.nums, parts: self.parts, layout }
    }
}

fn largest(sizes: &[[u32; 5]; 2], sort: usize) -> u32 {
    sizes.iter().filter_map(|sizes| sizes.get(sort)).copied().max().unwrap_or_default()
}

const REFERENCE_BYTES: u32 = 16;

fn lane_bytes(lanes: Lanes) -> u32 {
    let texts = lanes.text.saturating_mul(132);
    let references = lanes.link.saturating_mul(REFERENCE_BYTES);
    lanes.num.saturating_mul(8).saturating_add(texts).saturating_add(references)
}

/// Returns the size of a container with its values and nested containers, in bytes.
fn part_bytes(part: &PartInit) -> u32 {
    let inner = part.kind.fields.iter().map(|field| part_bytes(&field.init)).fold(0u32, u32::saturating_add);
    let value = lane_bytes(part.kind.size).saturating_add(inner);
    REFERENCE_BYTES.saturating_add(value.saturating_mul(part.shape.len()))
}

/// Converts a register number; pools return no higher numbers.
pub(crate) fn narrow(register: u32) -> Register {
    Register::try_from(register).unwrap_or(Register::MAX)
}

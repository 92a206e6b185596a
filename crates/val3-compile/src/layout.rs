//! Frame layout that stays the same when a line is replaced, so that tasks within the program can continue.
//!
//! The layout contains the registers in use before each statement and condition, and after each block. When the program is
//! compiled with another line, all parts except this line begin with the same registers as before. The line itself uses
//! registers after all others.

use std::vec;

use val3_analysis::db::File;
use val3_bytecode::{FrameSize, Image, Program};

use crate::frame::Registers;
use crate::pool::Pool;

/// Row of the end of a block, which belongs to no line.
pub(crate) const BLOCK_END: u32 = 0;

/// Registers of a program before each part of its code.
#[derive(Debug, Clone, Default)]
pub struct FrameLayout {
    steps: Vec<LayoutStep>,
    /// Whether all parts but the replaced line have the registers of the other layout.
    is_kept: bool,
}

/// Registers before a part of the code.
#[derive(Debug, Clone)]
struct LayoutStep {
    /// Row of the file, or [`BLOCK_END`].
    row: u32,
    registers: Registers,
    /// Whether the registers do not result from the previous part, because one of both was replaced.
    is_apart: bool,
}

impl FrameLayout {
    /// Whether a frame of the program before the replacement fits the program after it.
    #[must_use]
    pub const fn is_kept(&self) -> bool {
        self.is_kept
    }
}

/// Program whose layout is recorded.
#[derive(Debug, Clone, Copy)]
pub struct LayoutRequest<'a> {
    /// File of the program.
    pub file: File,
    /// Image of the project in memory. Library items keep their numbers.
    pub image: &'a Image,
    /// Replaced line whose program keeps its layout; `None` for a new layout.
    pub replaced: Option<ReplacedLine<'a>>,
}

/// Replaced line of a program.
#[derive(Debug, Clone, Copy)]
pub struct ReplacedLine<'a> {
    /// Row of the file, from 1.
    pub row: u32,
    /// Program before the replacement.
    pub program: &'a Program,
    /// Layout of this program.
    pub layout: &'a FrameLayout,
}

/// Recorder of a layout while a program is compiled.
#[derive(Debug, Default)]
pub(crate) struct LayoutKeeper {
    recorded: Vec<LayoutStep>,
    kept: Option<KeptLayout>,
    has_changed: bool,
}

/// Result of the beginning of a part.
struct KeptStep {
    /// Whether the program keeps its layout so far.
    is_kept: bool,
    /// Whether the registers do not result from the previous part.
    is_apart: bool,
}

/// Layout of the program before a replacement.
#[derive(Debug)]
struct KeptLayout {
    /// Replaced row.
    row: u32,
    /// Steps of all other rows, each with whether it follows the replaced row.
    steps: vec::IntoIter<(LayoutStep, bool)>,
    /// Registers of the replaced line.
    apart: [Pool; 5],
    /// Whether the present part belongs to the replaced line.
    is_apart: bool,
}

impl LayoutKeeper {
    /// Recorder for a request.
    pub(crate) fn new(replaced: Option<ReplacedLine<'_>>) -> Self {
        Self { kept: replaced.map(KeptLayout::new), ..Self::default() }
    }

    /// Begins a part of the code at a row.
    pub(crate) fn begin_step(&mut self, row: u32, has_lasting_values: bool, registers: &mut Registers) {
        let mut is_apart = false;
        if let Some(kept) = &mut self.kept {
            let step = kept.begin_step(row, has_lasting_values, registers);
            self.has_changed |= !step.is_kept;
            is_apart = step.is_apart;
        }
        self.recorded.push(LayoutStep { row, registers: registers.clone(), is_apart });
    }

    /// Least numbers of registers.
    pub(crate) fn least_sizes(&self) -> [u32; 5] {
        self.kept.as_ref().map_or([0; 5], |kept| kept.apart.each_ref().map(Pool::size))
    }

    /// Ends the program.
    pub(crate) fn finish(self) -> FrameLayout {
        let is_complete = self.kept.is_some_and(|mut kept| kept.steps.next().is_none());
        FrameLayout { steps: self.recorded, is_kept: is_complete && !self.has_changed }
    }
}

impl KeptLayout {
    fn new(ReplacedLine { row, program, layout }: ReplacedLine<'_>) -> Self {
        let mut steps = Vec::with_capacity(layout.steps.len());
        let mut follows = false;
        for step in &layout.steps {
            let is_replaced = step.row == row;
            if !is_replaced {
                steps.push((step.clone(), follows));
            }
            follows = is_replaced;
        }
        let FrameSize { lanes, places, views } = program.frame;
        let apart = [lanes.num, lanes.text, lanes.link, places, views].map(Pool::after);
        Self { row, steps: steps.into_iter(), apart, is_apart: false }
    }

    /// Sets the registers for a part of the code.
    fn begin_step(&mut self, row: u32, has_lasting_values: bool, registers: &mut Registers) -> KeptStep {
        if row == self.row {
            let was_apart = std::mem::replace(&mut self.is_apart, true);
            if !was_apart {
                registers.pools = std::mem::take(&mut self.apart);
            }
            return KeptStep { is_kept: !has_lasting_values, is_apart: !was_apart };
        }
        let was_apart = std::mem::take(&mut self.is_apart);
        if was_apart {
            self.apart = std::mem::take(&mut registers.pools);
        }
        let Some((step, follows)) = self.steps.next() else { return KeptStep { is_kept: false, is_apart: was_apart } };
        let is_apart = was_apart || follows || step.is_apart;
        let is_same = is_apart || *registers == step.registers;
        *registers = step.registers;
        KeptStep { is_kept: is_same && step.row == row, is_apart }
    }
}

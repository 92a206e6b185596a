//! What is found out about a program before its code is written.

use std::collections::BTreeMap;

use val3_bytecode::{Program, Register};

use crate::body::Surroundings;
use crate::calls::callee;
use crate::fill::{Fill, fills};
use crate::flow::Flow;
use crate::inline::Becomes;
use crate::lanes::{Lane, Lanes};
use crate::operations::has_code;
use crate::regions::Regions;
use crate::sorts::Sorts;
use crate::temporaries::Temporaries;
use crate::whole::WholeNumbers;

/// What is found out about a program.
pub(crate) struct Study {
    pub(crate) lanes: Lanes,
    pub(crate) regions: Regions,
    pub(crate) flow: Flow,
    pub(crate) whole: WholeNumbers,
    pub(crate) sorts: Sorts,
    pub(crate) temporaries: Temporaries,
    /// The loops that fill arrays, by their heads.
    pub(crate) fills: BTreeMap<u32, Fill>,
}

impl Study {
    /// Calls become the code of what they call on so many [levels](crate::inline::levels).
    pub(crate) fn of(module: &Surroundings<'_>, program: &Program, levels: u32) -> Self {
        let lanes = Lanes::of(program, module.image);
        let whole = WholeNumbers::of(program, module.image, &lanes);
        let calls_function = |op| callee(module, program, op).is_some_and(|call| call.becomes(levels) != Becomes::Code);
        let flow = Flow::of(program, |op| has_code(module, program, op), calls_function);
        let sorts = Sorts::of(program, module.image, &lanes);
        let fills = fills(program, module.image, module.shared);
        let temporaries = Temporaries::of(program, module.image, &lanes);
        Self { lanes, regions: Regions::of(program), flow, whole, sorts, temporaries, fills }
    }

    /// Whether the program can be entered with these numbers in its frame: the interpreter may have put anything in
    /// its registers.
    pub(crate) fn suits(&self, numbers: &[f64]) -> bool {
        let lasting = |register: &Register| !self.temporaries.has(*register);
        self.whole.suit(numbers, lasting) && self.sorts.suit(numbers, lasting)
    }

    /// The numbers of a frame but for temporaries.
    pub(crate) fn lasting(&self) -> impl Iterator<Item = (Register, Lane)> {
        self.lanes.iter().filter(|(register, _)| !self.temporaries.has(*register))
    }
}

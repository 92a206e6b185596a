//! The frame of a program within a function: where it is in memory, and which variables have what is in it.

use wasm_encoder::ValType;

use crate::draft::Draft;
use crate::lanes::Lane;
use crate::local::{GIVEN, NUMBERS_GIVEN};
use crate::sorts::Sort;
use crate::study::Study;

/// The frame of a program within a function.
pub(crate) struct Frame {
    /// How far behind the frame of the function it is, in bytes: numbers, places, and of the declared stack.
    pub(crate) numbers: u32,
    pub(crate) places: u32,
    pub(crate) taken: u32,
    /// The variables of its [lanes](crate::lanes::Lane).
    pub(crate) variables: Vec<u32>,
    /// The variable with the line at hand.
    pub(crate) line: u32,
    /// What its places refer to, where the function knows it.
    pub(crate) references: Vec<Option<Reference>>,
    /// How far calls become code: [`inline::levels`](crate::inline::levels).
    pub(crate) levels: u32,
}

/// What a parameter by reference refers to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Reference {
    /// A number whose address is in a variable.
    Address(u32),
    /// Numbers of a frame of the function.
    Variables(Variables),
}

/// Numbers of a frame of the function, which are in variables and have a place in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Variables {
    /// Where they are in memory, in bytes from the frame of the function on.
    pub(crate) at: u32,
    pub(crate) numbers: Vec<u32>,
}

impl Frame {
    /// The frame of the program that the function belongs to.
    pub(crate) fn of_function(study: &Study, levels: u32, draft: &mut Draft) -> Self {
        let mut frame = Self::new(study, levels, draft);
        frame.variables.iter_mut().zip(GIVEN..GIVEN + NUMBERS_GIVEN).for_each(|(variable, given)| *variable = given);
        frame
    }

    /// A frame with variables of its own.
    pub(crate) fn new(study: &Study, levels: u32, draft: &mut Draft) -> Self {
        let line = draft.variable(ValType::I32);
        let mut sorts = vec![Sort::Number; study.lanes.variables() as usize];
        for (register, lane) in study.lanes.iter() {
            if let Lane::Variable(number) = lane
                && let Some(sort) = sorts.get_mut(number as usize)
            {
                *sort = study.sorts.get(register);
            }
        }
        let variables = sorts.into_iter().map(|sort| draft.variable(sort.kind())).collect();
        Self { numbers: 0, places: 0, taken: 0, variables, line, references: Vec::new(), levels }
    }

    /// Whether its program is part of the function of another: every frame takes some of the declared stack.
    pub(crate) fn is_inlined(&self) -> bool {
        self.taken > 0
    }

    /// The variable of a lane.
    pub(crate) fn variable(&self, number: u32) -> u32 {
        self.variables.get(number as usize).copied().unwrap_or_default()
    }

    /// What a place refers to; `None` where only memory knows.
    pub(crate) fn reference(&self, place: u32) -> Option<&Reference> {
        self.references.get(place as usize)?.as_ref()
    }
}

//! The containers that programs name, where their descriptions are, and how wide their values.

use val3_bytecode::{Image, ImportKind, Program, Storage, Whole, WholeKind};
use val3_lang::memory::{Kind, KindBase, Lanes};
use val3_lang::types::BaseType;

use crate::layout::{CONTAINER, CONTAINERS, OWN, SHARED};

/// The containers that all programs of a module share, each with a description of its own.
#[derive(Debug, Default)]
pub(crate) struct Shared(Vec<Whole>);

impl Shared {
    /// Takes a container in if it is shared; whether there is room for its description.
    pub(crate) fn add(&mut self, whole: Whole) -> bool {
        if matches!(whole.kind(), WholeKind::Data(_) | WholeKind::Import(_)) && !self.0.contains(&whole) {
            self.0.push(whole);
        }
        self.0.len() <= CONTAINERS
    }

    /// The containers, each with the address of its description.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Whole, u32)> + '_ {
        self.0.iter().copied().zip((SHARED..).step_by(CONTAINER as usize))
    }

    /// The address of the description of a container; `None` if it has none.
    pub(crate) fn description(&self, whole: Whole) -> Option<u32> {
        match whole.kind() {
            WholeKind::Part(number) => local(number),
            WholeKind::View(number) => by_reference(number),
            _ => self.iter().find(|(known, _)| *known == whole).map(|(_, address)| address),
        }
    }
}

/// The address of the description of a local container of the frame that was entered.
pub(crate) fn local(number: impl Into<u32>) -> Option<u32> {
    own(number.into() * 2)
}

/// The address of the description of a container by reference of the frame that was entered.
pub(crate) fn by_reference(number: impl Into<u32>) -> Option<u32> {
    own(number.into() * 2 + 1)
}

fn own(number: u32) -> Option<u32> {
    ((number as usize) < CONTAINERS).then_some(OWN + number * CONTAINER)
}

/// How a value of a container is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Width {
    /// A truth value in a byte: large arrays of them stay near the processor.
    Byte,
    /// Numbers of eight bytes.
    Eight,
}

impl Width {
    /// How values of a type are kept.
    pub(crate) fn of(kind: &Kind) -> Self {
        match kind.base {
            KindBase::Builtin(BaseType::Bool, _) => Self::Byte,
            _ => Self::Eight,
        }
    }

    /// What machine code takes a container for, by its declaration.
    pub(crate) fn declared(whole: WholeKind, program: &Program, image: &Image) -> Self {
        declared(whole, program, image).map_or(Self::Eight, Self::of)
    }

    /// The exponent of two of the bytes.
    pub(crate) fn shift(self) -> u32 {
        match self {
            Self::Byte => 0,
            Self::Eight => 3,
        }
    }
}

/// The type of the values that a container is declared with.
fn declared<'p>(whole: WholeKind, program: &'p Program, image: &'p Image) -> Option<&'p Kind> {
    let variable = |storage: Storage| {
        program.variables.iter().find(|variable| variable.storage == storage).map(|variable| &variable.kind)
    };
    let kind = match whole {
        WholeKind::Data(number) => image.data.get(usize::from(number)).map(|data| &data.init.kind),
        WholeKind::Import(number) => match image.imports.get(usize::from(number)).map(|import| &import.kind) {
            Some(ImportKind::Data(kind, _)) => Some(kind),
            _ => None,
        },
        WholeKind::Part(number) => variable(Storage::Part(number)),
        WholeKind::View(number) => variable(Storage::View(number)),
        WholeKind::Builtin(_) => None,
    };
    kind.map(|kind| &**kind)
}

/// Whether machine code can refer to the values of a container: they are numbers of eight bytes and nothing else.
pub(crate) fn can_refer(whole: WholeKind, program: &Program, image: &Image) -> bool {
    declared(whole, program, image)
        .is_some_and(|kind| Width::of(kind) == Width::Eight && kind.size == Lanes::nums(kind.size.num))
}

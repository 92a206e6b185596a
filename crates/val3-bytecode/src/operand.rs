//! Operands: locations of containers, strings and values.

use val3_lang::memory::{self, Lanes};

use crate::Register;

/// Packed location of a container: its kind in the upper bits, its number in the lower bits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct ContainerRef(u16);

/// Location of a container.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContainerKind {
    /// Global data of the application.
    Data(u16),
    /// A container of the frame: a local array or a local of a user type.
    Part(u16),
    /// A container by reference.
    View(u16),
    /// Data of a library.
    Import(u16),
    /// `world` (0) or `flange` (1).
    Builtin(u16),
}

/// Packed location of a string.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct TextOperand(u16);

/// Location of a string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextSource {
    /// The first value of a container that is not built in.
    First(ContainerKind),
    /// On the frame.
    Register(Register),
    /// A value that was looked up, or a parameter by reference.
    Place(Register),
    /// A read-only constant of the program.
    Constant(u16),
}

/// Bits of the number in a packed location.
const BITS: u16 = 13;
const MASK: u16 = (1 << BITS) - 1;

/// Packs a location; `None` if the number exceeds 8,191.
fn pack(tag: u16, number: u16) -> Option<u16> {
    (number <= MASK).then_some(tag << BITS | number)
}

impl ContainerRef {
    /// Packs a location; `None` if the number exceeds 8,191.
    #[must_use]
    pub fn new(kind: ContainerKind) -> Option<Self> {
        let (tag, number) = match kind {
            ContainerKind::Data(number) => (0, number),
            ContainerKind::Part(number) => (1, number),
            ContainerKind::View(number) => (2, number),
            ContainerKind::Import(number) => (3, number),
            ContainerKind::Builtin(number) => (4, number),
        };
        pack(tag, number).map(Self)
    }

    /// Returns the number if this is global data of the application, the most frequent kind.
    #[inline]
    #[must_use]
    pub fn data(self) -> Option<u16> {
        // The tag of data is 0.
        (self.0 <= MASK).then_some(self.0)
    }

    /// Unpacks the location.
    #[inline]
    #[must_use]
    pub fn kind(self) -> ContainerKind {
        let number = self.0 & MASK;
        match self.0 >> BITS {
            0 => ContainerKind::Data(number),
            1 => ContainerKind::Part(number),
            2 => ContainerKind::View(number),
            3 => ContainerKind::Import(number),
            _ => ContainerKind::Builtin(number),
        }
    }
}

impl TextOperand {
    /// Packs a location; `None` if the number exceeds 8,191, or the container is built in.
    #[must_use]
    pub fn new(source: TextSource) -> Option<Self> {
        match source {
            TextSource::First(ContainerKind::Builtin(_)) => None,
            TextSource::First(kind) => ContainerRef::new(kind).map(|container| Self(container.0)),
            TextSource::Register(number) => pack(4, number).map(Self),
            TextSource::Place(number) => pack(5, number).map(Self),
            TextSource::Constant(number) => pack(6, number).map(Self),
        }
    }

    /// Unpacks the location.
    #[inline]
    #[must_use]
    pub fn source(self) -> TextSource {
        let number = self.0 & MASK;
        match self.0 >> BITS {
            0..=3 => TextSource::First(ContainerRef(self.0).kind()),
            4 => TextSource::Register(number),
            5 => TextSource::Place(number),
            _ => TextSource::Constant(number),
        }
    }
}

impl std::fmt::Debug for ContainerRef {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.kind().fmt(f)
    }
}

impl std::fmt::Debug for TextOperand {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.source().fmt(f)
    }
}

/// Location of a value with any type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operand {
    /// On the frame.
    Frame(Lanes),
    /// In the first value of a container, from these lanes on.
    First(ContainerRef, Lanes),
    /// In a value that was looked up or is a parameter by reference, from these lanes on.
    Place(Register, Lanes),
}

/// Selection of a container element; registers contain the indexes or the key.
pub type Subscript = memory::Subscript<Register, TextOperand>;

#[cfg(test)]
mod tests {
    use super::{ContainerKind, ContainerRef, TextOperand, TextSource};

    #[test]
    fn containers_are_packed() {
        let last = [
            ContainerKind::Data(8_191),
            ContainerKind::Part(8_191),
            ContainerKind::View(8_191),
            ContainerKind::Import(8_191),
        ];
        for kind in last.into_iter().chain([ContainerKind::Data(0), ContainerKind::Builtin(1)]) {
            assert_eq!(ContainerRef::new(kind).map(ContainerRef::kind), Some(kind));
            let number = if let ContainerKind::Data(number) = kind { Some(number) } else { None };
            assert_eq!(ContainerRef::new(kind).and_then(ContainerRef::data), number);
        }
        assert_eq!(ContainerRef::new(ContainerKind::Data(8_192)), None);
    }

    #[test]
    fn texts_are_packed() {
        let containers = [ContainerKind::Data(0), ContainerKind::Part(1), ContainerKind::View(2)];
        let others = [TextSource::Register(8_191), TextSource::Place(3), TextSource::Constant(0)];
        for source in containers.map(TextSource::First).into_iter().chain(others) {
            assert_eq!(TextOperand::new(source).map(TextOperand::source), Some(source));
        }
        assert_eq!(TextOperand::new(TextSource::Constant(8_192)), None);
        assert_eq!(TextOperand::new(TextSource::First(ContainerKind::Builtin(0))), None);
    }
}

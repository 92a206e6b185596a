//! Registers, containers, strings and other values by location.

use val3_lang::memory::Lanes;
use val3_lang::number_functions::NumberFunction;
use val3_lang::values::Text;

use super::ListingForm;
use super::error::Result;
use super::reader::{Label, ListingReader};
use super::writer::Writer;
use crate::{ContainerKind, ContainerRef, Operand, Subscript, TextOperand, TextSource};

/// Registers: a letter with a number.
macro_rules! registers {
    ($($form:ident $letter:literal $what:literal;)+) => {
        $(
            #[doc = $what]
            pub(super) struct $form;

            impl ListingForm for $form {
                type Value = u16;

                fn write(value: &u16, to: &mut Writer<'_>) {
                    to.put(&format!("{}{value}", $letter));
                }

                fn read(from: &mut ListingReader<'_>) -> Result<u16> {
                    from.register($letter, $what)
                }
            }
        )+
    };
}

registers! {
    Num 'n' "a number of the frame, such as `n0`,";
    Place 'p' "a place of the frame, such as `p0`,";
    View 'v' "a container by reference, such as `v0`,";
    Part 'c' "a container of the frame, such as `c0`,";
}

/// Target of a jump.
pub(super) struct JumpOperand;

impl ListingForm for JumpOperand {
    type Value = u32;

    fn write(value: &u32, to: &mut Writer<'_>) {
        to.put(&format!("L{value}"));
    }

    fn read(from: &mut ListingReader<'_>) -> Result<u32> {
        let name = from.name()?;
        let used = from.last();
        Ok(number(&mut from.labels, Label { name, used, target: None }))
    }
}

/// Returns the number of a name that may be declared later.
pub(super) fn number(labels: &mut Vec<Label>, label: Label) -> u32 {
    let known = labels.iter().position(|known| known.name == label.name);
    let number = known.unwrap_or(labels.len());
    if known.is_none() {
        labels.push(label);
    }
    u32::try_from(number).unwrap_or(u32::MAX)
}

impl ListingForm for NumberFunction {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        to.put(&format!("{value:?}"));
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let name = from.take();
        let found = (0..).map_while(Self::numbered).find(|function| format!("{function:?}") == name);
        found.map_or_else(|| from.fail(&format!("`{name}` is no function of numbers")), Ok)
    }
}

impl ListingForm for ContainerRef {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value.kind() {
            ContainerKind::Data(number) => {
                to.put("$");
                let image = to.image;
                to.item(image.data.iter().map(|data| data.name.as_str()), number.into());
            }
            ContainerKind::Part(number) => Part::write(&number, to),
            ContainerKind::View(number) => View::write(&number, to),
            ContainerKind::Import(number) => to.put(&format!("i{number}")),
            ContainerKind::Builtin(0) => to.put(WORLD),
            ContainerKind::Builtin(_) => to.put(FLANGE),
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let kind = match from.peek() {
            "$" => {
                from.take();
                let data = |from: &ListingReader<'_>| from.image.data.iter().map(|data| data.name.clone()).collect();
                ContainerKind::Data(from.item("global data", data)?)
            }
            WORLD | FLANGE => ContainerKind::Builtin(u16::from(from.take() == FLANGE)),
            _ if from.is_register("c") => ContainerKind::Part(Part::read(from)?),
            _ if from.is_register("v") => ContainerKind::View(View::read(from)?),
            _ if from.is_register("i") => ContainerKind::Import(from.register('i', "an import")?),
            _ => return from.unexpected("a container, such as `$nData`, `c0`, `v0` or `i0`,"),
        };
        Self::new(kind).map_or_else(|| from.fail(TOO_HIGH), Ok)
    }
}

/// Name of the built-in frame.
pub(super) const WORLD: &str = "world";
/// Name of the built-in tool.
pub(super) const FLANGE: &str = "flange";
const TOO_HIGH: &str = "the highest possible number here is 8191";

impl ListingForm for TextOperand {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value.source() {
            TextSource::Register(number) => to.put(&format!("t{number}")),
            TextSource::Place(number) => Place::write(&number, to),
            TextSource::Constant(number) => constant(number, to),
            TextSource::First(kind) => match ContainerRef::new(kind) {
                Some(container) => ContainerRef::write(&container, to),
                None => to.put("?"),
            },
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let source = match from.peek() {
            "#" => {
                from.take();
                TextSource::Constant(from.number()?)
            }
            token if token.starts_with('"') => TextSource::Constant(new_constant(from)?),
            _ if from.is_register("t") => TextSource::Register(from.register('t', "a text")?),
            _ if from.is_register("p") => TextSource::Place(Place::read(from)?),
            _ => TextSource::First(ContainerRef::read(from)?.kind()),
        };
        Self::new(source).map_or_else(|| from.fail(TOO_HIGH), Ok)
    }
}

/// Writes a constant as its text, if it is the first constant with this text, otherwise as its number.
fn constant(number: u16, to: &mut Writer<'_>) {
    if !to.constants.contains(&number) {
        to.constants.push(number);
    }
    let texts = to.code.map(|code| code.texts.as_slice()).unwrap_or_default();
    let text = texts.get(usize::from(number));
    match text.filter(|text| texts.iter().position(|other| other == *text) == Some(number.into())) {
        Some(text) => to.quoted(text),
        None => to.put(&format!("#{number}")),
    }
}

fn new_constant(from: &mut ListingReader<'_>) -> Result<u16> {
    let text = text(from)?;
    let known = from.code.texts.iter().position(|known| *known == text);
    let number = known.unwrap_or(from.code.texts.len());
    if known.is_none() {
        from.code.texts.push(text);
    }
    Ok(u16::try_from(number).unwrap_or(u16::MAX))
}

/// Reads a VAL 3 string, which has at most 128 bytes.
pub(super) fn text(from: &mut ListingReader<'_>) -> Result<Text> {
    let written = from.quoted()?;
    let text = Text::from(written.as_str());
    if text.as_str() == written { Ok(text) } else { from.fail("this text has more than 128 bytes") }
}

/// Writes the lanes of a value with this size, with a letter for the kind of each lane.
fn write_lanes(lanes: Lanes, size: Lanes, to: &mut Writer<'_>) {
    let Lanes { num, text, link, part } = lanes;
    let sorts = [('n', num, size.num), ('t', text, size.text), ('l', link, size.link), ('c', part, size.part)];
    let shown = sorts.into_iter().filter(|(_, at, size)| *at + *size > 0).map(|(letter, at, _)| (letter, at));
    let shown: Vec<_> = shown.collect();
    write_numbers(if shown.is_empty() { &[('n', 0)] } else { &shown }, to);
}

/// Writes numbers with their letters: `n3/l1`.
pub(super) fn write_numbers(numbers: &[(char, u32)], to: &mut Writer<'_>) {
    to.list(numbers, "/", |(letter, number), to| to.put(&format!("{letter}{number}")));
}

pub(super) fn read_lanes(from: &mut ListingReader<'_>) -> Result<Lanes> {
    let [num, text, link, part] = read_numbers(['n', 't', 'l', 'c'], from)?;
    Ok(Lanes { num, text, link, part })
}

/// Reads numbers and returns them in the order of these letters; 0 for an omitted letter.
pub(super) fn read_numbers<const N: usize>(letters: [char; N], from: &mut ListingReader<'_>) -> Result<[u32; N]> {
    let mut numbers = [0; N];
    loop {
        let token = from.take();
        let slot = letters.iter().zip(&mut numbers).find(|(letter, _)| token.starts_with(**letter));
        let number = token.get(1..).and_then(|rest| rest.parse::<u16>().ok());
        let (Some((_, slot)), Some(number)) = (slot, number) else {
            return from.fail("numbers from 0 to 65535 with letters, such as `n0/t0`, are expected here");
        };
        *slot = number.into();
        if !from.accept("/") {
            return Ok(numbers);
        }
    }
}

/// Writes the location of a value with this size.
pub(super) fn write_operand(operand: Operand, size: Lanes, to: &mut Writer<'_>) {
    let offset = match operand {
        Operand::Frame(lanes) => return write_lanes(lanes, size, to),
        Operand::First(container, offset) => {
            ContainerRef::write(&container, to);
            offset
        }
        Operand::Place(place, offset) => {
            Place::write(&place, to);
            offset
        }
    };
    if offset != Lanes::default() {
        to.put("+");
        write_lanes(offset, Lanes::default(), to);
    }
}

impl ListingForm for Operand {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        write_operand(*value, Lanes::default(), to);
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        if from.is_register("ntl") {
            return read_lanes(from).map(Self::Frame);
        }
        let place = if from.is_register("p") { Ok(Place::read(from)?) } else { Err(ContainerRef::read(from)?) };
        let offset = if from.accept("+") { read_lanes(from)? } else { Lanes::default() };
        Ok(place.map_or_else(|container| Self::First(container, offset), |place| Self::Place(place, offset)))
    }
}

impl ListingForm for Subscript {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        let numbers = match value {
            Self::Whole => return,
            Self::One(i) => std::slice::from_ref(i),
            Self::Two(numbers) => numbers,
            Self::Three(numbers) => numbers,
            Self::Key(key) => {
                to.put("[");
                TextOperand::write(key, to);
                return to.put("]");
            }
        };
        to.put("[");
        to.list(numbers, ", ", Num::write);
        to.put("]");
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        if !from.accept("[") {
            return Ok(Self::Whole);
        }
        if !from.is_register("n") {
            let key = TextOperand::read(from)?;
            return from.expect("]").map(|()| Self::Key(key));
        }
        match *from.list(",", "]", Num::read)? {
            [i] => Ok(Self::One(i)),
            [i, j] => Ok(Self::Two([i, j])),
            [i, j, k] => Ok(Self::Three([i, j, k])),
            _ => from.fail("one to three indexes are expected here"),
        }
    }
}

//! What the interpreter's memory and that of machine code exchange: numbers there, and back again.

use rustc_hash::FxHashMap;
use val3_bytecode::{Image, Passing, Program, WholeKind};
use val3_lang::memory::{Lanes, Memory, Place, Shape, Store, StoreId, View};
use val3_vm::{Base, Frame, Imported, Instance};

use crate::containers::{Shared, Width, by_reference, local};
use crate::layout::{ADDRESS, COLUMNS, CONTAINER, COUNT, END, NUMBERS, PLACES, ROWS, SIZE, VALUES};

/// The containers whose numbers were copied.
#[derive(Debug)]
pub(crate) struct Exchange {
    known: FxHashMap<StoreId, Copied>,
    /// The first address that is free.
    free: u32,
    /// How many numbers may still be copied: more would take longer than the interpreter.
    credit: usize,
}

/// The numbers of a container in the memory of machine code.
#[derive(Debug, Clone, Copy)]
struct Copied {
    /// The address of the first.
    address: u32,
    count: u32,
    width: Width,
}

impl Exchange {
    pub(crate) fn new(credit: usize) -> Self {
        Self { known: FxHashMap::default(), free: VALUES, credit }
    }

    /// Copies the numbers of all frames, of which `end` are in use.
    pub(crate) fn give_stack(bytes: &mut [u8], memory: &Memory, end: usize) -> Option<()> {
        write_numbers(bytes, NUMBERS, memory.stack.nums.get(..end)?)
    }

    /// Copies them back, with what was changed in containers.
    pub(crate) fn take_back(&self, bytes: &[u8], memory: &mut Memory, end: usize) -> Option<()> {
        read_numbers(bytes, NUMBERS, memory.stack.nums.get_mut(..end)?)?;
        for (id, Copied { address, width, .. }) in &self.known {
            let store = memory.stores.get_mut(*id).ok()?;
            match width {
                Width::Byte => read_truths(bytes, *address, &mut store.nums)?,
                Width::Eight => read_numbers(bytes, *address, &mut store.nums)?,
            }
        }
        Some(())
    }

    /// Copies the numbers of a container, if they are not there; `None` if there is no room for them.
    fn numbers(&mut self, bytes: &mut [u8], memory: &Memory, id: StoreId) -> Option<Copied> {
        if let Some(known) = self.known.get(&id) {
            return Some(*known);
        }
        let Store { nums, kind, .. } = memory.stores.get(id).ok()?;
        let width = Width::of(kind);
        self.credit = self.credit.checked_sub(nums.len())?;
        let count = u32::try_from(nums.len()).ok()?;
        let size = count.checked_mul(1 << width.shift())?.checked_next_multiple_of(8)?;
        let end = size.checked_add(self.free).filter(|end| *end <= END)?;
        let address = std::mem::replace(&mut self.free, end);
        match width {
            Width::Byte => write_truths(bytes, address, nums)?,
            Width::Eight => write_numbers(bytes, address, nums)?,
        }
        let copied = Copied { address, count, width };
        self.known.insert(id, copied);
        Some(copied)
    }

    /// Describes the containers that all programs of a module share.
    pub(crate) fn describe_shared(
        &mut self,
        bytes: &mut [u8],
        memory: &Memory,
        shared: &Shared,
        instance: &Instance,
    ) -> Option<()> {
        for (whole, at) in shared.iter() {
            let view = match whole.kind() {
                WholeKind::Data(number) => instance.data.get(usize::from(number)).copied().map(View::whole),
                WholeKind::Import(number) => match instance.imports.get(usize::from(number)) {
                    Some(Some(Imported::Data(store))) => Some(View::whole(*store)),
                    _ => None,
                },
                _ => None,
            };
            self.describe(bytes, memory, view, at)?;
        }
        Some(())
    }

    /// Describes containers and places of the frame that is entered.
    pub(crate) fn describe_own(
        &mut self,
        bytes: &mut [u8],
        memory: &Memory,
        (program, image): (&Program, &Image),
        base: &Base,
    ) -> Option<()> {
        let (parts, views) = (program.frame.lanes.part as usize, program.frame.views as usize);
        let stack = &memory.stack;
        let is_declared = |view: &View, whole| {
            let declared = Width::declared(whole, program, image);
            memory.stores.get(view.store).is_ok_and(|store| Width::of(&store.kind) == declared)
        };
        for (number, id) in (0..).zip(stack.parts.iter().skip(base.part as usize).take(parts)) {
            if let Some(at) = local(number) {
                let view = Some(View::whole(*id)).filter(|view| is_declared(view, WholeKind::Part(number)));
                self.describe(bytes, memory, view, at)?;
            }
        }
        for (number, view) in (0..).zip(stack.views.iter().skip(base.view as usize).take(views)) {
            if let Some(at) = by_reference(number) {
                let view = Some(*view).filter(|view| is_declared(view, WholeKind::View(number)));
                self.describe(bytes, memory, view, at)?;
            }
        }
        for (number, place) in
            (base.place..base.place + program.frame.places).zip(stack.places.iter().skip(base.place as usize))
        {
            let address = self.address(bytes, memory, *place).unwrap_or_default();
            write(bytes, PLACES + number * 4, &address.to_le_bytes())?;
        }
        Some(())
    }

    /// Describes one container; none has no values.
    fn describe(&mut self, bytes: &mut [u8], memory: &Memory, view: Option<View>, at: u32) -> Option<()> {
        let description =
            view.and_then(|view| self.description(bytes, memory, view)).unwrap_or([0; CONTAINER as usize]);
        write(bytes, at, &description)
    }

    fn description(&mut self, bytes: &mut [u8], memory: &Memory, view: View) -> Option<[u8; CONTAINER as usize]> {
        let store = memory.stores.get(view.store).ok()?;
        let Copied { address, count, width } = self.numbers(bytes, memory, view.store)?;
        let skipped = view.start * store.kind.size.num;
        let left = count.saturating_sub(skipped);
        let is_of_numbers = store.kind.size == Lanes::nums(1);
        let (size, rows, columns) = match store.shape {
            Shape::Array { dims: 1, .. } if is_of_numbers => (left, 0, 0),
            Shape::Array { dims: 2, sizes: [rows, columns, _] } if is_of_numbers => (0, rows, columns),
            _ => (0, 0, 0),
        };
        let mut description = [0; CONTAINER as usize];
        let address = address + (skipped << width.shift());
        for (at, number) in [(ADDRESS, address), (COUNT, left), (SIZE, size), (ROWS, rows), (COLUMNS, columns)] {
            write(&mut description, at, &number.to_le_bytes())?;
        }
        Some(description)
    }

    /// The address of the first number of a place; none for a truth value in a container.
    fn address(&mut self, bytes: &mut [u8], memory: &Memory, place: Place) -> Option<u32> {
        if place.store == StoreId::STACK {
            return Some(NUMBERS + place.num * 8);
        }
        memory.stores.get(place.store).ok().filter(|store| Width::of(&store.kind) == Width::Eight)?;
        let Copied { address, count, .. } = self.numbers(bytes, memory, place.store)?;
        // The value may have left its container.
        (place.num < count).then(|| address + place.num * 8)
    }

    /// The place behind an address.
    fn place(&self, address: u32) -> Option<Place> {
        if address < VALUES {
            return Some(Place::on_stack(Lanes::nums(address.checked_sub(NUMBERS)? / 8)));
        }
        let holds = |copied: &Copied| {
            copied.width == Width::Eight && (copied.address..copied.address + copied.count * 8).contains(&address)
        };
        let (id, copied) = self.known.iter().find(|(_, copied)| holds(copied))?;
        Some(Place::new(*id, Lanes::nums((address - copied.address) / 8)))
    }

    /// What places of a frame refer to, by their numbers, where machine code has written them.
    pub(crate) fn take_references(
        &self,
        bytes: &[u8],
        memory: &mut Memory,
        frame: &Frame,
        places: impl Iterator<Item = u32>,
    ) {
        for number in places.map(|place| frame.base.place + place) {
            let place = read(bytes, PLACES + number * 4).and_then(|address| self.place(u32::from_le_bytes(address)));
            if let Some((slot, place)) = memory.stack.places.get_mut(number as usize).zip(place) {
                *slot = place;
            }
        }
    }
}

/// The places that the parameters by reference of a program have.
pub(crate) fn references(program: &Program) -> impl Iterator<Item = u32> {
    program.params.iter().filter_map(|param| match param.passing {
        Passing::Reference(number) => Some(number),
        _ => None,
    })
}

/// Writes numbers, one behind the other.
fn write_numbers(bytes: &mut [u8], at: u32, numbers: &[f64]) -> Option<()> {
    let (slots, _) = bytes.get_mut(at as usize..)?.as_chunks_mut::<8>();
    let slots = slots.get_mut(..numbers.len())?;
    slots.iter_mut().zip(numbers).for_each(|(slot, number)| *slot = number.to_le_bytes());
    Some(())
}

/// Reads as many numbers as there are.
fn read_numbers(bytes: &[u8], at: u32, numbers: &mut [f64]) -> Option<()> {
    let (slots, _) = bytes.get(at as usize..)?.as_chunks::<8>();
    let slots = slots.get(..numbers.len())?;
    numbers.iter_mut().zip(slots).for_each(|(number, slot)| *number = f64::from_le_bytes(*slot));
    Some(())
}

/// Writes truth values, a byte each.
fn write_truths(bytes: &mut [u8], at: u32, numbers: &[f64]) -> Option<()> {
    let slots = bytes.get_mut(at as usize..)?.get_mut(..numbers.len())?;
    slots.iter_mut().zip(numbers).for_each(|(slot, number)| *slot = u8::from(*number != 0.0));
    Some(())
}

/// Reads as many truth values as there are.
fn read_truths(bytes: &[u8], at: u32, numbers: &mut [f64]) -> Option<()> {
    let slots = bytes.get(at as usize..)?.get(..numbers.len())?;
    numbers.iter_mut().zip(slots).for_each(|(number, slot)| *number = f64::from(*slot));
    Some(())
}

/// Writes bytes; `None` beyond the end.
pub(crate) fn write(bytes: &mut [u8], at: u32, value: &[u8]) -> Option<()> {
    bytes.get_mut(at as usize..)?.get_mut(..value.len())?.copy_from_slice(value);
    Some(())
}

/// Reads bytes; `None` beyond the end.
pub(crate) fn read<const N: usize>(bytes: &[u8], at: u32) -> Option<[u8; N]> {
    bytes.get(at as usize..)?.first_chunk().copied()
}

//! Values at the addresses, which the run and the clients exchange.

use crate::{ModbusMap, TableKind, Writer};

/// Values of both tables.
///
/// A client reads its own writes immediately. The run receives them with [`take_writes`](Self::take_writes), and publishes
/// its values with [`publish`](Self::publish).
#[derive(Debug, Clone)]
pub struct ModbusImage {
    bits: Vec<Cell>,
    words: Vec<Cell>,
    /// First write to a value of the robot.
    discarded: Option<(TableKind, u16)>,
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    value: u16,
    /// Side that writes the value; `None` at an address without an item, which has the value 0.
    writer: Option<Writer>,
    /// Whether a client has written the value since the last exchange.
    is_new: bool,
}

/// Value that clients have written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Write {
    /// Table of the address.
    pub table: TableKind,
    /// Address, from 0.
    pub address: u16,
    /// Value; 0 or 1 for a bit.
    pub value: u16,
}

/// Addresses beyond a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct BeyondTable;

impl ModbusImage {
    /// Creates values of 0 for all addresses.
    #[must_use]
    pub fn new(map: &ModbusMap) -> Self {
        let [bits, words] = TableKind::ALL.map(|table| {
            let writers = map.table(table).iter().map(|element| element.as_ref().map(|element| element.writer));
            writers.map(|writer| Cell { value: 0, writer, is_new: false }).collect()
        });
        Self { bits, words, discarded: None }
    }

    fn cells(&mut self, table: TableKind) -> &mut [Cell] {
        match table {
            TableKind::Bits => &mut self.bits,
            TableKind::Words => &mut self.words,
        }
    }

    /// Returns the cells of consecutive addresses.
    fn range(&mut self, table: TableKind, first: u16, count: usize) -> Result<&mut [Cell], BeyondTable> {
        let first = usize::from(first);
        self.cells(table).get_mut(first..first + count).ok_or(BeyondTable)
    }

    /// Reads the values of consecutive addresses.
    pub(crate) fn read(&mut self, table: TableKind, first: u16, count: u16) -> Result<Vec<u16>, BeyondTable> {
        let cells = self.range(table, first, usize::from(count))?;
        Ok(cells.iter().map(|cell| cell.value).collect())
    }

    /// Writes the values of consecutive addresses, as a client. Values of the robot keep their value, because clients
    /// write blocks across the border between both sides. No value is written if an address is beyond the table.
    pub(crate) fn write(&mut self, table: TableKind, first: u16, values: &[u16]) -> Result<(), BeyondTable> {
        let mut discarded = None;
        let cells = self.range(table, first, values.len())?;
        for ((cell, value), address) in cells.iter_mut().zip(values).zip(first..) {
            match cell.writer {
                Some(Writer::Client) => (cell.value, cell.is_new) = (*value, true),
                Some(Writer::Robot) if cell.value != *value => discarded = discarded.or(Some((table, address))),
                Some(Writer::Robot) | None => {}
            }
        }
        self.discarded = self.discarded.or(discarded);
        Ok(())
    }

    /// Removes and returns the values that clients have written since the last call.
    pub fn take_writes(&mut self) -> Vec<Write> {
        TableKind::ALL.into_iter().flat_map(|table| taken(self.cells(table), table)).collect()
    }

    /// Sets the value at an address, as the run. A value that a client has written in the meantime stays.
    pub fn publish(&mut self, table: TableKind, address: u16, value: u16) {
        if let Some(cell) = self.cells(table).get_mut(usize::from(address)).filter(|cell| !cell.is_new) {
            cell.value = value;
        }
    }

    /// Address of the first write that would have changed a value of the robot.
    #[must_use]
    pub const fn discarded(&self) -> Option<(TableKind, u16)> {
        self.discarded
    }
}

/// Removes and returns the new values of a table.
fn taken(cells: &mut [Cell], table: TableKind) -> Vec<Write> {
    let new = cells.iter_mut().zip(0..=u16::MAX).filter(|(cell, _)| cell.is_new);
    new.map(|(cell, address)| {
        cell.is_new = false;
        Write { table, address, value: cell.value }
    })
    .collect()
}

#[cfg(test)]
pub(crate) mod tests;

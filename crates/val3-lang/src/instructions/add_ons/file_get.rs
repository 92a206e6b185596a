//! `$fileGet`: reads lines or bytes from an open file.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;
use crate::values::numbers::round;

instruction! {
    /// Reads lines or bytes from an open file.
    ///
    /// - `nFile`: the number that `$fileOpen` returned.
    /// - `sLines`, `nBytes`: receive the lines or the bytes, each 0 to 255. A line longer than a string continues in
    ///   the next value.
    /// - `nCount`: the number of lines or bytes to read.
    /// - Result: the number of lines or bytes read; fewer at the end of the file.
    ///
    /// ## Example
    /// ```val3
    /// num nFile
    /// string sLine[1]
    ///   nFile=$fileOpen("Disk://data/order.txt","r")
    ///   while $fileGet(nFile,sLine,1)==1
    ///     putln(sLine[0])
    ///   endWhile
    ///   $fileClose(nFile)
    /// ```
    "$fileGet": AddOns, with_add_on "Expansion";
    modifier (num nFile, string& sLines[], num nCount) -> num = lines;
    modifier (num nFile, num& nBytes[], num nCount) -> num = bytes;
}

fn lines(call: &mut Call<'_>, file: f64, lines: Arr<Text>, count: f64) -> Result<f64> {
    let most = at_most(count, lines.len(call)?);
    let read = call.ports.read_lines(file, most);
    for (index, line) in read.iter().enumerate() {
        lines.set(call, index, Text::from(line.as_str()))?;
    }
    Ok(read.len() as f64)
}

fn bytes(call: &mut Call<'_>, file: f64, bytes: Arr<f64>, count: f64) -> Result<f64> {
    let most = at_most(count, bytes.len(call)?);
    let read = call.ports.read_bytes(file, most);
    for (index, byte) in read.iter().enumerate() {
        bytes.set(call, index, f64::from(*byte))?;
    }
    Ok(read.len() as f64)
}

/// Limits a requested count to the array size; a larger count is no error.
pub(super) fn at_most(count: f64, len: usize) -> usize {
    // The cast saturates, and converts NaN to 0.
    len.min(round(count) as usize)
}

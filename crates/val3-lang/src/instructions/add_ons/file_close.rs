//! `$fileClose`: closes a file.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Closes a file.
    ///
    /// - `nFile`: the number that `$fileOpen` returned.
    /// - Result: (s8) a number that shows whether the file was closed; up to s7, there is no result.
    ///
    /// ## Example
    /// ```val3
    /// num nFile
    ///   nFile=$fileOpen("Disk://data/order.txt","r")
    ///   if nFile>=0
    ///     $fileClose(nFile)
    ///   endIf
    /// ```
    "$fileClose": AddOns, with_add_on "Expansion";
    modifier (num nFile) -> num = close;
}

fn close(call: &mut Call<'_>, file: f64) -> f64 {
    let closed = call.ports.close_file(file);
    if closed { 0.0 } else { -1.0 }
}
